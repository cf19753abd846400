"""Who sees whose light: links, and what hides a light from kinds of rays."""

import bpy
from features import feature
from stage import (
    BALL_CENTRE,
    DIM,
    add,
    ball_mesh,
    by_night,
    camera,
    diffuse,
    dressed,
    floor,
    glow,
    grid_mesh,
    lamp,
    lit_by,
    shader,
    world,
)


def linked_to(shown: bpy.types.Object, kind: str, linked: bpy.types.Object, state: str) -> None:
    collection = bpy.data.collections.new(kind)
    collection.objects.link(linked)
    collection.collection_objects[0].light_linking.link_state = state
    setattr(shown.light_linking, kind, collection)


@feature(since=(4, 0))
def linked_receivers():
    """A red lamp lights the left ball alone, a blue one and a shining square all but it"""
    camera()
    floor()
    world(DIM)
    balls = [add(dressed(ball_mesh(0.6), diffuse()), (x, 0, 0.6), "Ball") for x in (-0.7, 0.7)]
    red = lamp("AREA", 120.0, (-2.0, -2.0, 3.0), size=1.0, color=(1.0, 0.4, 0.3))
    linked_to(red, "receiver_collection", balls[0], "INCLUDE")
    blue = lamp("POINT", 150.0, (2.0, -2.0, 3.0), shadow_soft_size=0.2, color=(0.4, 0.5, 1.0))
    linked_to(blue, "receiver_collection", balls[0], "EXCLUDE")
    square = add(dressed(grid_mesh(1, 1, (0.8, 0.8)), glow((0.4, 1.0, 0.5), 6.0)), (0, 0.6, 1.9))
    square.rotation_euler = (2.6, 0.0, 0.0)
    linked_to(square, "receiver_collection", balls[0], "EXCLUDE")


@feature(since=(4, 0))
def linked_blockers():
    """Of two balls the one throws the shadows of a lamp, the other those of a sun"""
    camera()
    floor()
    world(DIM)
    balls = [add(dressed(ball_mesh(0.6), diffuse()), (x, 0, 0.6), "Ball") for x in (-0.7, 0.7)]
    near = lamp("AREA", 120.0, (-2.0, -2.0, 3.0), size=0.6, color=(1.0, 0.7, 0.4))
    linked_to(near, "blocker_collection", balls[0], "INCLUDE")
    far = lamp("SUN", 1.5, (2.0, -2.0, 3.0), angle=0.05, color=(0.6, 0.7, 1.0))
    linked_to(far, "blocker_collection", balls[0], "EXCLUDE")


@feature()
def hidden_from_camera():
    """A shining rectangle that the camera does not see"""
    by_night()
    shown = add(dressed(grid_mesh(1, 1, (1.2, 0.8)), glow((1, 0.8, 0.6), 8.0)), (-0.8, -1.2, 1.6))
    shown.rotation_euler = (0.5, 2.5, 0.0)
    shown.visible_camera = False


@feature(bounces=0)
def hidden_from_diffuse():
    """A lamp that only shines on what is glossy"""
    shown = lit_by("AREA", 60.0, shape="SQUARE", size=1.0)
    shown.visible_diffuse = False
    glossy = shader("BsdfAnisotropic", {"Color": (0.8, 0.8, 0.8), "Roughness": 0.4})
    bpy.data.objects["Ball"].data.materials[0] = glossy


def panel(**hidden_from: bool) -> bpy.types.Object:
    """A shining mesh over a rough metal ball and the floor; `hidden_from` as Blender names it."""
    camera()
    floor()
    world(DIM)
    metal = shader("BsdfAnisotropic", {"Color": (0.9, 0.9, 0.9), "Roughness": 0.4})
    add(dressed(ball_mesh(), metal), BALL_CENTRE, "Ball")
    shown = add(dressed(grid_mesh(1, 1, (1.5, 1.5)), glow((1.0, 0.8, 0.6), 12.0)), (-1, -1, 2.6))
    for name, is_hidden in hidden_from.items():
        setattr(shown, f"visible_{name}", not is_hidden)
    return shown


@feature()
def panel_hidden_from_diffuse():
    """A shining mesh that shines on metal alone"""
    panel(diffuse=True)


@feature()
def panel_hidden_from_glossy():
    """A shining mesh that metal does not mirror"""
    panel(glossy=True)
