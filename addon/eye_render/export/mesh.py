"""Evaluated meshes to the core's arrays, by `foreach_get` alone."""

import bpy
import numpy as np

from .. import compat
from .attributes import attributes_at_corners


def add_mesh(
    core_scene, mesh: bpy.types.Mesh, material_ids: list[int], reads_uvs: bool
) -> int | None:
    """Hand the mesh over; None if it has no triangle.

    `material_ids` are all materials that some instance of the mesh wears: what none of them
    reads is not exported, nor the active UV map unless `reads_uvs` says that a pass does.
    """
    mesh.calc_loop_triangles()
    triangle_count = len(mesh.loop_triangles)
    if triangle_count == 0:
        return None
    corners = np.empty((triangle_count, 3), np.int32)
    mesh.loop_triangles.foreach_get("loops", corners.ravel())
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
        texture_space=_texture_space(mesh),
    )


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


def _texture_space(
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
