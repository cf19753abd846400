"""Renders views of the demo scene through Eye Render, as EXR and PNG. Runs inside Blender:

blender -b --factory-startup --addons eye_render hall.blend --python render_views.py -- \
    FOLDER SAMPLES SPHERE_D...
"""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tools.picture import render_picture  # noqa: E402

PUPIL_MM = 4.0


def main(folder: str, samples: str, *spheres_d: str) -> None:
    scene = bpy.context.scene
    scene.render.engine = "EYE_RENDER"
    scene.eye_render.quality = "CUSTOM"
    scene.eye_render.samples = int(samples)
    observer = scene.camera.data.eye_render
    observer.pupil_mode, observer.pupil_mm = "MANUAL", PUPIL_MM
    observer.focus_mode = "RELAXED"
    for sphere_d in spheres_d:
        observer.right.text = f"{sphere_d}DS"
        print(f"View {sphere_d}", flush=True)
        render_picture(Path(folder) / f"demo_{sphere_d}DS.exr")


main(*sys.argv[sys.argv.index("--") + 1 :])
