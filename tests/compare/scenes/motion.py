"""Motion blur: the picture at frame 1, over one frame."""

import math

import bpy
from animation import moved
from features import feature
from stage import (
    BALL_CENTRE,
    add,
    ball,
    ball_mesh,
    camera,
    diffuse,
    dressed,
    floor,
    glow,
    grid_mesh,
    outdoors,
    world,
)
from tools.meshes import cube_mesh

PAINT = (0.6, 0.45, 0.3)


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


@feature(samples=512)
def of_shining_mesh():
    """A shining sheet that moves over a ball by night, and is not seen itself"""
    camera()
    floor()
    world((0.02, 0.02, 0.03))
    add(dressed(ball_mesh(), diffuse(PAINT)), BALL_CENTRE)
    sheet = add(dressed(grid_mesh(1, 1, (0.5, 0.5)), glow((1.0, 0.9, 0.8), 15.0)))
    sheet.visible_camera = False
    moved(sheet, "location", (-2.0, -0.5, 2.4), (2.0, -0.5, 2.4))


@feature(samples=512)
def shutter_curve():
    """A shutter that opens at once and closes slowly"""
    moved(ball(diffuse(PAINT)), "location", (-0.9, 0, 0.9), (0.9, 0, 0.9))
    curve = bpy.context.scene.render.motion_blur_shutter_curve
    curve.initialize()
    for point, place in zip(curve.curves[0].points, ((0.0, 1.0), (1.0, 0.0)), strict=False):
        point.location = place
        point.handle_type = "VECTOR"
    curve.update()


@feature(samples=512)
def shutter_from_the_frame():
    """A shutter that opens when the frame begins"""
    moved(ball(diffuse(PAINT)), "location", (-0.9, 0, 0.9), (0.9, 0, 0.9))
    scene = bpy.context.scene
    owner = scene.render if hasattr(scene.render, "motion_blur_position") else scene.cycles
    owner.motion_blur_position = "START"
