"""What an object brings into the picture: its mesh, its curves or points, and the hair that grows
on it. Each source knows how to hand itself to the core."""

from collections.abc import Iterator
from typing import Protocol

import bpy

from .curves import CurvesSource
from .hair import HairSource
from .mesh import MeshSource
from .points import PointsSource
from .pose import Pose


class Source(Protocol):
    name: str
    part: str  # of what the object brings: the hair system's name; empty for the object's own
    # What is evaluated once is shared by the objects that do not modify it, and by nobody else,
    # so its address tells which instances have the same geometry.
    key: tuple[int, str]

    def worn(self, slots: tuple[int, ...]) -> tuple[int, ...]:
        """The materials that it wears, of those in the object's slots."""

    def pose(self) -> Pose:
        """As it is now."""

    def add(
        self, core_scene, material_ids: list[int], reads_uvs: bool, motion: list[Pose]
    ) -> int | None:
        """Its number in the core's scene; None if there is nothing to be seen.

        `material_ids` are all materials that some instance of it wears: what none of them reads
        is not exported, nor the active UV map unless `reads_uvs` says that a pass does. `motion`
        is empty for what does not deform.
        """


_OF_TYPE = {"MESH": MeshSource, "CURVES": CurvesSource, "POINTCLOUD": PointsSource}
TYPES = frozenset(_OF_TYPE)


# The view layer's switch of what is of that type; points have none.
_SWITCHES = {"MESH": "use_solid", "CURVES": "use_strand"}


def sources_of(
    instance: bpy.types.DepsgraphObjectInstance, depsgraph: bpy.types.Depsgraph
) -> Iterator[Source]:
    """Those that the filter of the depsgraph's view layer lets through."""
    shown, scene, layer = instance.object, depsgraph.scene_eval, depsgraph.view_layer_eval
    if instance.show_self and getattr(layer, _SWITCHES.get(shown.type, ""), True):
        yield _OF_TYPE[shown.type](shown.data, scene)
    if instance.show_particles and layer.use_strand:
        # Of an instance, Blender knows the strands where the object itself stands.
        bearer = instance.instance_object if instance.is_instance else shown
        for modifier in bearer.modifiers if bearer else ():
            if modifier.type == "PARTICLE_SYSTEM" and modifier.show_render:
                system = modifier.particle_system
                if HairSource.is_hair(system):
                    yield HairSource(bearer, modifier, scene)
