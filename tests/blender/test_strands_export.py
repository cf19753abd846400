"""Hair of particles, hair curves and point clouds as strands and balls of the core."""

import bpy
import numpy as np
import pytest
from eye_render.export.hair import HairSource
from scenes import RecordingScene, add_object, quad_mesh


def haired(mesh: bpy.types.Mesh, count: int = 10, **settings) -> bpy.types.Object:
    shown = add_object(mesh)
    modifier = shown.modifiers.new("Hair", "PARTICLE_SYSTEM")
    hair = modifier.particle_system.settings
    hair.type, hair.count, hair.hair_length, hair.render_step, hair.display_step = (
        "HAIR",
        count,
        2.0,
        2,
        2,
    )
    hair.root_radius, hair.tip_radius, hair.radius_scale = 1.0, 0.5, 0.1
    for name, value in settings.items():
        setattr(hair, name, value)
    return shown


def test_strands_stand_on_the_surface(scene, export):
    shown = haired(quad_mesh())
    shown.location.x, shown.scale = 5.0, (2.0, 2.0, 2.0)
    result = export()
    (curves,) = result.curves
    keys = curves.positions.reshape(10, 5, 3)
    assert curves.first_keys.tolist() == list(range(0, 50, 5))
    # In the object's own space, where the quad lies in z = 0 around the origin.
    assert np.abs(keys[:, 0, 2]).max() < 1e-5
    assert np.abs(keys[:, 0, :2]).max() <= 1.0 + 1e-5
    assert keys[:, -1, 2].min() > 0.5
    hair = next(item for item in result.instances if item.geometry == 1)
    assert hair.world_from_object[0, 0].tolist() == [2.0, 0.0, 0.0, 5.0]


def test_radius_goes_from_root_to_tip(scene, export):
    haired(quad_mesh())
    radii = export().curves[0].radii.reshape(10, 5)
    np.testing.assert_allclose(radii[:, 0], 0.05, rtol=1e-5)
    np.testing.assert_allclose(radii[:, 2], 0.0375, rtol=1e-2)
    assert np.abs(radii[:, -1]).max() == 0.0  # the tip is closed


def test_an_open_tip_keeps_its_radius(scene, export):
    haired(quad_mesh(), use_close_tip=False)
    radii = export().curves[0].radii.reshape(10, 5)
    np.testing.assert_allclose(radii[:, -1], 0.025, rtol=1e-5)


def test_hair_wears_the_material_of_its_system(scene, export):
    mesh = quad_mesh()
    for name in ("Skin", "Hair"):
        mesh.materials.append(bpy.data.materials.new(name))
    haired(mesh, material=2)
    result = export()
    names = {item.geometry: [result.materials[i].name for i in item.materials]
             for item in result.instances}  # fmt: skip
    assert names == {0: ["Skin", "Hair"], 1: ["Hair"]}


def test_a_hidden_emitter_keeps_its_hair(scene, export):
    shown = haired(quad_mesh())
    shown.show_instancer_for_viewport = shown.show_instancer_for_render = False
    result = export()
    assert len(result.curves) == 1
    assert result.meshes == []


def test_a_collection_of_furry_objects_has_its_hair_once(scene, export):
    inner = bpy.data.collections.new("Inner")
    shown = haired(quad_mesh())
    scene.collection.objects.unlink(shown)
    inner.objects.link(shown)
    for y in (1.0, 2.0):
        empty = add_object(None)
        empty.instance_type, empty.instance_collection, empty.location.y = "COLLECTION", inner, y
    result = export()
    assert len(result.curves) == 1
    hair = next(item for item in result.instances if item.geometry == 1)
    assert sorted(hair.world_from_object[:, 1, 3].tolist()) == [1.0, 2.0]
    assert np.abs(result.curves[0].positions[:, 1]).max() < 3.0  # without the empties' places


@pytest.mark.parametrize("shape, expected", [("RIBBONS", "RIBBON"), ("THICK", "ROUND")])
def test_the_shape_is_that_of_cycles(scene, export, shape, expected):
    if not hasattr(scene, "cycles_curves"):
        pytest.skip("this Blender has no Cycles")
    scene.cycles_curves.shape = shape
    haired(quad_mesh())
    assert export().curves[0].shape == expected


def test_roots_know_the_uv_of_the_surface(scene, depsgraph_of):
    mesh = quad_mesh()
    layer = mesh.uv_layers.active
    layer.data.foreach_set("uv", np.tile([0.25, 0.75], len(layer.data)).astype(np.float32))
    layer_name = layer.name
    shown = haired(mesh).evaluated_get(depsgraph_of())
    core_scene = RecordingScene(uv_layers=[""])
    HairSource(shown, shown.modifiers["Hair"], scene).add(core_scene, [0], False, [])
    (curves,) = core_scene.curves
    np.testing.assert_allclose(curves.uvs[layer_name], np.tile([0.25, 0.75], (10, 1)), atol=1e-5)
    assert curves.active_uv == layer_name


def test_the_filter_of_a_view_layer_leaves_out_surfaces_or_strands(scene, export):
    haired(quad_mesh())
    layer = bpy.context.view_layer
    layer.use_solid = False
    surfaces_off = export()
    assert (len(surfaces_off.meshes), len(surfaces_off.curves)) == (0, 1)
    layer.use_solid, layer.use_strand = True, False
    strands_off = export()
    assert (len(strands_off.meshes), len(strands_off.curves)) == (1, 0)
