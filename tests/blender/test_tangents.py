"""Smoothed tangents, beside those that Blender's own MikkTSpace gives a mesh of triangles."""

import bmesh
import bpy
import numpy as np
from eye_render.export.tangents import tangents_at_corners
from scenes import quad_mesh


def ball(is_of_triangles: bool) -> bpy.types.Mesh:
    """Smooth, its UV map bent, half of it mirrored."""
    mesh = bpy.data.meshes.new("Ball")
    shape = bmesh.new()
    bmesh.ops.create_uvsphere(shape, u_segments=12, v_segments=7, radius=1.0, calc_uvs=True)
    if is_of_triangles:
        bmesh.ops.triangulate(shape, faces=shape.faces)
    else:
        bmesh.ops.dissolve_edges(shape, edges=list(shape.edges)[::5])
    shape.loops.layers.uv.verify()
    for face in shape.faces:
        face.smooth = True
        for loop in face.loops:
            place = loop.vert.co
            loop[shape.loops.layers.uv.active].uv = (abs(place.x - 0.01), place.y + 0.3 * place.z)
    shape.to_mesh(mesh)
    return mesh


def corners_of(mesh: bpy.types.Mesh) -> np.ndarray:
    mesh.calc_loop_triangles()
    return np.array([triangle.loops for triangle in mesh.loop_triangles], np.int32)


def test_on_triangles_they_are_blender_s(scene):
    mesh = ball(is_of_triangles=True)
    corners = corners_of(mesh)
    ours = tangents_at_corners(mesh, corners, "")
    mesh.calc_tangents()
    theirs = np.array([[*loop.tangent, loop.bitangent_sign] for loop in mesh.loops])
    agreement = (ours[:, :3] * theirs[corners.ravel(), :3]).sum(axis=1)
    assert len(ours) > 300
    # But along the fold of the map, where triangles at a vertex that lie the same way round need
    # not be neighbours.
    assert np.mean(agreement > 0.9999) > 0.97
    assert np.mean(ours[:, 3] == theirs[corners.ravel(), 3]) > 0.97


def test_faces_of_many_sides_have_them_too(scene):
    mesh = ball(is_of_triangles=False)
    assert max(face.loop_total for face in mesh.polygons) > 4
    tangents = tangents_at_corners(mesh, corners_of(mesh), "")
    assert np.mean(np.abs(np.linalg.norm(tangents[:, :3], axis=1) - 1.0) < 1e-5) > 0.98


def test_a_mesh_without_the_map_has_none(scene):
    mesh = quad_mesh()
    assert tangents_at_corners(mesh, corners_of(mesh), "Nowhere") is None
