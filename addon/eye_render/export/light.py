"""Lamps. Energies stay Blender's: watts, for a sun watts per square metre."""

import math
from collections.abc import Callable

import bpy
import numpy as np
from mathutils import Matrix, Vector

from .. import compat
from .nodes import TreeReader, constant

_KINDS = {"POINT", "SUN", "SPOT", "AREA"}


def export_light(
    core_scene, shown: bpy.types.Object, world_from_object: Matrix, warn: Callable[[str], None]
) -> None:
    light = shown.data
    if light.type not in _KINDS:  # such as the hemi lamp, which Collada files still bring
        warn(f"Light '{light.name}' is left out: its kind is not one that Blender knows")
        return
    if not np.isfinite(np.array(world_from_object)).all():
        warn(f"Light '{light.name}' is left out: its place or size is not a finite number")
        return
    shape = _shape(light, world_from_object.to_scale())
    # Unit axes: the sizes carry the scale, and a mirrored lamp keeps its direction.
    world_from_light = world_from_object.to_3x3().normalized().to_4x4()
    world_from_light.translation = world_from_object.translation
    factor, is_normalized = compat.light_factor(light)
    energy = light.energy if is_normalized else light.energy * _area(light, shape)
    color = np.array(light.color) * factor * _emission_factor(light, warn) * energy
    core_scene.add_light(
        shown.name,
        light.type,
        np.array(world_from_light),
        tuple(color),
        casts_shadow=light.use_shadow,
        **shape,
    )


def _shape(light: bpy.types.Light, scale: Vector) -> dict[str, object]:
    if light.type == "SUN":
        return {"angle_rad": light.angle}
    if light.type == "AREA":
        is_round = light.shape in {"DISK", "ELLIPSE"}
        size_y = light.size_y if light.shape in {"RECTANGLE", "ELLIPSE"} else light.size
        return {
            "shape": "DISK" if is_round else "RECTANGLE",
            "size_x": light.size * abs(scale.x),
            "size_y": size_y * abs(scale.y),
            "spread_rad": light.spread,
        }
    if light.type == "SPOT":
        return {
            **_ball(light),
            "spot_angle_rad": light.spot_size,
            "spot_blend": light.spot_blend,
            "spot_cosine_falloff": compat.SPOTS_HAVE_COSINE_FALLOFF,
        }
    return _ball(light)


def _ball(light: bpy.types.Light) -> dict[str, object]:
    return {
        "radius": light.shadow_soft_size,
        "soft_falloff": compat.has_soft_falloff(light),
    }


def _area(light: bpy.types.Light, shape: dict[str, object]) -> float:
    """What Blender's "Normalize" divides the energy by; 1 for a lamp without extent."""
    if light.type == "AREA":
        return shape["size_x"] * shape["size_y"] * (math.pi / 4 if shape["shape"] == "DISK" else 1)
    radius = math.tan(light.angle / 2) if light.type == "SUN" else light.shadow_soft_size
    return math.pi * radius**2 if radius > 0 else 1.0


def _emission_factor(light: bpy.types.Light, warn: Callable[[str], None]) -> np.ndarray:
    """What the light's own node tree multiplies its colour by."""
    if not compat.uses_nodes(light):
        return np.ones(3)
    inlined = compat.inline_shader_nodes(light)
    output = inlined.node_tree.get_output_node("CYCLES")
    source = TreeReader().read(output.inputs["Surface"]).source if output else None
    if source is None:
        return np.zeros(3)
    emission = source.node
    factor = np.ones(3)
    if emission.kind != "EMISSION":
        warn(f"Light '{light.name}': {emission.label} is not supported and is left out")
        return factor
    for name in ("Color", "Strength"):
        item = emission.inputs[name]
        value = constant(item)
        if value is None:
            label = item.source.node.label
            warn(f"Light '{light.name}': {label} ({name}) is not supported and is left out")
            value = item.value
        factor = factor * value
    return factor
