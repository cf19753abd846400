import bpy
import numpy as np
import pytest
from eye_render.export.derived_attributes import island_randoms, pointiness
from scenes import quad_mesh
from tools.meshes import cube_mesh


@pytest.fixture(autouse=True)
def empty(scene):
    """Meshes are made in an empty file."""


def test_a_plane_is_half_pointed():
    assert np.allclose(pointiness(quad_mesh()), 0.5, atol=1e-6)


def test_corners_of_a_cube_are_more_pointed_than_those_of_its_inside():
    cube = cube_mesh()
    # Each edge leaves a corner at the angle whose cosine is -1 / sqrt(3) to the corner's normal.
    angle = np.arccos(-1.0 / np.sqrt(3.0)) / np.pi
    assert np.allclose(pointiness(cube), angle, atol=1e-3)
    cube.flip_normals()
    assert np.allclose(pointiness(cube), 1.0 - angle, atol=1e-3)


def test_vertices_in_one_place_are_equally_pointed():
    joined, split = cube_mesh(), bpy.data.meshes.new("Split")
    corners = [joined.vertices[i].co for face in joined.polygons for i in face.vertices]
    split.from_pydata(corners, [], np.arange(24).reshape(6, 4).tolist())
    assert np.allclose(pointiness(split), pointiness(joined)[0], atol=1e-3)


def test_a_broken_mesh_has_finite_pointiness():
    mesh = bpy.data.meshes.new("Broken")
    mesh.from_pydata([(0, 0, 0), (0, 0, 0), (1, 0, 0), (5, 5, 5)], [], [(0, 1, 2)])
    assert np.isfinite(pointiness(mesh)).all()


def test_each_island_has_one_number():
    mesh = bpy.data.meshes.new("Two")
    corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (5, 0, 0), (6, 0, 0), (5, 1, 0)]
    mesh.from_pydata(corners, [], [(0, 1, 2), (3, 4, 5)])
    numbers = island_randoms(mesh)
    assert len(set(numbers[:3].tolist())) == len(set(numbers[3:].tolist())) == 1
    assert numbers[0] != numbers[3]
    assert np.all((numbers >= 0) & (numbers <= 1))
