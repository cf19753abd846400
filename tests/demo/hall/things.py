"""What the hall holds besides stone: the desk in front of the eye with small things, statues,
curtains, plants, and things that glow."""

import math

import bmesh
import bpy
import numpy as np

from .patches import Patch, box, lathe, make_mesh, place, rounded

DESK_M = 1.17  # height of the top
LANTERNS = [(side * 5.4, y, 3.7) for y in (4.0, 12.0, 24.0) for side in (-1, 1)]


def build(materials) -> None:
    _desk(materials)
    _statues(materials)
    _curtains(materials)
    _plants(materials)
    _lanterns(materials)


def _primitive(name, material, make, smooth=True, **options) -> bpy.types.Mesh:
    """A mesh by one of bmesh's primitive operators, texture coordinates included."""
    mesh = bpy.data.meshes.new(name)
    shape = bmesh.new()
    shape.loops.layers.uv.new("UVMap")
    make(shape, calc_uvs=True, **options)
    for face in shape.faces:
        face.smooth = smooth
    shape.to_mesh(mesh)
    shape.free()
    mesh.materials.append(material)
    return mesh


def _ball(name, material, radius_m, location):
    mesh = _primitive(
        name, material, bmesh.ops.create_uvsphere, u_segments=96, v_segments=48, radius=radius_m
    )
    return place(name, mesh, location)


def _monkey(name, material, size_m, location, turn_deg, levels):
    mesh = _primitive(name, material, bmesh.ops.create_monkey)
    thing = place(name, mesh, location, (0, 0, math.radians(turn_deg)), (size_m / 2,) * 3)
    subdivide = thing.modifiers.new("subdivide", "SUBSURF")
    subdivide.levels = subdivide.render_levels = levels
    return thing


def _desk(materials):
    top = make_mesh("desk", box((-0.9, 0, -0.06), (0.9, 0.95, 0)), [materials["wood"]])
    desk = place("desk", top, (0, 0.5, DESK_M))
    bevel = desk.modifiers.new("bevel", "BEVEL")
    bevel.width, bevel.segments = 0.015, 4
    z = DESK_M
    _ball("glass ball", materials["glass"], 0.065, (-0.055, 0.98, z + 0.065))
    _ball("mirror ball", materials["mirror"], 0.036, (-0.195, 1.22, z + 0.036))
    _ball("ember", materials["ember"], 0.022, (0.085, 0.86, z + 0.022))
    _monkey("gold head", materials["gold"], 0.12, (0.1, 1.22, z + 0.055), 12, 3)
    cube = _primitive(
        "grid cube", materials["grid"], bmesh.ops.create_cube, smooth=False, size=0.1
    )
    place("grid cube", cube, (0.43, 1.12, z + 0.05), (0, 0, math.radians(28)))
    vase = rounded(
        [(0.001, 0), (0.045, 0.004), (0.062, 0.06), (0.03, 0.14), (0.026, 0.17), (0.04, 0.19)], 8
    )
    place("vase", make_mesh("vase", [lathe(vase, 64)], [materials["bronze"]]), (-0.45, 1.3, z))


def _statues(materials):
    """Heads on plinths along the nave, one of them of glass."""
    profile = rounded(
        [(0.34, 0), (0.34, 0.12), (0.26, 0.2), (0.24, 0.9), (0.3, 1.0), (0.32, 1.1)], 5
    )
    for name, look, x, y, levels in (
        ("bronze head", "bronze", -2.55, 7.6, 3),
        ("glass head", "glass", 2.75, 15.0, 3),
        ("marble head", "marble", -2.6, 16.5, 2),
        ("gold head far", "gold", 2.6, 24.0, 2),
    ):
        plinth = make_mesh("plinth", [lathe(profile, 48)], [materials["marble"]])
        place("plinth", plinth, (x, y, 0))
        turn_deg = math.degrees(math.atan2(x, y)) * -1
        _monkey(name, materials[look], 0.95, (x, y, 1.52), turn_deg, levels)


def _cloth(width_m, height_m, folds, seed, material):
    """Folds that deepen downwards, 100 by 90 quads."""
    phase = np.random.default_rng(seed).uniform(0, 2 * np.pi, 4)
    u, v = np.linspace(0, 1, 101)[:, None], np.linspace(0, 1, 91)[None, :]
    depth = 0.05 + 0.09 * (1 - v)
    wave = np.sin(2 * np.pi * folds * u + phase[0] + 0.8 * np.sin(3 * v + phase[1]))
    wave = wave + 0.35 * np.sin(2 * np.pi * (folds * 2.3) * u + phase[2] + 2 * v)
    points = np.stack(
        np.broadcast_arrays(
            depth * wave,
            width_m * (u - 0.5) * (0.94 + 0.06 * v),
            height_m * v - height_m + 0.03 * np.sin(2 * np.pi * u + phase[3]) * (1 - v),
        ),
        axis=-1,
    )
    uv = np.stack(np.broadcast_arrays(width_m * 1.3 * u, height_m * v), axis=-1)
    return make_mesh("curtain", [Patch(points, uv)], [material])


def _curtains(materials):
    """Curtains in openings of the arcade, drawn to one side; banners from the gallery, which face
    the eye."""
    rod = make_mesh("rod", box((-0.02, -1.9, 0), (0.02, 1.9, 0.04)), [materials["iron"]])
    for k, (side, y) in enumerate(((-1, 4.0), (1, 8.0), (-1, 12.0), (1, 16.0))):
        look = ("cloth", "cloth blue")[k // 2 % 2]
        place(
            "curtain",
            _cloth(1.5, 3.4, 6, k, materials[look]),
            (side * 4.15, y + 0.9 * (-1) ** k, 4.15),
        )
        place("rod", rod, (side * 4.15, y, 4.15))
    facing = (0, 0, -math.pi / 2)
    for k, (side, y) in enumerate(((-1, 11.9), (1, 13.9), (-1, 19.9), (1, 21.9))):
        look = ("cloth blue", "cloth")[k // 2 % 2]
        place(
            "banner", _cloth(0.85, 2.6, 2, 10 + k, materials[look]), (side * 3.05, y, 6.2), facing
        )
        place("banner rod", rod, (side * 3.4, y, 6.2), facing, (1, 0.5, 1))


def _plants(materials):
    """Clipped trees in pots: leaves are one mesh of many small quads."""
    rng = np.random.default_rng(11)
    count = 4000
    center = rng.standard_normal((count, 3))
    center *= (0.55 * rng.uniform(0.75, 1, count) ** (1 / 3) / np.linalg.norm(center, axis=1))[
        :, None
    ]
    a, b = rng.standard_normal((2, count, 3)) * 0.028
    corners = np.stack([center - a, center + b * 0.6, center + a, center - b * 0.6], axis=1)
    mesh = bpy.data.meshes.new("leaves")
    mesh.from_pydata(
        corners.reshape(-1, 3).tolist(), [], np.arange(4 * count).reshape(-1, 4).tolist()
    )
    mesh.materials.append(materials["leaf"])
    pot = rounded(
        [(0.001, 0), (0.3, 0.0), (0.36, 0.4), (0.42, 0.55), (0.38, 0.6), (0.001, 0.56)], 5
    )
    trunk = lathe([(0.035, 0.5), (0.03, 1.5)], 16)
    stand = make_mesh(
        "pot",
        [lathe(pot, 48), Patch(trunk.points, trunk.uv, slot=1)],
        [materials["bronze"], materials["wood"]],
    )
    for side, y in ((-1, 4.4), (1, 5.8), (-1, 12.5), (1, 20.0), (-1, 21.0)):
        place("pot", stand, (side * 3.1, y, 0))
        place("leaves", mesh, (side * 3.1, y, 1.75), (0, 0, y), (1, 1, 1.1))


def _lanterns(materials):
    """Glowing globes on chains in the arcade's openings; the chain is an array of links."""
    globe = _primitive(
        "globe", materials["lantern"], bmesh.ops.create_icosphere, subdivisions=4, radius=0.13
    )
    angle = np.linspace(0, 2 * np.pi, 7)
    ring = np.stack([0.035 + 0.008 * np.cos(angle), 0.008 * np.sin(angle)], axis=-1)
    link = make_mesh("link", [lathe(ring, 12)], [materials["iron"]])
    for x, y, z in LANTERNS:
        place("globe", globe, (x, y, z))
        chain = place("chain", link, (x, y, z + 0.18), (0, math.pi / 2, 0))
        array = chain.modifiers.new("links", "ARRAY")
        array.count = 36
        array.use_relative_offset, array.use_constant_offset = False, True
        array.constant_offset_displace = (-0.062, 0, 0)
    sign = make_mesh(
        "neon", [lathe([(0.5, 0.0), (0.52, 0.03), (0.5, 0.06)], 96)], [materials["neon"]]
    )
    place("neon ring", sign, (3.45, 9.5, 5.1), (0, math.pi / 2, 0))
