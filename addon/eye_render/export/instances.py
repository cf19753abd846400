"""What the render sees: every mesh once, every instance of it as a matrix, and the lamps."""

from collections.abc import Callable

import bpy
import numpy as np
from mathutils import Matrix

from . import light
from .material import MaterialTable
from .mesh import add_mesh
from .object_random import random_of

# What Blender also lists beside the mesh that it evaluated from it.
_SHOWN_AS_MESH = {"CURVE", "SURFACE", "FONT", "META"}
_NOT_GEOMETRY = {"EMPTY", "CAMERA", "ARMATURE", "LATTICE", "SPEAKER", "LIGHT_PROBE"}


class _Wearers:
    """Instances of one mesh that look alike, and what tells them apart if anybody asks."""

    def __init__(self, materials: tuple[int, ...], pass_index: int, tells_apart: bool):
        self.materials = materials
        self.pass_index = pass_index
        self.tells_apart = tells_apart
        self.matrices: list[Matrix] = []
        self.colors: list[tuple[float, ...]] = []
        self.randoms: list[float] = []

    def append(self, instance: bpy.types.DepsgraphObjectInstance) -> None:
        self.matrices.append(instance.matrix_world.copy())
        if self.tells_apart:
            self.colors.append(tuple(instance.object.color))
            self.randoms.append(random_of(instance))


class _Geometry:
    """One evaluated mesh and its instances, grouped by the materials they wear."""

    def __init__(self, mesh: bpy.types.Mesh):
        self.mesh = mesh
        self.wearers: dict[tuple, _Wearers] = {}

    def material_ids(self) -> list[int]:
        return sorted({number for worn in self.wearers.values() for number in worn.materials})


def export_instances(
    core_scene,
    depsgraph: bpy.types.Depsgraph,
    materials: MaterialTable,
    warn: Callable[[str], None],
    check_cancel: Callable[[], None],
) -> None:
    """Add all visible meshes, their instances and the lamps to the core's scene."""
    geometries: dict[int, _Geometry] = {}
    worn_by: dict[tuple[int, int], tuple[int, ...]] = {}
    for instance in depsgraph.object_instances:
        if not instance.show_self:
            continue
        shown = instance.object
        if shown.type == "LIGHT":
            light.export_light(core_scene, shown, instance.matrix_world, warn)
        elif shown.type == "MESH":
            # The evaluated mesh is shared by the objects that do not modify it, and by nobody
            # else, so its address tells which instances have the same geometry.
            mesh = shown.data
            address = mesh.as_pointer()
            geometry = geometries.get(address)
            if geometry is None:
                check_cancel()
                geometry = geometries[address] = _Geometry(mesh)
                _warn_of_hair(shown, warn)
            wearer = (shown.original.as_pointer(), address)
            worn = worn_by.get(wearer)
            if worn is None:
                worn = worn_by[wearer] = materials.worn_by(shown)
            group = (worn, shown.pass_index)
            wearers = geometry.wearers.get(group)
            if wearers is None:
                wearers = geometry.wearers[group] = _Wearers(*group, materials.read_object(worn))
            wearers.append(instance)
        elif shown.type not in _SHOWN_AS_MESH | _NOT_GEOMETRY:
            kind = shown.bl_rna.properties["type"].enum_items[shown.type].name
            warn(f"{kind} '{shown.name}' is left out: this kind of object is not supported")

    for geometry in geometries.values():
        check_cancel()
        mesh_id = add_mesh(core_scene, geometry.mesh, geometry.material_ids())
        if mesh_id is None:
            continue
        for wearers in geometry.wearers.values():
            _add_wearers(core_scene, mesh_id, geometry.mesh.name, wearers, warn)


def _add_wearers(
    core_scene, mesh_id: int, name: str, wearers: _Wearers, warn: Callable[[str], None]
) -> None:
    world_from_object = _as_array(wearers.matrices)
    is_finite = np.isfinite(world_from_object).all(axis=(1, 2))
    if not is_finite.all():
        count = np.count_nonzero(~is_finite)
        warn(
            f"Mesh '{name}' is left out {count} times: "
            "the place or size of the object is not a finite number"
        )
    looks = {}
    if wearers.tells_apart:
        looks = {
            "colors": np.array(wearers.colors, np.float32)[is_finite],
            "pass_index": wearers.pass_index,
            "randoms": np.array(wearers.randoms, np.float32)[is_finite],
        }
    core_scene.add_instances(
        mesh_id, world_from_object[is_finite], materials=list(wearers.materials), **looks
    )


def _as_array(matrices: list[Matrix]) -> np.ndarray:
    """(n, 4, 4); ten times as fast as `np.array`, which asks each matrix what it is."""
    numbers = (number for matrix in matrices for row in matrix for number in row)
    return np.fromiter(numbers, np.float64, 16 * len(matrices)).reshape(-1, 4, 4)


def _warn_of_hair(shown: bpy.types.Object, warn: Callable[[str], None]) -> None:
    for system in shown.particle_systems:
        if system.settings.type == "HAIR" and system.settings.render_type == "PATH":
            warn(f"Hair of '{shown.name}' is left out: hair strands are not supported")
