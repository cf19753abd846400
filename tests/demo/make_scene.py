"""Builds the demo scene and saves it. Runs inside Blender 3.4 to 5.2:

blender -b --factory-startup --python make_scene.py -- FILE.blend principled|basic
"""

import math
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

from hall import building, charts, light, things
from hall.materials import Materials

LENS_MM = 40.0


def main(path: str, variant: str) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    materials = Materials(variant)
    building.build(materials)
    charts.build(materials)
    things.build(materials)
    light.build()
    place_camera()
    leave_no_light_out()
    set_output()
    bpy.ops.wm.save_as_mainfile(filepath=path, compress=True)


def place_camera() -> None:
    data = bpy.data.cameras.new("eye")
    data.lens, data.sensor_width = LENS_MM, 36.0
    data.clip_start, data.clip_end = 0.01, 200.0
    camera = bpy.data.objects.new("eye", data)
    camera.location = (0, 0, charts.EYE_HEIGHT_M)
    camera.rotation_euler = (math.pi / 2, 0, 0)
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def leave_no_light_out() -> None:
    """Switch off what Cycles' defaults cut from the paths of light, for both engines."""
    cycles = bpy.context.scene.cycles
    cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = 1024
    cycles.transparent_max_bounces = 1024
    cycles.sample_clamp_indirect = cycles.blur_glossy = 0.0


def set_output() -> None:
    scene = bpy.context.scene
    scene.render.resolution_x = scene.render.resolution_y = 512
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.view_settings.view_transform = "Filmic"
    scene.view_settings.look = "None"
    scene.view_settings.exposure = 0.0


if __name__ == "__main__":
    main(*sys.argv[sys.argv.index("--") + 1 :])
