"""What no renderer is made for is in files all the same: it neither crashes it nor spoils what
else is in the picture."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix
from scenes import (
    add_node,
    add_object,
    emitter,
    link,
    node_material,
    quad_mesh,
    surface,
)
from tools.meshes import cube_mesh

GREEN = (0.0, 1.0, 0.0)
FLOAT_MAX = float(np.finfo(np.float32).max)
FAR_AWAY = 1e6  # half of a millimetre times this is what float can tell


@pytest.fixture
def wall(scene) -> bpy.types.Object:
    """Glows green behind everything and fills the picture; a matte square is before its middle,
    so that there is something to light."""
    mesh = quad_mesh("Wall", size=100.0)
    mesh.materials.append(emitter(GREEN))
    shown = add_object(mesh, "Wall")
    shown.location.z = -20.0
    add_object(quad_mesh("Matte", size=2.0)).location.z = -15.0
    return shown


def set_vertices(mesh: bpy.types.Mesh, number: float) -> bpy.types.Mesh:
    """Every third coordinate becomes the number."""
    positions = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", positions)
    positions[::3] = number
    mesh.vertices.foreach_set("co", positions)
    return mesh


def smooth(mesh: bpy.types.Mesh) -> bpy.types.Mesh:
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    return mesh


def without_area() -> bpy.types.Mesh:
    mesh = bpy.data.meshes.new("Flat")
    corners = [(0, 0, -5), (1, 1, -5), (2, 2, -5), (1, 1, -5)]
    mesh.from_pydata(corners, [], [(0, 1, 2), (1, 3, 2), (0, 1, 3, 2)])
    return mesh


MESHES = {
    "no vertex": lambda: bpy.data.meshes.new("Empty"),
    "faces without area": without_area,
    "smooth faces without area": lambda: smooth(without_area()),
    "vertices not a number": lambda: set_vertices(cube_mesh(), np.nan),
    "smooth vertices not a number": lambda: smooth(set_vertices(cube_mesh(), np.nan)),
    "vertices at infinity": lambda: set_vertices(cube_mesh(), np.inf),
    "vertices at the end of float": lambda: set_vertices(cube_mesh(), FLOAT_MAX),
    "vertices as close as float can tell": lambda: set_vertices(cube_mesh(), 1e-38),
}


@pytest.mark.parametrize("name", MESHES)
def test_a_broken_mesh_leaves_the_rest_of_the_picture_alone(wall, render, name):
    add_object(MESHES[name]()).location = (0.0, 0.0, -10.0)
    add_object(bpy.data.lights.new("Lamp", "POINT"))
    pixels = render()
    assert np.all(np.isfinite(pixels))
    assert np.allclose(pixels[:, 0], (*GREEN, 1.0)), "the left edge shows the wall"


MATRICES = {
    "no size": Matrix.Diagonal((0, 0, 0, 1)),
    "no thickness": Matrix.Diagonal((1, 1, 0, 1)),
    "size not a number": Matrix.Diagonal((np.nan, 1, 1, 1)),
    "place at infinity": Matrix.Translation((np.inf, 0, -10)),
    "huge size": Matrix.Diagonal((FLOAT_MAX, FLOAT_MAX, FLOAT_MAX, 1)),
    "tiny size": Matrix.Diagonal((1e-38, 1e-38, 1e-38, 1)),
}


@pytest.mark.parametrize("kind", ["MESH", "POINT", "SUN", "SPOT", "AREA"])
@pytest.mark.parametrize("name", MATRICES)
def test_a_broken_matrix_leaves_the_rest_of_the_picture_alone(wall, render, name, kind):
    data = cube_mesh() if kind == "MESH" else bpy.data.lights.new("Broken", kind)
    add_object(data, "Broken").matrix_world = MATRICES[name]
    pixels = render()
    assert np.all(np.isfinite(pixels))
    assert np.allclose(pixels[:, 0], (*GREEN, 1.0)), "the left edge shows the wall"


@pytest.mark.parametrize("kind", ["MESH", "POINT"])
def test_what_is_at_no_finite_place_is_named(wall, render, capfd, kind):
    data = cube_mesh() if kind == "MESH" else bpy.data.lights.new("Cube", kind)
    add_object(data).matrix_world = MATRICES["place at infinity"]
    render()
    (said,) = (line for line in capfd.readouterr().out.splitlines() if "warning" in line)
    assert "'Cube' is left out" in said


@pytest.mark.parametrize("kind", ["POINT", "SUN", "SPOT", "AREA"])
def test_a_lamp_without_extent_lights_finitely(scene, render, kind):
    light = bpy.data.lights.new("Lamp", kind)
    for size in ("shadow_soft_size", "angle", "size", "size_y", "spot_size"):
        if hasattr(light, size):
            setattr(light, size, 0.0)
    add_object(light).location.z = 1.0
    add_object(quad_mesh(size=100.0)).location.z = -5.0
    assert np.all(np.isfinite(render()))


def test_a_mirrored_object_is_lit_like_another(scene, render):
    add_object(bpy.data.lights.new("Sun", "SUN")).rotation_euler.x = 0.5
    shown = add_object(smooth(quad_mesh(size=100.0)))
    shown.location.z = -5.0
    straight = render()
    shown.scale.x = -1.0
    assert straight[..., :3].min() > 0.1
    assert np.allclose(render(), straight, atol=1e-5)


def test_what_is_far_from_the_origin_looks_as_near_it(scene, wall, render):
    scene.camera.location = (FAR_AWAY, -FAR_AWAY, FAR_AWAY)
    wall.location = (FAR_AWAY, -FAR_AWAY, FAR_AWAY - 20.0)
    assert np.allclose(render()[..., :3], GREEN)


@pytest.mark.parametrize("number", [np.nan, np.inf, FLOAT_MAX])
def test_broken_uvs_show_some_colour(scene, render, number):
    image = bpy.data.images.new("Picture", 4, 4)
    material = node_material()
    texture = add_node(material, "ShaderNodeTexImage", image=image)
    glow = surface(material, "ShaderNodeEmission")
    link(material, texture.outputs["Color"], glow.inputs["Color"])
    mesh = quad_mesh(size=100.0)
    mesh.materials.append(material)
    mesh.uv_layers[0].data.foreach_set("uv", [number] * 8)
    add_object(mesh).location.z = -5.0
    assert np.all(np.isfinite(render()))
