import bpy
import numpy as np
import pytest
from eye_render.export.mesh import add_mesh
from scenes import RecordingScene, add_object, quad_mesh
from tools.meshes import cube_mesh


def exported(mesh: bpy.types.Mesh, depsgraph_of, core_scene: RecordingScene | None = None):
    """The one mesh that the core is given for an object with this mesh."""
    core_scene = core_scene or RecordingScene()
    shown = add_object(mesh).evaluated_get(depsgraph_of())
    add_mesh(core_scene, shown.data, [0], reads_uvs=False)
    return core_scene.meshes[0] if core_scene.meshes else None


def test_faces_become_triangles_over_shared_vertices(scene, depsgraph_of):
    mesh = exported(cube_mesh(), depsgraph_of)
    assert mesh.positions.shape == (8, 3)
    assert mesh.positions.dtype == np.float32
    assert mesh.triangles.shape == (12, 3)
    corners = mesh.positions[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert np.all(np.einsum("ij,ij->i", normals, corners.mean(axis=1)) > 0), "outward winding"
    assert np.isclose(np.linalg.norm(normals, axis=1).sum() / 2, 24.0)


def test_faces_that_are_triangles_stay_as_they_are(scene, depsgraph_of):
    mesh = bpy.data.meshes.new("Triangles")
    mesh.from_pydata([(x, y, x * y) for x in (0, 1, 2) for y in (0, 1)], [],
                     [(4, 2, 0), (1, 3, 5), (0, 1, 3)])  # fmt: skip
    mesh.materials.append(bpy.data.materials.new("First"))
    mesh.materials.append(bpy.data.materials.new("Second"))
    mesh.polygons[1].material_index = 1
    result = exported(mesh, depsgraph_of)
    assert result.triangles.tolist() == [[4, 2, 0], [1, 3, 5], [0, 1, 3]]
    assert result.material_slots.tolist() == [0, 1, 0]


def test_a_flat_mesh_has_no_normals(scene, depsgraph_of):
    assert exported(cube_mesh(), depsgraph_of).normals is None


def test_a_smooth_mesh_has_one_normal_a_vertex(scene, depsgraph_of):
    mesh = cube_mesh()
    mesh.polygons.foreach_set("use_smooth", [True] * 6)
    normals = exported(mesh, depsgraph_of).normals
    expected = np.array([vertex.co.normalized() for vertex in mesh.vertices])
    assert np.allclose(normals, expected, atol=1e-4)


def test_a_partly_smooth_mesh_has_one_normal_a_triangle_corner(scene, depsgraph_of):
    mesh = cube_mesh()
    mesh.polygons.foreach_set("use_smooth", [True] * 5 + [False])
    result = exported(mesh, depsgraph_of)
    flat = [triangle.index for triangle in mesh.loop_triangles if triangle.polygon_index == 5]
    corner_normals = result.normals.reshape(-1, 3, 3)
    assert corner_normals.shape == (12, 3, 3)
    assert np.allclose(corner_normals[flat], mesh.polygons[5].normal, atol=1e-4)
    assert not np.allclose(corner_normals[0], corner_normals[0, 0], atol=0.1)


def test_custom_normals_are_kept(scene, depsgraph_of):
    mesh = quad_mesh()
    mesh.polygons.foreach_set("use_smooth", [True])
    if hasattr(mesh, "use_auto_smooth"):  # until Blender 4.0 custom normals need it
        mesh.use_auto_smooth = True
    tilted = np.array([0.6, 0.0, 0.8])
    mesh.normals_split_custom_set([tilted] * 4)
    normals = exported(mesh, depsgraph_of).normals
    assert np.allclose(normals, tilted, atol=1e-3)


def test_normals_of_corners_are_told_from_those_of_as_many_vertices(scene, depsgraph_of):
    mesh = bpy.data.meshes.new("Soup")  # every vertex is one corner's
    mesh.from_pydata(np.eye(3).repeat(2, axis=0).tolist(), [], [(0, 2, 4), (5, 3, 1)])
    mesh.polygons.foreach_set("use_smooth", [True, False])
    result = exported(mesh, depsgraph_of)
    assert len(result.positions) == 6
    assert result.normals.shape == (2, 3, 3)


def test_only_uv_layers_that_are_read_are_exported(scene, depsgraph_of):
    mesh = quad_mesh()
    mesh.uv_layers.new(name="Unread")
    result = exported(mesh, depsgraph_of, RecordingScene(uv_layers=["UVMap"]))
    assert list(result.uvs) == ["UVMap"]
    assert exported(quad_mesh(), depsgraph_of).uvs == {}


def test_the_nameless_uv_layer_is_the_active_one(scene, depsgraph_of):
    mesh = quad_mesh()
    mesh.uv_layers.new(name="Second").active_render = True
    result = exported(mesh, depsgraph_of, RecordingScene(uv_layers=[""]))
    assert result.active_uv == "Second"
    assert list(result.uvs) == ["Second"]


def test_uvs_belong_to_their_corners(scene, depsgraph_of):
    mesh = quad_mesh(size=1.0)  # its UV is its XY moved by one half
    result = exported(mesh, depsgraph_of, RecordingScene(uv_layers=["UVMap"]))
    corners = result.positions[result.triangles.ravel()]
    assert np.allclose(result.uvs["UVMap"], corners[:, :2] + 0.5)


@pytest.mark.parametrize("domain", ["POINT", "CORNER"])
def test_colour_attributes_belong_to_their_corners(scene, depsgraph_of, domain):
    mesh = quad_mesh(size=1.0)
    attribute = mesh.color_attributes.new("Col", "FLOAT_COLOR", domain)
    place = [mesh.vertices[loop.vertex_index].co for loop in mesh.loops]
    for item, co in zip(attribute.data, place, strict=True):
        item.color = (co.x + 0.5, co.y + 0.5, 0.0, 1.0)
    result = exported(mesh, depsgraph_of, RecordingScene(attributes=["Col"]))
    corners = result.positions[result.triangles.ravel()]
    assert np.allclose(result.attributes["Col"][:, :2], corners[:, :2] + 0.5)


VALUES = {
    "FLOAT": ("value", 0.5, (0.5, 0.5, 0.5, 1.0)),
    "INT": ("value", 3, (3.0, 3.0, 3.0, 1.0)),
    "BOOLEAN": ("value", True, (1.0, 1.0, 1.0, 1.0)),
    "FLOAT2": ("vector", (0.25, 0.5), (0.25, 0.5, 0.0, 1.0)),
    "FLOAT_VECTOR": ("vector", (0.25, 0.5, 2.0), (0.25, 0.5, 2.0, 1.0)),
    "FLOAT_COLOR": ("color", (0.25, 0.5, 2.0, 0.5), (0.25, 0.5, 2.0, 0.5)),
}


@pytest.mark.parametrize("kind", VALUES)
def test_attributes_of_each_kind_are_four_numbers(scene, depsgraph_of, kind):
    mesh = quad_mesh()
    member, value, expected = VALUES[kind]
    for item in mesh.attributes.new("A", kind, "POINT").data:
        setattr(item, member, value)
    result = exported(mesh, depsgraph_of, RecordingScene(attributes=["A"]))
    assert result.attributes["A"].shape == (6, 4)
    assert np.allclose(result.attributes["A"], expected)


def test_attributes_of_faces_belong_to_their_corners(scene, depsgraph_of):
    mesh = cube_mesh()
    numbers = mesh.attributes.new("Number", "FLOAT", "FACE")
    numbers.data.foreach_set("value", np.arange(6, dtype=np.float32))
    result = exported(mesh, depsgraph_of, RecordingScene(attributes=["Number"]))
    faces = [triangle.polygon_index for triangle in mesh.loop_triangles]
    assert np.allclose(result.attributes["Number"][:, 0], np.repeat(faces, 3))


def test_tangents_of_uv_maps_are_attributes_of_those_who_ask(scene, depsgraph_of):
    mesh = quad_mesh()
    uvs = mesh.uv_layers[0].data
    for item in uvs:  # u runs along -Y, v along -X: a mirrored map
        item.uv = (0.5 - item.uv.y, 0.5 - item.uv.x)
    for name in ("UVMap.tangent", ".tangent"):
        result = exported(mesh, depsgraph_of, RecordingScene(attributes=[name]))
        assert np.allclose(result.attributes[name], (0, -1, 0, -1), atol=1e-6)
    absent = exported(mesh, depsgraph_of, RecordingScene(attributes=["Other.tangent"]))
    assert absent.attributes == {}


def test_uv_maps_are_attributes_too(scene, depsgraph_of):
    result = exported(quad_mesh(), depsgraph_of, RecordingScene(attributes=["UVMap"]))
    corners = result.positions[result.triangles.ravel()]
    assert np.allclose(result.attributes["UVMap"][:, :2], corners[:, :2] + 0.5)


def test_what_a_mesh_does_not_have_is_not_exported(scene, depsgraph_of):
    mesh = quad_mesh()
    mesh.attributes.new("Crease", "FLOAT", "EDGE")
    result = exported(mesh, depsgraph_of, RecordingScene(attributes=["Crease", "None"]))
    assert result.attributes == {}


def test_generated_coordinates_fill_the_bounding_box(scene, depsgraph_of):
    origin, size = exported(cube_mesh(), depsgraph_of).texture_space
    assert np.allclose(origin, -1.0)
    assert np.allclose(size, 2.0)


def test_a_texture_space_of_ones_own_counts(scene, depsgraph_of):
    mesh = cube_mesh()
    mesh.use_auto_texspace = False
    mesh.texspace_location, mesh.texspace_size = (1.0, 0.0, 0.0), (2.0, 1.0, 0.5)
    origin, size = exported(mesh, depsgraph_of).texture_space
    assert np.allclose(origin, (-1.0, -1.0, -0.5))
    assert np.allclose(size, (4.0, 2.0, 1.0))


def test_each_triangle_has_the_slot_of_its_face(scene, depsgraph_of):
    mesh = cube_mesh()
    for name in ("First", "Second"):
        mesh.materials.append(bpy.data.materials.new(name))
    mesh.polygons[2].material_index = 1
    slots = exported(mesh, depsgraph_of).material_slots
    assert slots.tolist() == [0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0]


def test_a_mesh_with_one_slot_needs_none(scene, depsgraph_of):
    mesh = cube_mesh()
    mesh.materials.append(bpy.data.materials.new("Only"))
    assert exported(mesh, depsgraph_of).material_slots is None


def test_a_mesh_without_faces_is_not_exported(scene, depsgraph_of):
    mesh = bpy.data.meshes.new("Wire")
    mesh.from_pydata([(0, 0, 0), (1, 0, 0)], [(0, 1)], [])
    assert exported(mesh, depsgraph_of) is None
