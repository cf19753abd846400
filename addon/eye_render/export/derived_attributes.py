"""Attributes that follow from a mesh's shape: how pointed it is, and which piece a face is of.

Both are what Cycles works out, in its order of steps, because their numbers depend on that.
"""

import bpy
import numpy as np

from .. import compat
from .object_random import hash_number

_LARGEST_HASH = 0xFFFFFFFF


def pointiness(mesh: bpy.types.Mesh) -> np.ndarray:
    """A number a vertex: 0.5 where flat, more on ridges, less in grooves; blurred by one edge."""
    positions = compat.vertex_positions(mesh)
    _, place_of = np.unique(
        positions, axis=0, return_inverse=True
    )  # vertices in one place are one
    place_of = place_of.ravel()
    count = int(place_of.max()) + 1
    edges = np.unique(np.sort(place_of[_edges(mesh)], axis=1), axis=0)
    edges = edges[edges[:, 0] != edges[:, 1]]
    first, second = edges.T
    normals = np.empty((len(positions), 3), np.float32)
    mesh.vertex_normals.foreach_get("vector", normals.ravel())
    normal = _unit(_sum_by(place_of, normals, count))
    at_place = np.empty((count, 3))
    at_place[place_of] = positions
    along = _unit(at_place[second] - at_place[first])
    valence = np.bincount(edges.ravel(), minlength=count)
    mean_edge = _sum_by(first, along, count) - _sum_by(second, along, count)
    mean_edge /= np.maximum(valence, 1)[:, None]
    cosine = np.clip(np.einsum("ij,ij->i", normal, mean_edge), -1.0, 1.0)
    raw = np.where(valence > 0, np.arccos(cosine) / np.pi, 0.0)
    sums = raw + np.bincount(first, raw[second], count) + np.bincount(second, raw[first], count)
    return (sums / (valence + 1.0))[place_of].astype(np.float32)


def island_randoms(mesh: bpy.types.Mesh) -> np.ndarray:
    """A number a vertex, from 0 to 1, the same for all that edges join."""
    count = len(mesh.vertices)
    parents, ranks = list(range(count)), [0] * count

    def root(vertex: int) -> int:
        while parents[vertex] != vertex:
            parents[vertex] = vertex = parents[parents[vertex]]
        return vertex

    # One by one: which vertex stands for an island, and so its number, is a matter of the order.
    for first, second in _edges(mesh).tolist():
        first, second = root(first), root(second)
        if first != second:
            if ranks[first] < ranks[second]:
                first, second = second, first
            parents[second] = first
            ranks[first] += ranks[first] == ranks[second]
    randoms = {
        vertex: hash_number(vertex, words=1) / _LARGEST_HASH
        for vertex in set(map(root, range(count)))
    }
    return np.array([randoms[root(vertex)] for vertex in range(count)], np.float32)


def _edges(mesh: bpy.types.Mesh) -> np.ndarray:
    edges = np.empty((len(mesh.edges), 2), np.int32)
    mesh.edges.foreach_get("vertices", edges.ravel())
    return edges


def _sum_by(place_of: np.ndarray, vectors: np.ndarray, count: int) -> np.ndarray:
    sums = [np.bincount(place_of, vectors[:, axis], count) for axis in range(3)]
    return np.stack(sums, axis=1)


def _unit(vectors: np.ndarray) -> np.ndarray:
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    return vectors / np.where(lengths > 0.0, lengths, 1.0)
