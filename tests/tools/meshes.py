"""Meshes that tests show. Inside Blender."""

import bpy
import numpy as np


def cube_mesh(size: float = 2.0, name: str = "Cube") -> bpy.types.Mesh:
    """Around the origin; each face with UVs from 0 to 1."""
    half = size / 2
    corners = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], faces)
    uvs = [(0, 0), (1, 0), (1, 1), (0, 1)] * 6
    mesh.uv_layers.new(name="UVMap").data.foreach_set("uv", np.array(uvs, np.float32).ravel())
    return mesh
