"""Hair shaders, on strands of particles on a ball in sun and sky."""

import bpy
from features import feature
from stage import ball, diffuse, lamp, new_tree


def haired(kind: str, inputs: dict, shape: str = "THICK", **properties) -> None:
    """A ball whose hair has that shader."""
    shown = ball(diffuse((0.3, 0.15, 0.1)))
    shown.scale = (0.6, 0.6, 0.6)
    tree = new_tree("Hair")
    tree.surface(kind, inputs, **properties)
    shown.data.materials.append(tree.datablock)
    shown.modifiers.new("Hair", "PARTICLE_SYSTEM")
    hair = shown.particle_systems[0].settings
    hair.type, hair.count, hair.hair_length, hair.hair_step = "HAIR", 80, 1.2, 4
    hair.root_radius, hair.tip_radius, hair.radius_scale = 1.0, 0.5, 0.2
    hair.material = 2
    bpy.context.scene.cycles_curves.shape = shape
    lamp("POINT", 150.0, (0.0, 3.0, 3.0), shadow_soft_size=0.3)


@feature(bounces=0, samples=512)
def color():
    """Principled Hair by its colour, lit from behind, too"""
    inputs = {"Color": (0.75, 0.4, 0.15), "Roughness": 0.3, "Radial Roughness": 0.4}
    haired("BsdfHairPrincipled", inputs, parametrization="COLOR")


@feature(bounces=1, samples=1024)
def melanin():
    """Principled Hair by its pigments, each strand a little other"""
    inputs = {"Melanin": 0.6, "Melanin Redness": 0.7, "Random Color": 0.8}
    inputs |= {"Random Roughness": 0.6, "Roughness": 0.25, "Tint": (0.9, 0.8, 1.0)}
    haired("BsdfHairPrincipled", inputs, parametrization="MELANIN")


@feature(
    bounces=0,
    samples=512,
    differs="Cycles draws the light that a coat reflects as if it were as rough as without it",
)
def absorption():
    """Principled Hair by what it absorbs, coated, with steep scales"""
    inputs = {"Absorption Coefficient": (0.05, 0.2, 0.4), "Roughness": 0.4, "Coat": 0.7}
    inputs |= {"Offset": 0.2, "IOR": 1.7}
    haired("BsdfHairPrincipled", inputs, parametrization="ABSORPTION")


@feature(bounces=0, samples=512)
def ribbons():
    """Principled Hair on flat ribbons"""
    inputs = {"Color": (0.75, 0.4, 0.15), "Roughness": 0.3, "Radial Roughness": 0.4}
    haired("BsdfHairPrincipled", inputs, "RIBBONS", parametrization="COLOR")
