"""Lamps and shining meshes, on a floor with a ball."""

import math

import bpy
import numpy as np
from features import feature
from mathutils import Euler
from stage import (
    BALL_CENTRE,
    DIM,
    add,
    ball_mesh,
    by_night,
    camera,
    dressed,
    floor,
    glow,
    grid_mesh,
    lamp,
    lit_by,
    new_tree,
    shows,
    world,
)
from tree import Tree, out

COSINE = "before Blender 4.0 a spot is dimmed by the cosine of the angle from its axis"


@feature()
def point():
    """A point lamp of radius 0.3"""
    lit_by("POINT", 250.0, shadow_soft_size=0.3)


@feature()
def point_hard():
    """A point lamp without extent, coloured"""
    lit_by("POINT", 250.0, shadow_soft_size=0.0, color=(1.0, 0.6, 0.3))


@feature(since=(4, 0))
def point_sphere():
    """A point lamp of radius 0.5 that is a sphere"""
    lit_by("POINT", 250.0, shadow_soft_size=0.5, use_soft_falloff=False)


@feature()
def sun():
    """A sun of half a degree"""
    lit_by("SUN", 3.0, angle=math.radians(0.5))


@feature()
def sun_soft():
    """A sun of 30 degrees"""
    lit_by("SUN", 3.0, angle=math.radians(30))


@feature(before_4=COSINE)
def spot():
    """A spot of 45 degrees with a soft edge"""
    lit_by("SPOT", 300.0, spot_size=math.radians(45), spot_blend=0.4, shadow_soft_size=0.1)


@feature(before_4=COSINE)
def spot_hard():
    """A spot of 30 degrees with a hard edge, no extent"""
    lit_by("SPOT", 300.0, spot_size=math.radians(30), spot_blend=0.0, shadow_soft_size=0.0)


@feature(before_4="before Blender 4.0 a spot also ignores the object's scale")
def spot_scaled():
    """A spot that is twice as wide as high"""
    settings = {"spot_size": math.radians(40), "spot_blend": 0.2, "shadow_soft_size": 0.05}
    lit_by("SPOT", 300.0, **settings).scale = (2.0, 1.0, 1.0)


@feature()
def area_square():
    """A square"""
    lit_by("AREA", 60.0, shape="SQUARE", size=1.0)


@feature()
def area_rectangle():
    """A rectangle, turned"""
    shown = lit_by("AREA", 60.0, shape="RECTANGLE", size=2.0, size_y=0.3)
    shown.rotation_euler.rotate(Euler((0, 0, 0.6)))


@feature()
def area_disk():
    """A disk"""
    lit_by("AREA", 60.0, shape="DISK", size=1.2)


@feature()
def area_ellipse():
    """An ellipse, by shape and by the object's scale"""
    lit_by("AREA", 60.0, shape="ELLIPSE", size=1.6, size_y=0.5).scale = (1.0, 1.5, 1.0)


@feature()
def area_spread():
    """A square that spreads by 40 degrees"""
    lit_by("AREA", 12.0, shape="SQUARE", size=0.8, spread=math.radians(40))


IES = """IESNA:LM-63-1995
TILT=NONE
1 1000 1 7 1 1 2 0 0 0
1 1 1
0 10 20 30 45 60 90
0
1200 300 900 200 700 100 0
"""


@feature()
def ies():
    """A point lamp with an IES profile"""
    by_night()
    shown = lamp("POINT", 6.0, (-0.6, -1.0, 2.8), (-0.6, -1.0, 0), shadow_soft_size=0.0)
    text = bpy.data.texts.new("profile.ies")
    text.write(IES)
    shown.data.use_nodes = True
    tree = Tree(shown.data)
    profile = tree.node("TexIES", {"Strength": 1.0}, mode="INTERNAL")
    profile.ies = text
    tree.surface("Emission", {"Strength": out(profile, "Fac")})


@feature()
def nodes():
    """A lamp whose nodes give its colour: blackbody, strength 2"""
    shown = lit_by("POINT", 120.0, shadow_soft_size=0.1)
    shown.data.use_nodes = True
    tree = Tree(shown.data)
    tree.surface("Emission", {"Color": tree.node("Blackbody", {"Temperature": 3000.0}),
                              "Strength": 2.0})  # fmt: skip


@feature(before_4=COSINE)
def nodes_textured():
    """A spot whose nodes throw a pattern"""
    settings = {"spot_size": math.radians(60), "spot_blend": 0.0, "shadow_soft_size": 0.0}
    shown = lit_by("SPOT", 300.0, **settings)
    shown.data.use_nodes = True
    tree = Tree(shown.data)
    checker = tree.node("TexChecker", {"Vector": out(tree.node("TexCoord"), "Normal")})
    tree.set(checker, "Color1", (1.0, 0.4, 0.1))
    tree.set(checker, "Color2", (0.1, 0.3, 1.0))
    tree.set(checker, "Scale", 8.0)
    tree.surface("Emission", {"Color": out(checker, "Color"), "Strength": 1.0})


def painted_by_uv(shown: bpy.types.Object, strength: float = 1.0) -> None:
    """Its UV as red and green, in squares."""
    shown.data.use_nodes = True
    tree = Tree(shown.data)
    uv = out(tree.node("TexCoord"), "UV")
    checker = tree.node("TexChecker", {"Vector": uv, "Color2": (0.1, 0.1, 1.0), "Scale": 6.0})
    tree.set(checker, "Color1", uv)
    tree.surface("Emission", {"Color": out(checker, "Color"), "Strength": strength})


@feature(before_4=COSINE)
def uv_of_spot():
    """A turned spot, wider than high, that throws a pattern by its UV"""
    settings = {"spot_size": math.radians(50), "spot_blend": 0.0, "shadow_soft_size": 0.0}
    shown = lit_by("SPOT", 600.0, **settings)
    shown.rotation_euler.rotate_axis("Z", 0.5)
    painted_by_uv(shown)


@feature()
def uv_of_point():
    """A turned point lamp that throws a pattern by its UV"""
    shown = lit_by("POINT", 400.0, shadow_soft_size=0.0)
    shown.rotation_euler = (0.4, 0.9, 0.3)
    painted_by_uv(shown)


def mirroring_ball() -> None:
    camera()
    floor()
    world(DIM)
    tree = new_tree()
    tree.surface("BsdfAnisotropic", {"Color": (0.9, 0.9, 0.9), "Roughness": 0.0})
    add(dressed(ball_mesh(), tree.datablock), BALL_CENTRE)


@feature(bounces=1)
def uv_of_area():
    """What a mirror shows of an oblong area lamp with a pattern by its UV"""
    mirroring_ball()
    shown = lamp("AREA", 30.0, (-1.8, -2.0, 2.2), BALL_CENTRE, shape="RECTANGLE")
    shown.data.size, shown.data.size_y = 3.0, 2.0
    shown.rotation_euler.rotate_axis("Z", 0.4)
    painted_by_uv(shown, 0.3)


@feature(bounces=1)
def mesh():
    """A shining rectangle"""
    by_night()
    shown = add(dressed(grid_mesh(1, 1, (1.2, 0.8)), glow((1.0, 0.8, 0.6), 12.0)), (-1.6, -1, 2.6))
    shown.rotation_euler = (0.5, 2.5, 0.0)


@feature(bounces=1)
def mesh_textured():
    """A rectangle that shines in coloured stripes"""

    def paint(tree: Tree):
        vector = tree.scaled(out(tree.node("TexCoord"), "UV"), 1.0, 0.01)
        inputs = {"Vector": vector, "Scale": 3.0, "Color1": (9.0, 1.0, 0.5)}
        return tree.node("TexChecker", {**inputs, "Color2": (0.5, 1.0, 9.0)})

    by_night()
    shown = add(dressed(grid_mesh(1, 1, (1.2, 1.2)), shows(paint)), (-1.6, -0.5, 2.2))
    shown.rotation_euler = (0.3, 2.2, 0.0)


@feature(samples=512, bounces=1)
def mesh_ball():
    """A small shining ball"""
    by_night()
    add(dressed(ball_mesh(0.2, 24, 12), glow((1.0, 0.9, 0.7), 60.0)), (-1.3, -1.3, 2.2))


@feature(bounces=1)
def mesh_one_sided():
    """A rectangle that shines to its front alone, by Backfacing"""
    by_night()
    tree = new_tree()
    strength = tree.math("SUBTRACT", 1.0, out(tree.node("NewGeometry"), "Backfacing"))
    tree.surface("Emission", {"Strength": tree.math("MULTIPLY", strength, 10.0)})
    shown = add(dressed(grid_mesh(1, 1, (1.0, 1.0)), tree.datablock), (-1.5, 0.0, 1.0))
    shown.rotation_euler = (0.0, math.pi / 2, 0.0)


@feature(samples=512, bounces=1)
def many_lamps():
    """A hundred small coloured lamps over the floor"""
    by_night()
    random = np.random.default_rng(2)
    for index in range(100):
        x, y = -2.7 + 0.6 * (index % 10), -2.7 + 0.6 * (index // 10)
        color = random.uniform(0.1, 1.0, 3)
        lamp("POINT", 3.0, (x, y, 0.4), color=tuple(color), shadow_soft_size=0.02)


@feature()
def without_shadow():
    """A lamp that throws no shadow"""
    shown = lit_by("POINT", 250.0, shadow_soft_size=0.1)
    if hasattr(shown.data, "use_shadow"):
        shown.data.use_shadow = False
    if hasattr(shown.data, "cycles") and hasattr(shown.data.cycles, "cast_shadow"):
        shown.data.cycles.cast_shadow = False


@feature()
def two_suns():
    """Two suns of different colours"""
    lit_by("SUN", 2.0, angle=0.05, color=(1.0, 0.5, 0.3))
    lamp("SUN", 2.0, (3.0, -2.0, 3.0), angle=0.05, color=(0.3, 0.5, 1.0))


@feature(bounces=1)
def in_a_mirror():
    """What a mirror shows of lamps: an area lamp, a point and a sun"""
    mirroring_ball()
    lamp("AREA", 40.0, (-1.8, -2.0, 2.6), BALL_CENTRE, shape="SQUARE", size=1.0)
    lamp("POINT", 60.0, (1.5, -2.0, 2.2), shadow_soft_size=0.3)
    lamp("SUN", 1.0, (0.0, -1.0, 3.0), angle=0.3)


@feature()
def negative():
    """A lamp of negative energy, which takes light away beside a sun"""
    lit_by("SUN", 3.0, angle=0.2)
    lamp("POINT", -60.0, (1.2, -1.6, 1.6), shadow_soft_size=0.2)


@feature(bounces=1)
def negative_in_a_mirror():
    """What a mirror shows of an area lamp of negative energy, in front of a bright sky"""
    mirroring_ball()
    world((0.6, 0.6, 0.6))
    lamp("AREA", -8.0, (-1.8, -2.0, 2.2), BALL_CENTRE, shape="SQUARE", size=1.5)


def shine(tree: Tree, strength: float) -> None:
    """Orange, with a strength that only a link can make negative."""
    negative = tree.math("MULTIPLY", strength, 1.0)
    tree.surface("Emission", {"Color": (1.0, 0.6, 0.3), "Strength": negative})


@feature()
def negative_nodes():
    """A lamp whose nodes shine with a negative strength, beside a sun"""
    lit_by("SUN", 3.0, angle=0.2)
    shown = lamp("POINT", 60.0, (1.2, -1.6, 1.6), shadow_soft_size=0.2)
    shown.data.use_nodes = True
    shine(Tree(shown.data), -1.0)


@feature(bounces=1)
def negative_mesh():
    """A rectangle that shines with a negative strength, beside a sun"""
    lit_by("SUN", 3.0, angle=0.2)
    tree = new_tree()
    shine(tree, -3.0)
    shown = add(dressed(grid_mesh(1, 1, (0.8, 0.8)), tree.datablock), (1.4, -1, 1.6))
    shown.rotation_euler = (0.5, 2.5, 0.0)


@feature()
def portal():
    """An area lamp that is a portal, which shines not, beside a sun"""
    lit_by("SUN", 3.0, angle=0.2)
    shown = lamp("AREA", 60.0, (1.2, -1.6, 1.6), shape="SQUARE", size=1.0)
    shown.data.cycles.is_portal = True
