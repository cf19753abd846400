"""Tangents of a mesh's UV map as MikkTSpace smooths them (Mikkelsen 2008, "Simulation of Wrinkled
Surfaces Revisited", and his reference code), on triangles: Blender's own function leaves meshes
with faces of more than four sides alone, and Cycles takes triangles of all."""

import bpy
import numpy as np

from .. import compat


def tangents_at_corners(
    mesh: bpy.types.Mesh, corners: np.ndarray, uv_layer: str
) -> np.ndarray | None:
    """(triangles times 3, 4): a unit vector, and the sign of the bitangent; "" is the active
    layer. None of a mesh without the layer. `corners` are those of the triangles."""
    layers = mesh.uv_layers
    name = uv_layer or next((layer.name for layer in layers if layer.active_render), "")
    if name not in layers:
        return None
    vertices = compat.corner_vertices(mesh)[corners]
    positions = compat.vertex_positions(mesh)[vertices]
    normals = compat.corner_normals(mesh)[corners]
    return smoothed(vertices, positions, normals, compat.corner_uvs(layers[name])[corners])


def smoothed(
    vertices: np.ndarray, positions: np.ndarray, normals: np.ndarray, uvs: np.ndarray
) -> np.ndarray:
    """All (triangles, 3, ...). Corners at one vertex share their tangent if they have the same
    normal and UV and their triangles lie the same way round in the map."""
    edge1, edge2 = positions[:, 1] - positions[:, 0], positions[:, 2] - positions[:, 0]
    uv1, uv2 = uvs[:, 1] - uvs[:, 0], uvs[:, 2] - uvs[:, 0]
    is_kept = uv1[:, 0] * uv2[:, 1] > uv1[:, 1] * uv2[:, 0]
    sign = np.where(is_kept, 1.0, -1.0)
    along = sign[:, None] * (uv2[:, 1:] * edge1 - uv1[:, 1:] * edge2)
    along = _in_plane(along[:, None], normals)
    angle = _angle(positions, normals)
    shared = _numbered(
        [*uvs.reshape(-1, 2).T, *normals.reshape(-1, 3).T, np.repeat(sign, 3), vertices.ravel()]
    )
    weighted = (along * angle[..., None]).reshape(-1, 3)
    sums = np.stack([np.bincount(shared, weighted[:, axis]) for axis in range(3)], axis=1)
    tangents = _unit(sums)[shared]
    return np.column_stack([tangents, np.repeat(sign, 3)]).astype(np.float32)


def _numbered(columns: list[np.ndarray]) -> np.ndarray:
    """A number for each row, the same for equal rows."""
    order = np.lexsort(columns)
    is_new = np.zeros(len(order), bool)
    for column in columns:
        is_new[1:] |= np.diff(column[order]) != 0
    numbers = np.empty(len(order), np.int64)
    numbers[order] = np.cumsum(is_new)
    return numbers


def _angle(positions: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """At each corner, seen along its normal."""
    before = _in_plane(np.roll(positions, 1, axis=1) - positions, normals)
    after = _in_plane(np.roll(positions, -1, axis=1) - positions, normals)
    return np.arccos(np.clip((before * after).sum(axis=-1), -1.0, 1.0))


def _in_plane(vectors: np.ndarray, normals: np.ndarray) -> np.ndarray:
    return _unit(vectors - normals * (vectors * normals).sum(axis=-1, keepdims=True))


def _unit(vectors: np.ndarray) -> np.ndarray:
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(lengths > 0.0, lengths, 1.0)
