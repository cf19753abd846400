"""Evaluated meshes to the core's arrays, by `foreach_get` alone."""

from collections.abc import Sequence

import bpy
import numpy as np

from .. import compat
from .attributes import attributes_at_corners
from .pose import Pose, motion_arguments


class MeshSource:
    def __init__(self, mesh: bpy.types.Mesh, _scene: bpy.types.Scene):
        self.name = mesh.name
        self.key = (mesh.as_pointer(), "")
        self.part = ""
        self._mesh = mesh

    def worn(self, slots: tuple[int, ...]) -> tuple[int, ...]:
        return slots

    def pose(self) -> Pose:
        corners = _triangle_corners(self._mesh)
        return Pose(compat.vertex_positions(self._mesh), _normals(self._mesh, corners))

    def add(
        self, core_scene, material_ids: list[int], reads_uvs: bool, motion: list[Pose]
    ) -> int | None:
        return add_mesh(core_scene, self._mesh, material_ids, reads_uvs, motion)


def add_mesh(
    core_scene,
    mesh: bpy.types.Mesh,
    material_ids: list[int],
    reads_uvs: bool,
    motion: Sequence[Pose] = (),
) -> int | None:
    """Hand the mesh over; None if it has no triangle.

    `material_ids` are all materials that some instance of the mesh wears: what none of them
    reads is not exported, nor the active UV map unless `reads_uvs` says that a pass does.
    """
    corners = _triangle_corners(mesh)
    triangle_count = len(corners)
    if triangle_count == 0:
        return None
    triangles = compat.corner_vertices(mesh)[corners]
    positions = compat.vertex_positions(mesh)
    uvs_read = core_scene.uv_layers_read(material_ids) + ([""] if reads_uvs else [])
    active_uv, uvs = _uvs(mesh, corners, uvs_read)
    return core_scene.add_mesh(
        mesh.name,
        positions,
        triangles,
        normals=_normals(mesh, corners),
        uvs=uvs,
        attributes=attributes_at_corners(
            mesh, corners, triangles, core_scene.attributes_read(material_ids)
        ),
        material_slots=_material_slots(mesh, triangle_count),
        active_uv=active_uv,
        texture_space=texture_space(mesh),
        **motion_arguments(motion),
    )


def _triangle_corners(mesh: bpy.types.Mesh) -> np.ndarray:
    """(triangles, 3)"""
    mesh.calc_loop_triangles()
    if len(mesh.loops) == 3 * len(mesh.polygons):
        # All faces are triangles: a million of them take 1 ms, and 130 ms as below.
        return np.arange(len(mesh.loops), dtype=np.int32).reshape(-1, 3)
    corners = np.empty((len(mesh.loop_triangles), 3), np.int32)
    mesh.loop_triangles.foreach_get("loops", corners.ravel())
    return corners


def _normals(mesh: bpy.types.Mesh, corners: np.ndarray) -> np.ndarray | None:
    """None for a flat mesh, one normal a vertex for a smooth one, else one a triangle corner."""
    domain = compat.normals_domain(mesh)
    if domain == "FACE":
        return None
    if domain == "POINT":
        normals = np.empty((len(mesh.vertices), 3), np.float32)
        mesh.vertex_normals.foreach_get("vector", normals.ravel())
        return normals
    return compat.corner_normals(mesh)[corners]


def _uvs(
    mesh: bpy.types.Mesh, corners: np.ndarray, names_read: list[str]
) -> tuple[str, dict[str, np.ndarray]]:
    """The name of the layer that "" stands for, and the layers read, one UV a triangle corner."""
    active = next((layer.name for layer in mesh.uv_layers if layer.active_render), "")
    wanted = {name or active for name in names_read}
    uvs = {
        layer.name: compat.corner_uvs(layer)[corners.ravel()]
        for layer in mesh.uv_layers
        if layer.name in wanted
    }
    return (active if active in uvs else ""), uvs


def texture_space(
    mesh: bpy.types.Mesh,
) -> tuple[tuple[float, ...], tuple[float, ...]] | None:
    """Where the coordinates Generated are zero, and how far it is from there to one.

    None for a broken mesh, whose vertices are anywhere.
    """
    middle, half = np.array(mesh.texspace_location), np.array(mesh.texspace_size)
    if not np.isfinite((middle, half)).all():
        return None
    half = np.where(half == 0.0, 1.0, half)
    return tuple(middle - half), tuple(2.0 * half)


def _material_slots(mesh: bpy.types.Mesh, triangle_count: int) -> np.ndarray | None:
    """The slot of each triangle; None if there is only one to choose."""
    if len(mesh.materials) < 2:
        return None
    slots = np.empty(triangle_count, np.int32)
    mesh.loop_triangles.foreach_get("material_index", slots)
    # Blender shows faces whose slot was removed in the last slot that is left.
    return np.clip(slots, 0, len(mesh.materials) - 1)
