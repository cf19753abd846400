"""Motion blur: the picture at frame 1, over one frame."""

import math

import bpy
from features import feature
from stage import (
    add,
    ball,
    diffuse,
    dressed,
    outdoors,
)
from tools.meshes import cube_mesh

PAINT = (0.6, 0.45, 0.3)


def moved(owner: bpy.types.bpy_struct, path: str, before, after) -> None:
    """Linear between frames 0 and 2, with the picture at frame 1 blurred over one frame."""
    for frame, value in ((0, before), (2, after)):
        setattr(owner, path, value)
        owner.keyframe_insert(path, frame=frame)
    for curve in curves_of(owner.id_data.animation_data.action):
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"
    scene = bpy.context.scene
    scene.frame_set(1)
    scene.render.use_motion_blur, scene.render.motion_blur_shutter = True, 1.0


def curves_of(action: bpy.types.Action):
    if hasattr(action, "fcurves"):
        return action.fcurves
    return action.layers[0].strips[0].channelbags[0].fcurves  # from Blender 5.0


@feature(samples=512)
def of_object():
    """A ball that moves"""
    moved(ball(diffuse(PAINT)), "location", (-0.9, 0, 0.9), (0.9, 0, 0.9))


@feature(samples=512)
def of_turning():
    """A cube that turns by ninety degrees in two frames"""
    shown = _cube()
    moved(shown, "rotation_euler", (0, 0, 0), (0, 0, math.radians(90)))


@feature(samples=512)
def of_camera():
    """A camera that moves"""
    ball(diffuse(PAINT))
    moved(bpy.context.scene.camera, "location", (-0.5, -5, 2.0), (0.5, -5, 2.0))


@feature(samples=512)
def of_deformation():
    """A mesh that a shape key deforms"""
    shown = ball(diffuse(PAINT))
    shown.shape_key_add(name="Basis")
    wide = shown.shape_key_add(name="Wide")
    for vertex, point in zip(shown.data.vertices, wide.data, strict=True):
        point.co = (vertex.co.x * 1.8, vertex.co.y, vertex.co.z * 0.6)
    moved(wide, "value", 0.0, 1.0)


def _cube() -> bpy.types.Object:
    outdoors()
    return add(dressed(cube_mesh(1.2), diffuse(PAINT)), (0, 0, 0.6))
