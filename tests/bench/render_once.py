"""Renders the open file by one engine, set up so that two engines should agree. Inside Blender:

blender -b --factory-startup --addons eye_render FILE.blend --python render_once.py -- JSON

JSON: {"engine", "blur", "samples", "bounces", "size", "seed", "exr"}
"""

import json
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tools.engines import SET_UP, filter_as_usual, keep_all_light  # noqa: E402

PUPIL_MM, FOCUS_M = 4.0, 0.5


def set_up_lens(camera, engine: str, blur: bool) -> None:
    """Either a pinhole, or an emmetrope's pupil focused at FOCUS_M and the thin lens like it."""
    lens = camera.dof
    lens.use_dof, lens.focus_distance = blur, FOCUS_M
    lens.aperture_fstop = camera.lens / PUPIL_MM
    if engine == "EYE_RENDER":
        observer = camera.eye_render
        observer.model = "PARAXIAL" if blur else "PINHOLE"
        observer.pupil_mode, observer.pupil_mm = "MANUAL", PUPIL_MM
        observer.focus_mode = "DISTANCE"


def main(job: dict) -> None:
    scene = bpy.context.scene
    keep_all_light(scene)
    filter_as_usual(scene)
    SET_UP[job["engine"]](scene, job["samples"], job["bounces"], job["seed"])
    set_up_lens(scene.camera.data, job["engine"], job["blur"])
    scene.render.resolution_x = scene.render.resolution_y = job["size"]
    image = scene.render.image_settings
    image.file_format, image.color_mode, image.color_depth = "OPEN_EXR", "RGB", "32"
    scene.render.filepath = job["exr"]
    bpy.ops.render.render(write_still=True)


main(json.loads(sys.argv[sys.argv.index("--") + 1]))
