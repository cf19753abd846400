"""Saves a scene of which there is much. Inside Blender:

blender -b --factory-startup --python make_large_scene.py -- triangles|instances FILE.blend
"""

import math
import sys

import bpy
import numpy as np

SHEET_CELLS = 708  # a side: 2 * 708^2 triangles
FIELD_VERTICES = 317  # a side: 317^2 instances


def wavy_sheet(cells: int, size: float) -> bpy.types.Object:
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=cells, y_subdivisions=cells, size=size)
    sheet = bpy.context.object
    points = np.empty((len(sheet.data.vertices), 3), np.float32)
    sheet.data.vertices.foreach_get("co", points.ravel())
    points[:, 2] = 0.1 * np.sin(5.0 * points[:, 0]) * np.cos(7.0 * points[:, 1])
    sheet.data.vertices.foreach_set("co", points.ravel())
    sheet.data.update()
    return sheet


def triangles() -> None:
    sheet = wavy_sheet(SHEET_CELLS, 4.0)
    bpy.ops.object.shade_smooth()
    sheet.data.materials.append(bpy.data.materials.new("Sheet"))


def instances() -> None:
    """A field of balls, one on each vertex of a sheet."""
    field = wavy_sheet(FIELD_VERTICES - 1, 4.0)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=54, ring_count=47, radius=0.004)
    ball = bpy.context.object
    ball.data.materials.append(bpy.data.materials.new("Ball"))
    ball.parent = field
    field.instance_type = "VERTS"
    field.show_instancer_for_render = False


def stand_and_light() -> None:
    scene = bpy.context.scene
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location, camera.rotation_euler = (0.0, -5.0, 4.0), (math.radians(52), 0.0, 0.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    lamp = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    lamp.rotation_euler = (math.radians(40), 0.0, math.radians(30))
    scene.collection.objects.link(lamp)


def main(name: str, path: str) -> None:
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    {"triangles": triangles, "instances": instances}[name]()
    for material in bpy.data.materials:
        material.use_nodes = True
    stand_and_light()
    bpy.ops.wm.save_as_mainfile(filepath=path, check_existing=False)


main(*sys.argv[-2:])
