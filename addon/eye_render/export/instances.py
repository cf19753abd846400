"""What the render sees: every mesh once, every instance of it as a matrix, and the lamps."""

from collections.abc import Callable
from typing import NamedTuple

import bpy
import numpy as np
from mathutils import Matrix

from .. import cryptomatte, passes
from .light import LightTable
from .material import MaterialTable
from .mesh import add_mesh
from .object_properties import PropertyReader
from .object_random import random_of
from .visibility import Visibility, light_group_of, visibility_of

# What Blender also lists beside the mesh that it evaluated from it.
_SHOWN_AS_MESH = {"CURVE", "SURFACE", "FONT", "META"}
_NOT_GEOMETRY = {"EMPTY", "CAMERA", "ARMATURE", "LATTICE", "SPEAKER", "LIGHT_PROBE"}


class _Look(NamedTuple):
    """What instances of a mesh have in common."""

    materials: tuple[int, ...]
    pass_index: int
    visibility: Visibility
    light_group: str = ""
    # For Cryptomatte, where it is asked for: names keep apart what may be placed together.
    name: str = ""
    asset: str = ""


class _Group:
    """The instances of one mesh with one look, and what tells them apart if anybody asks."""

    def __init__(self, tells_apart: bool, properties: list[str], reader: PropertyReader):
        self.tells_apart = tells_apart
        self.properties: dict[str, list[tuple[float, ...]]] = {name: [] for name in properties}
        self._reader = reader
        self.matrices: list[Matrix] = []
        self.colors: list[tuple[float, ...]] = []
        self.randoms: list[float] = []

    def append(self, instance: bpy.types.DepsgraphObjectInstance) -> None:
        self.matrices.append(instance.matrix_world.copy())
        if self.tells_apart:
            self.colors.append(tuple(instance.object.color))
            self.randoms.append(random_of(instance))
        for name, values in self.properties.items():
            values.append(self._reader.value(instance, name))


class _Geometry:
    """One evaluated mesh and all its instances."""

    def __init__(self, mesh: bpy.types.Mesh):
        self.mesh = mesh
        self.groups: dict[_Look, _Group] = {}

    def material_ids(self) -> list[int]:
        return sorted({number for look in self.groups for number in look.materials})


def export_instances(
    core_scene,
    depsgraph: bpy.types.Depsgraph,
    materials: MaterialTable,
    lights: LightTable,
    names: cryptomatte.MatteNames,
    warn: Callable[[str], None],
    check_cancel: Callable[[], None],
) -> None:
    """Add all visible meshes, their instances and the lamps to the core's scene; and to `names`
    theirs, if Cryptomatte asks for them."""
    view_layer = depsgraph.view_layer_eval
    has_names = bool(passes.cryptomatte_kinds(view_layer))
    reads_uvs = passes.needs_uvs(view_layer)
    reader = PropertyReader(depsgraph)
    geometries: dict[int, _Geometry] = {}
    groups: dict[tuple[int, int, int], _Group] = {}
    for instance in depsgraph.object_instances:
        if not instance.show_self:
            continue
        shown = instance.object
        placer = instance.parent if instance.is_instance else shown
        if shown.type == "LIGHT":
            seen = visibility_of(shown, placer, view_layer)
            light_group = light_group_of(shown, placer, view_layer)
            lights.add(shown, instance.matrix_world, seen.hidden_from, light_group)
        elif shown.type == "MESH":
            # The evaluated mesh is shared by the objects that do not modify it, and by nobody
            # else, so its address tells which instances have the same geometry.
            address = shown.data.as_pointer()
            key = (shown.original.as_pointer(), address, placer.original.as_pointer())
            group = groups.get(key)
            if group is None:
                check_cancel()
                if address not in geometries:
                    geometries[address] = _Geometry(shown.data)
                    _warn_of_hair(shown, warn)
                worn = materials.worn_by(shown)
                visibility = visibility_of(shown, placer, view_layer)
                light_group = light_group_of(shown, placer, view_layer)
                look = _Look(worn, shown.pass_index, visibility, light_group)
                if has_names:
                    asset = cryptomatte.asset_of(shown)
                    look = look._replace(name=shown.name, asset=asset)
                    names.objects.add(shown.name)
                    names.assets.add(asset)
                group = groups[key] = geometries[address].groups.setdefault(
                    look,
                    _Group(materials.read_object(worn), materials.properties_read(worn), reader),
                )
            group.append(instance)
        elif shown.type not in _SHOWN_AS_MESH | _NOT_GEOMETRY:
            kind = shown.bl_rna.properties["type"].enum_items[shown.type].name
            warn(f"{kind} '{shown.name}' is left out: this kind of object is not supported")

    for geometry in geometries.values():
        check_cancel()
        mesh_id = add_mesh(core_scene, geometry.mesh, geometry.material_ids(), reads_uvs)
        if mesh_id is None:
            continue
        for look, group in geometry.groups.items():
            _add_group(core_scene, mesh_id, geometry.mesh.name, look, group, warn)


def _add_group(
    core_scene, mesh_id: int, name: str, look: _Look, group: _Group, warn: Callable[[str], None]
) -> None:
    world_from_object = _as_array(group.matrices)
    is_finite = np.isfinite(world_from_object).all(axis=(1, 2))
    if not is_finite.all():
        count = np.count_nonzero(~is_finite)
        warn(
            f"Mesh '{name}' is left out {count} times: "
            "the place or size of the object is not a finite number"
        )
    told = {
        "attributes": {
            attribute: np.array(values, np.float32)[is_finite]
            for attribute, values in group.properties.items()
        }
    }
    if group.tells_apart:
        told |= {
            "colors": np.array(group.colors, np.float32)[is_finite],
            "randoms": np.array(group.randoms, np.float32)[is_finite],
        }
    core_scene.add_instances(
        mesh_id,
        world_from_object[is_finite],
        materials=list(look.materials),
        pass_index=look.pass_index,
        hidden_from=look.visibility.hidden_from,
        is_holdout=look.visibility.is_holdout,
        is_shadow_catcher=look.visibility.is_shadow_catcher,
        light_group=look.light_group,
        name=look.name,
        asset=look.asset,
        **told,
    )


def _as_array(matrices: list[Matrix]) -> np.ndarray:
    """(n, 4, 4); ten times as fast as `np.array`, which asks each matrix what it is."""
    numbers = (number for matrix in matrices for row in matrix for number in row)
    return np.fromiter(numbers, np.float64, 16 * len(matrices)).reshape(-1, 4, 4)


def _warn_of_hair(shown: bpy.types.Object, warn: Callable[[str], None]) -> None:
    for system in shown.particle_systems:
        if system.settings.type == "HAIR" and system.settings.render_type == "PATH":
            warn(f"Hair of '{shown.name}' is left out: hair strands are not supported")
