from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from eye_render.cryptomatte import MatteNames
from eye_render.export.image import ImageTable
from eye_render.export.instances import export_instances
from eye_render.export.light import LightTable
from eye_render.export.material import MaterialTable
from eye_render.export.object_properties import PropertyReader
from scenes import (
    RecordingScene,
    add_node,
    add_object,
    link,
    node_material,
    quad_mesh,
    surface,
)
from tools.meshes import cube_mesh


def places(core_scene: RecordingScene) -> list[tuple[float, ...]]:
    matrices = np.concatenate([item.world_from_object for item in core_scene.instances])
    return sorted(tuple(matrix[:3, 3].tolist()) for matrix in matrices)


def test_objects_that_share_a_mesh_export_it_once(scene, export):
    mesh = cube_mesh()
    for x in (0.0, 3.0):
        add_object(mesh).location.x = x
    result = export()
    assert len(result.meshes) == 1
    assert places(result) == [(0.0, 0.0, 0.0), (3.0, 0.0, 0.0)]


def test_a_modifier_makes_a_mesh_of_its_own(scene, export):
    mesh = cube_mesh()
    add_object(mesh)
    modified = add_object(mesh)
    modified.modifiers.new("Array", "ARRAY").count = 3
    counts = sorted(len(item.triangles) for item in export().meshes)
    assert counts == [12, 36]


def test_collection_instances_are_matrices(scene, export):
    inner = bpy.data.collections.new("Inner")
    inner.objects.link(bpy.data.objects.new("Cube", cube_mesh()))
    for y in (1.0, 2.0, 3.0):
        empty = add_object(None)
        empty.instance_type = "COLLECTION"
        empty.instance_collection = inner
        empty.location.y = y
    result = export()
    assert len(result.meshes) == 1
    assert places(result) == [(0.0, 1.0, 0.0), (0.0, 2.0, 0.0), (0.0, 3.0, 0.0)]


def test_faces_instance_their_children_and_the_instancer_hides(scene, export):
    parent = add_object(cube_mesh(name="Parent"))
    child = add_object(quad_mesh("Child", size=0.1))
    child.parent = parent
    parent.instance_type = "FACES"
    parent.show_instancer_for_render = False
    parent.show_instancer_for_viewport = False  # this depsgraph is the viewport's
    result = export()
    assert [mesh.name for mesh in result.meshes] == ["Child"]
    assert len(places(result)) == 6 + 1  # the child itself stays visible, as in Cycles


def test_curves_texts_surfaces_and_metaballs_are_exported_once(scene, export):
    bpy.ops.object.text_add()
    bpy.ops.curve.primitive_bezier_circle_add()
    bpy.context.object.data.bevel_depth = 0.1
    bpy.ops.surface.primitive_nurbs_surface_sphere_add()
    bpy.ops.object.metaball_add()
    result = export()
    assert len(result.meshes) == 4
    assert len(places(result)) == 4
    assert result.warnings == []


def test_slots_linked_to_the_object_win_and_share_the_mesh(scene, export):
    mesh = cube_mesh()
    mesh.materials.append(bpy.data.materials.new("OfData"))
    add_object(mesh)
    own = add_object(mesh)
    own.material_slots[0].link = "OBJECT"
    own.material_slots[0].material = bpy.data.materials.new("OfObject")
    result = export()
    assert len(result.meshes) == 1
    worn = {result.materials[item.materials[0]].name for item in result.instances}
    assert worn == {"OfData", "OfObject"}


def test_an_object_without_material_wears_a_default(scene, export):
    add_object(cube_mesh())
    result = export()
    (worn,) = (item.materials for item in result.instances)
    assert result.materials[worn[0]].surface is not None


def test_an_unsupported_kind_of_object_is_named(scene, export):
    add_object(bpy.data.volumes.new("Fog"), "Fog")
    assert export().warnings == ["Volume 'Fog' is left out: this kind of object is not supported"]


def test_smoke_is_named_and_its_box_left_out(export, scene):
    domain = add_object(quad_mesh(), "Domain")
    fluid = domain.modifiers.new("Fluid", "FLUID")
    fluid.fluid_type = "DOMAIN"
    exported = export()
    assert exported.instances == []
    (warning,) = exported.warnings
    assert warning.startswith("Smoke of 'Domain' is left out")


def test_matrices_keep_double_precision_and_column_vectors(scene, export):
    shown = add_object(cube_mesh())
    shown.location = (1.0, 2.0, 3.0)
    shown.scale = (2.0, 3.0, 4.0)
    (item,) = export().instances
    expected = [[2, 0, 0, 1], [0, 3, 0, 2], [0, 0, 4, 3], [0, 0, 0, 1]]
    assert item.world_from_object.dtype == np.float64
    assert np.allclose(item.world_from_object, [expected])


def object_info_material() -> bpy.types.Material:
    material = node_material("Told apart")
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    info = add_node(material, "ShaderNodeObjectInfo")
    link(material, info.outputs["Color"], diffuse.inputs["Color"])
    return material


def test_instances_tell_what_the_object_info_node_asks(scene, export):
    mesh = cube_mesh()
    mesh.materials.append(object_info_material())
    for color in ((1.0, 0.0, 0.0, 1.0), (0.0, 1.0, 0.0, 0.5)):
        shown = add_object(mesh)
        shown.color, shown.pass_index = color, 7
    (told,) = export().instances
    assert sorted(told.colors.tolist()) == [[0.0, 1.0, 0.0, 0.5], [1.0, 0.0, 0.0, 1.0]]
    assert told.pass_index == 7
    assert len(set(told.randoms.tolist())) == 2
    assert np.all((told.randoms >= 0) & (told.randoms < 1))


def test_instances_tell_nothing_that_nobody_asks(scene, export):
    add_object(cube_mesh()).color = (1.0, 0.0, 0.0, 1.0)
    (told,) = export().instances
    assert not hasattr(told, "colors")


def test_objects_hide_from_kinds_of_rays(scene, export):
    shown = add_object(cube_mesh())
    shown.visible_glossy = shown.visible_shadow = False
    (told,) = export().instances
    assert told.hidden_from == ("GLOSSY", "SHADOW")
    assert not told.is_holdout


def test_an_instance_hides_as_its_object_or_as_the_one_that_places_it(scene, export):
    inner = bpy.data.collections.new("Inner")
    cube = bpy.data.objects.new("Cube", cube_mesh())
    cube.visible_diffuse = False
    inner.objects.link(cube)
    empty = add_object(None)
    empty.instance_type, empty.instance_collection = "COLLECTION", inner
    empty.visible_camera = False
    (told,) = export().instances
    assert told.hidden_from == ("CAMERA", "DIFFUSE")


@pytest.mark.parametrize("where", ["object", "collection"])
def test_holdouts_of_objects_and_collections_are_cut_out(scene, export, where):
    collection = bpy.data.collections.new("Cut out")
    scene.collection.children.link(collection)
    shown = bpy.data.objects.new("Cube", cube_mesh())
    collection.objects.link(shown)
    shown.is_holdout = where == "object"
    layer = bpy.context.view_layer.layer_collection.children["Cut out"]
    layer.holdout = where == "collection"
    (told,) = export().instances
    assert told.is_holdout


def test_a_collection_seen_only_indirectly_is_hidden_from_the_camera(scene, export):
    collection = bpy.data.collections.new("Aside")
    scene.collection.children.link(collection)
    collection.objects.link(bpy.data.objects.new("Cube", cube_mesh()))
    bpy.context.view_layer.layer_collection.children["Aside"].indirect_only = True
    (told,) = export().instances
    assert told.hidden_from == ("CAMERA",)


def test_a_shadow_catcher_is_one_in_the_core(scene, export):
    add_object(cube_mesh(), "Floor").is_shadow_catcher = True
    (told,) = export().instances
    assert told.is_shadow_catcher


def test_objects_are_named_only_for_cryptomatte(scene, export):
    box, lid = add_object(cube_mesh(), "Box"), add_object(cube_mesh(), "Lid")
    lid.parent = box
    assert {told.name for told in export().instances} == {""}
    scene.view_layers[0].use_pass_cryptomatte_asset = True
    assert {(told.name, told.asset) for told in export().instances} == {
        ("Box", "Box"),
        ("Lid", "Box"),
    }


@pytest.fixture
def properties_of(depsgraph_of):
    """What the attributes of those names are for each instance of the scene."""

    def run(*names: str) -> list[dict[str, list[float]]]:
        core_scene = RecordingScene(attributes=list(names))
        images = ImageTable(core_scene, 1, print)
        materials = MaterialTable(core_scene, images, None, print)
        lights = LightTable(core_scene, images, print)
        names = MatteNames(set(), set(), set())
        export_instances(core_scene, depsgraph_of(), materials, lights, names, print, lambda: None)
        return [
            {name: values[row].tolist() for name, values in item.attributes.items()}
            for item in core_scene.instances
            for row in range(len(item.world_from_object))
        ]

    return run


def test_properties_of_objects_are_told_by_name(scene, properties_of):
    shown = add_object(cube_mesh())
    shown["tone"] = 0.5
    shown["paint"] = (0.25, 0.5)
    shown.color = (0.1, 0.2, 0.3, 0.4)
    (found,) = properties_of(
        ".eye_render.object.tone",
        ".eye_render.object.paint",
        ".eye_render.object.color",
        ".eye_render.object.absent",
    )
    assert found[".eye_render.object.tone"] == [0.5, 0.5, 0.5, 1.0]
    assert found[".eye_render.object.paint"] == [0.25, 0.5, 0.0, 1.0]
    assert found[".eye_render.object.color"] == pytest.approx([0.1, 0.2, 0.3, 0.4])
    assert found[".eye_render.object.absent"] == [0.0] * 4


def test_properties_of_the_mesh_stand_in_for_those_of_the_object(scene, properties_of):
    add_object(cube_mesh()).data["tone"] = 2
    (found,) = properties_of(".eye_render.object.tone")
    assert found[".eye_render.object.tone"] == [2.0, 2.0, 2.0, 1.0]


def test_instancers_are_asked_before_what_they_instance(scene, properties_of):
    inner = bpy.data.collections.new("Inner")
    cube = bpy.data.objects.new("Cube", cube_mesh())
    cube["tone"], cube["own"] = 0.25, 0.75
    inner.objects.link(cube)
    for tone in (0.5, 1.0):
        empty = add_object(None)
        empty.instance_type, empty.instance_collection = "COLLECTION", inner
        empty["tone"] = tone
    name = ".eye_render.instancer."
    found = properties_of(name + "tone", name + "own", ".eye_render.object.tone")
    assert sorted(item[name + "tone"][0] for item in found) == [0.5, 1.0]
    assert {item[name + "own"][0] for item in found} == {0.75}
    assert {item[".eye_render.object.tone"][0] for item in found} == {0.25}


def test_the_view_layer_is_asked_before_the_scene(scene, properties_of):
    add_object(cube_mesh())
    scene["fog"], scene["tone"] = 0.25, 0.5
    bpy.context.view_layer["tone"] = 0.75
    name = ".eye_render.view_layer."
    (found,) = properties_of(name + "fog", name + "tone")
    assert (found[name + "fog"][0], found[name + "tone"][0]) == (0.25, 0.75)


def test_particles_tell_what_places_an_instance(scene, properties_of):
    cube = add_object(cube_mesh())
    emitter = add_object(cube_mesh())
    emitter.modifiers.new("Particles", "PARTICLE_SYSTEM")
    settings = emitter.particle_systems[0].settings
    settings.count, settings.frame_start, settings.frame_end = 2, 1, 1
    settings.lifetime, settings.physics_type = 30, "NEWTON"
    settings.normal_factor, settings.effector_weights.gravity = 2.0, 0.0
    settings.render_type, settings.instance_object = "OBJECT", cube
    settings.particle_size = 0.25
    for frame in (1, 2, 3):
        scene.frame_set(frame)
    name = ".eye_render.particle."
    outputs = ("Index", "Random", "Age", "Lifetime", "Size", "Location", "Velocity")
    found = properties_of(*(name + output for output in outputs))
    rows = [[item[name + output] for output in outputs] for item in found]
    # Neither the cube itself nor the emitter is placed by a particle; number 0 is hashed, too.
    nobody = [row for row in rows if row[3][0] == 0.0]
    assert len(nobody) == 2
    born = sorted((row for row in rows if row[3][0] == 30.0), key=lambda row: row[0])
    assert [row[0][0] for row in born] == [0.0, 1.0]
    assert nobody[0][1] == born[0][1] != born[1][1]
    particles = emitter.evaluated_get(bpy.context.evaluated_depsgraph_get()).particle_systems[0]
    for row, particle in zip(born, particles.particles, strict=True):
        assert row[2][0] == pytest.approx(3.0 - particle.birth_time)
        assert row[4][0] == pytest.approx(0.25)
        assert row[5][:3] == pytest.approx(list(particle.location))
        assert np.linalg.norm(row[6][:3]) == pytest.approx(2.0, rel=0.01)


def test_an_emitter_tells_where_it_places_an_instance(scene, properties_of):
    cube, emitter = add_object(cube_mesh()), add_object(cube_mesh())
    emitter.modifiers.new("Particles", "PARTICLE_SYSTEM")
    settings = emitter.particle_systems[0].settings
    settings.type, settings.count = "HAIR", 6
    settings.render_type, settings.instance_object = "OBJECT", cube
    found = properties_of(".eye_render.place.Generated")
    placed = sorted(tuple(item[".eye_render.place.Generated"][:3]) for item in found)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    expected = [
        tuple(0.5 * number - 0.5 for number in instance.orco)
        for instance in depsgraph.object_instances
        if instance.is_instance
    ]
    assert len(set(expected)) == 6
    nobody = [(0.0, 0.0, 0.0)] * 2  # places the cube itself, and the emitter
    for found_at, expected_at in zip(placed, sorted(expected + nobody), strict=True):
        assert found_at == pytest.approx(expected_at)


def test_what_nothing_places_has_no_place(scene, properties_of):
    add_object(cube_mesh())
    (found,) = properties_of(".eye_render.place.Generated")
    assert found[".eye_render.place.Generated"][:3] == [0.0, 0.0, 0.0]


def test_grease_pencil_is_said_to_be_drawn_by_blender(scene, export):
    if bpy.app.version < (4, 3, 0):
        bpy.ops.object.gpencil_add(type="STROKE")
    else:
        bpy.ops.object.grease_pencil_add(type="STROKE")
    (warning,) = export().warnings
    assert "drawn over the picture by Blender" in warning


def test_what_geometry_nodes_give_to_instances_is_named_as_not_read(scene, depsgraph_of):
    parent = add_object(quad_mesh(), "Field")
    parent["known"] = 3.0
    warnings = []
    reader = PropertyReader(depsgraph_of(), warnings.append)
    instance = SimpleNamespace(is_instance=True, parent=parent, object=parent)
    tint = ".eye_render.instancer.tint"
    assert reader.value(instance, tint) == (0.0,) * 4
    assert warnings == []
    parent.modifiers.new("Nodes", "NODES")
    assert reader.value(instance, ".eye_render.instancer.known")[0] == 3.0
    assert warnings == []
    assert reader.value(instance, tint) == (0.0,) * 4
    (warning,) = warnings
    assert "'tint' of the instances that 'Field' makes" in warning


def test_the_shadow_terminators_offsets_are_the_objects(scene, export):
    shown = add_object(quad_mesh())
    has_own = hasattr(shown, "shadow_terminator_geometry_offset")  # from Blender 4.4
    settings = shown if has_own else shown.cycles
    settings.shadow_terminator_geometry_offset = 0.25
    exported = export()
    assert exported.instances[0].terminator_cosine == 0.25
    assert exported.warnings == []
    name = "shadow_terminator_shading_offset" if has_own else "shadow_terminator_offset"
    setattr(settings, name, 0.5)
    shown.update_tag()
    (warning,) = export().warnings
    assert "shading offset" in warning
