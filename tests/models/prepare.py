"""Loads one file into Blender and makes it ready to be rendered small; Blender's own options then
render it. Arguments after `--`: the file, and the record of how far this came.

The record is JSON. Its `stage` is "importing" until the file is loaded, then "refused" if the
importer would not have it, else "rendering".
"""

import json
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
import framing  # noqa: E402
import importers  # noqa: E402

SIZE_PX = 64
SAMPLES = 4


def main() -> None:
    path, record_path = map(Path, sys.argv[sys.argv.index("--") + 1 :][:2])
    record_path.write_text(json.dumps({"stage": "importing"}))
    try:
        importers.load(path)
    except Exception as error:
        record = {"stage": "refused", "why": _reason(error)}
        record_path.write_text(json.dumps(record))
        sys.exit(0)
    scene = bpy.context.scene
    scene.frame_set(1)
    _choose_output(scene)
    triangles, corners = framing.geometry()
    framing.add_light(scene)
    seen, distance = framing.choose_camera(scene, corners)
    # The unit puts what is seen before the far point, whatever the file is measured in.
    scene.unit_settings.system = "METRIC"
    scene.unit_settings.scale_length = framing.VIEWING_DISTANCE_M / distance
    record = {"stage": "rendering", "triangles": triangles, "seen": seen}
    record_path.write_text(json.dumps(record))


def _reason(error: Exception) -> str:
    """The line that says it, of an operator's error that holds a traceback."""
    lines = [line for line in str(error).splitlines() if line and not line.startswith(" ")]
    lines = [line for line in lines if not line.startswith(("Location:", "Traceback"))]
    return lines[-1] if lines else type(error).__name__


def _choose_output(scene: bpy.types.Scene) -> None:
    render = scene.render
    render.resolution_x = render.resolution_y = SIZE_PX
    render.resolution_percentage = 100
    render.pixel_aspect_x = render.pixel_aspect_y = 1.0
    render.use_border = render.use_multiview = False
    render.use_compositing = render.use_sequencer = False
    render.film_transparent = True
    scene.eye_render.quality = "CUSTOM"
    scene.eye_render.samples = SAMPLES
    for view_layer in scene.view_layers:
        view_layer.use_pass_z = view_layer.use_pass_normal = True
        switches = view_layer.eye_render
        view_layer.cycles.denoising_store_passes = switches.use_pass_defocus = (
            switches.use_pass_blur
        ) = True


main()
