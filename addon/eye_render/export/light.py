"""Lamps, each with the tree of its datablock. Energies stay Blender's: watts, for a sun watts per
square metre."""

import math
from collections.abc import Callable, Sequence

import bpy
import numpy as np
from mathutils import Matrix, Vector

from .. import compat, cycles_settings
from .image import ImageTable
from .light_links import Links
from .nodes import EMISSION, export_sockets

_NO_LINKS = Links()
_KINDS = {"POINT", "SUN", "SPOT", "AREA"}


# What may change while the shutter is open: keywords of the core's `add_light`.
LampPose = dict[str, object]


def lamp_pose(light: bpy.types.Light, world_from_object: Matrix) -> LampPose:
    return {
        "world_from_light": np.array(world_from_object),
        "color": tuple(_color_times_energy(light, world_from_object.to_scale())),
        **_shape(light),
    }


def lamp_differs(pose: LampPose, other: LampPose) -> bool:
    return any(not np.array_equal(pose[name], other[name]) for name in pose)


class LightTable:
    """The lamps of one core scene; the tree of each datablock is exported once."""

    def __init__(self, core_scene, images: ImageTable, warn: Callable[[str], None]):
        self._core_scene = core_scene
        self._images = images
        self._warn = warn
        self._surfaces: dict[str, object | None] = {}

    def add(
        self,
        shown: bpy.types.Object,
        world_from_object: Matrix,
        hidden_from: tuple[str, ...],
        light_group: str = "",
        links: Links = _NO_LINKS,
        motion: Sequence[LampPose] = (),
    ) -> None:
        """`motion`: its poses while the shutter is open; empty for a lamp that keeps still."""
        light = shown.data
        if light.type not in _KINDS:  # such as the hemi lamp, which Collada files still bring
            self._warn(f"Light '{light.name}' is left out: its kind is not one Blender knows")
            return
        if not np.isfinite(np.array(world_from_object)).all():
            self._warn(f"Light '{light.name}' is left out: its place or size is not finite")
            return
        if cycles_settings.is_portal(light):
            return
        told = {}
        if compat.uses_nodes(light):
            told["surface"] = self._surface_of(light)
            if told["surface"] is None:  # nothing that shines
                return
        if all(np.isfinite(pose["world_from_light"]).all() for pose in motion):
            told["motion"] = motion
        try:
            self._core_scene.add_light(
                shown.name,
                light.type,
                **lamp_pose(light, world_from_object),
                casts_shadow=getattr(*compat.shadow_switch(light)),
                has_own_space=compat.LIGHTS_HAVE_OWN_SPACE,
                hidden_from=hidden_from,
                light_group=light_group,
                **links._asdict(),
                **told,
            )
        except ValueError as error:
            self._warn(f"Light '{light.name}' is left out: {error}")

    def _surface_of(self, light: bpy.types.Light) -> object | None:
        if light.name_full not in self._surfaces:
            self._surfaces[light.name_full] = self._export_tree(light)
        return self._surfaces[light.name_full]

    def _export_tree(self, light: bpy.types.Light) -> object | None:
        inlined = compat.inline_shader_nodes(light)
        output = inlined.node_tree.get_output_node("CYCLES")
        if output is None:
            return None
        tree = export_sockets([output.inputs["Surface"]], self._images, EMISSION)
        if tree.left_out:
            self._warn(f"Light '{light.name}': not supported: {', '.join(tree.left_out)}")
        return tree.sockets[0]


def _color_times_energy(light: bpy.types.Light, scale: Vector) -> np.ndarray:
    factor, is_normalized = compat.light_factor(light)
    energy = light.energy if is_normalized else light.energy * _area(light, scale)
    return np.array(light.color) * factor * energy


def _shape(light: bpy.types.Light) -> dict[str, object]:
    if light.type == "SUN":
        return {"angle_rad": light.angle}
    if light.type == "AREA":
        is_round = light.shape in {"DISK", "ELLIPSE"}
        return {
            "shape": "DISK" if is_round else "RECTANGLE",
            "size_x": light.size,
            "size_y": _size_y(light),
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


def _size_y(light: bpy.types.AreaLight) -> float:
    return light.size_y if light.shape in {"RECTANGLE", "ELLIPSE"} else light.size


def _area(light: bpy.types.Light, scale: Vector) -> float:
    """What Blender's "Normalize" divides the energy by; 1 for a lamp without extent."""
    if light.type == "AREA":
        box = abs(light.size * scale.x * _size_y(light) * scale.y)
        return box * (math.pi / 4 if light.shape in {"DISK", "ELLIPSE"} else 1.0)
    radius = math.tan(light.angle / 2) if light.type == "SUN" else light.shadow_soft_size
    return math.pi * radius**2 if radius > 0 else 1.0
