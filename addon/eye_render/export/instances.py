"""What the render sees: every geometry once, every instance of it as a matrix, and the lamps."""

from collections.abc import Callable
from itertools import chain
from typing import NamedTuple

import bpy
import numpy as np
from mathutils import Matrix

from .. import compat, core, cryptomatte, passes
from .light import LightTable
from .light_links import LightLinks, Linked, Links
from .material import MaterialTable
from .motion import Key, Motion, key_of
from .object_properties import PropertyReader
from .object_random import random_of
from .pose import Pose
from .sources import TYPES, Source, sources_of
from .visibility import Visibility, light_group_of, visibility_of

# What Blender also lists beside the mesh that it evaluated from it.
_SHOWN_AS_MESH = {"CURVE", "SURFACE", "FONT", "META"}
# Kinds that Blender itself draws over the picture of any engine, as they are called by version.
_DRAWN_BY_BLENDER = {"GPENCIL", "GREASEPENCIL"}
_NOT_GEOMETRY = {"EMPTY", "CAMERA", "ARMATURE", "LATTICE", "SPEAKER", "LIGHT_PROBE"}


class _Look(NamedTuple):
    """What instances of a geometry have in common."""

    materials: tuple[int, ...]
    pass_index: int
    visibility: Visibility
    motion_steps: int  # 0 without motion blur
    light_group: str = ""
    links: Links = Links()
    linked: Linked = Linked()
    terminator_cosine: float = 0.0
    # For Cryptomatte, where it is asked for: names keep apart what may be placed together.
    name: str = ""
    asset: str = ""


class _Group:
    """The instances of one geometry with one look, and what tells them apart if anybody asks."""

    def __init__(self, look: _Look, materials: MaterialTable, reader: PropertyReader):
        self.look = look
        self.tells_apart = materials.read_object(look.materials)
        self.properties: dict[str, list[tuple[float, ...]]] = {
            name: [] for name in materials.properties_read(look.materials)
        }
        self._reader = reader
        self.matrices: list[Matrix] = []
        self.keys: list[Key] = []  # of what may move
        self.colors: list[tuple[float, ...]] = []
        self.randoms: list[float] = []

    def append(self, instance: bpy.types.DepsgraphObjectInstance) -> None:
        self.matrices.append(instance.matrix_world.copy())
        if self.look.motion_steps:
            self.keys.append(key_of(instance))
        if self.tells_apart:
            self.colors.append(tuple(instance.object.color))
            self.randoms.append(random_of(instance))
        for name, values in self.properties.items():
            values.append(self._reader.value(instance, name))

    def told(self, chosen: np.ndarray) -> dict[str, object]:
        """What tells the chosen ones apart."""
        told = {
            "attributes": {
                name: np.array(values, np.float32)[chosen]
                for name, values in self.properties.items()
            }
        }
        if self.tells_apart:
            told |= {
                "colors": np.array(self.colors, np.float32)[chosen],
                "randoms": np.array(self.randoms, np.float32)[chosen],
            }
        return told


class _Geometry:
    """One evaluated geometry and all its instances."""

    def __init__(self, source: Source, motion: list[Pose]):
        self.source = source
        self.motion = motion  # empty if it does not deform
        self.groups: dict[_Look, _Group] = {}

    def material_ids(self) -> list[int]:
        return sorted({number for look in self.groups for number in look.materials})


class _Collector:
    """The geometries that instances bring, each once."""

    def __init__(
        self,
        depsgraph: bpy.types.Depsgraph,
        materials: MaterialTable,
        names: cryptomatte.MatteNames,
        warn: Callable[[str], None],
        motion: Motion | None,
        links: LightLinks,
    ):
        self.geometries: dict[tuple[int, str], _Geometry] = {}
        self._depsgraph = depsgraph
        self._materials = materials
        self._names = names
        self._has_names = bool(passes.cryptomatte_kinds(depsgraph.view_layer_eval))
        self._warn = warn
        self._motion = motion
        self._links = links
        self._reader = PropertyReader(depsgraph, warn)

    def groups_of(
        self, instance: bpy.types.DepsgraphObjectInstance, placer: bpy.types.Object
    ) -> list[_Group]:
        """One for each geometry that the object brings."""
        shown, motion = instance.object, self._motion
        if compat.terminator_offsets(shown)[0] > 0.0:
            self._warn(
                f"The shading offset of the shadow terminator of '{shown.name}' is left out"
            )
        if _is_smoke(shown):
            self._warn(
                f"Smoke of '{shown.name}' is left out: it varies in space, which is not supported"
            )
            return []
        visibility = visibility_of(shown, placer, self._depsgraph.view_layer_eval)
        light_group = light_group_of(shown, placer, self._depsgraph.view_layer_eval)
        links, linked = self._links.of_light(shown), self._links.of_object(shown, placer)
        slots = self._materials.worn_by(shown)
        steps = motion.shutter.steps_of(shown, placer) if motion else 0
        groups = []
        for source in sources_of(instance, self._depsgraph):
            if source.key not in self.geometries:
                poses = motion.poses(instance, source, steps) if steps else []
                self.geometries[source.key] = _Geometry(source, poses)
            worn = source.worn(slots)
            look = _Look(
                worn,
                shown.pass_index,
                visibility,
                steps,
                light_group,
                links,
                linked,
                compat.terminator_offsets(shown)[1],
            )
            if self._has_names:
                look = self._named(look, shown)
            known = self.geometries[source.key].groups
            if look not in known:
                known[look] = _Group(look, self._materials, self._reader)
            groups.append(known[look])
        return groups

    def _named(self, look: _Look, shown: bpy.types.Object) -> _Look:
        asset = cryptomatte.asset_of(shown)
        self._names.objects.add(shown.name)
        self._names.assets.add(asset)
        return look._replace(name=shown.name, asset=asset)


def export_instances(
    core_scene,
    depsgraph: bpy.types.Depsgraph,
    materials: MaterialTable,
    lights: LightTable,
    names: cryptomatte.MatteNames,
    warn: Callable[[str], None],
    check_cancel: Callable[[], None],
    motion: Motion | None = None,
) -> None:
    """Add all visible geometry, its instances and the lamps to the core's scene; and to `names`
    theirs, if Cryptomatte asks for them.

    `motion` is what was found while the shutter is open; None without motion blur.
    """
    links = LightLinks(depsgraph, warn)
    collector = _Collector(depsgraph, materials, names, warn, motion, links)
    reads_uvs = passes.needs_uvs(depsgraph.view_layer_eval)
    groups: dict[tuple[int, int, int], list[_Group]] = {}
    for instance in depsgraph.object_instances:
        shown = instance.object
        if not (instance.show_self or instance.show_particles):
            continue
        placer = instance.parent if instance.is_instance else shown
        if shown.type == "LIGHT":
            seen = visibility_of(shown, placer, depsgraph.view_layer_eval)
            light_group = light_group_of(shown, placer, depsgraph.view_layer_eval)
            lights.add(
                shown,
                instance.matrix_world,
                seen.hidden_from,
                light_group,
                links.of_light(shown),
                motion.lamp_poses(instance, placer) if motion else [],
            )
        elif shown.type in TYPES:
            address = shown.data.as_pointer()
            key = (shown.original.as_pointer(), address, placer.original.as_pointer())
            if key not in groups:
                check_cancel()
                groups[key] = collector.groups_of(instance, placer)
            for group in groups[key]:
                group.append(instance)
        elif shown.type in _DRAWN_BY_BLENDER:
            warn(f"Grease Pencil '{shown.name}' is drawn over the picture by Blender, and sharp")
        elif shown.type not in _SHOWN_AS_MESH | _NOT_GEOMETRY:
            kind = shown.bl_rna.properties["type"].enum_items[shown.type].name
            warn(f"{kind} '{shown.name}' is left out: this kind of object is not supported")

    for geometry in collector.geometries.values():
        check_cancel()
        source = geometry.source
        with core.speaking(f"'{source.name}'"):
            number = source.add(core_scene, geometry.material_ids(), reads_uvs, geometry.motion)
            if number is None:
                continue
            for group in geometry.groups.values():
                _add_group(core_scene, number, source.name, group, motion, warn)


def _add_group(
    core_scene,
    number: int,
    name: str,
    group: _Group,
    motion: Motion | None,
    warn: Callable[[str], None],
) -> None:
    world_from_object = _as_array(group.matrices)
    is_finite = np.isfinite(world_from_object).all(axis=(1, 2))
    if not is_finite.all():
        count = np.count_nonzero(~is_finite)
        warn(
            f"'{name}' is left out {count} times: "
            "the place or size of the object is not a finite number"
        )
    still, told_motion = is_finite, None
    if group.look.motion_steps:
        told_motion = _motion_of(group, motion)
        moves = (told_motion != world_from_object[:, None]).any(axis=(1, 2, 3))
        moves &= np.isfinite(told_motion).all(axis=(1, 2, 3))
        still = is_finite & ~moves
    for chosen in (still, is_finite & ~still):
        if chosen.any():
            core_scene.add_instances(
                number,
                world_from_object[chosen],
                materials=list(group.look.materials),
                pass_index=group.look.pass_index,
                hidden_from=group.look.visibility.hidden_from,
                is_holdout=group.look.visibility.is_holdout,
                is_shadow_catcher=group.look.visibility.is_shadow_catcher,
                light_group=group.look.light_group,
                **group.look.links._asdict(),
                **group.look.linked._asdict(),
                terminator_cosine=group.look.terminator_cosine,
                name=group.look.name,
                asset=group.look.asset,
                **group.told(chosen),
                **({} if chosen is still else {"motion": told_motion[chosen]}),
            )


def _motion_of(group: _Group, motion: Motion) -> np.ndarray:
    """(n, steps, 4, 4)"""
    steps = group.look.motion_steps
    matrices = (
        matrix
        for key, middle in zip(group.keys, group.matrices, strict=True)
        for matrix in motion.matrices(key, middle, steps)
    )
    return _as_array(list(matrices)).reshape(-1, steps, 4, 4)


def _as_array(matrices: list[Matrix]) -> np.ndarray:
    """(n, 4, 4); ten times as fast as `np.array`, which asks each matrix what it is."""
    rows = chain.from_iterable(matrices)
    numbers = chain.from_iterable(rows)
    return np.fromiter(numbers, np.float64, 16 * len(matrices)).reshape(-1, 4, 4)


def _is_smoke(shown: bpy.types.Object) -> bool:
    """Whether the mesh is but the box of a simulation, which its material would fill evenly."""
    domains = (m.domain_settings for m in shown.modifiers if m.type == "FLUID")
    return any(domain is not None and domain.domain_type == "GAS" for domain in domains)
