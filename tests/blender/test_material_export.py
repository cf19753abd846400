import bpy
import pytest
from eye_render import core
from eye_render.export.image import ImageTable
from eye_render.export.material import MaterialTable
from scenes import (
    RecordingGraph,
    RecordingScene,
    add_node,
    add_object,
    link,
    node_material,
    quad_mesh,
    surface,
)


@pytest.fixture
def table(scene, monkeypatch):
    """A table of materials over a recording scene, whose warnings are `.warnings`."""
    monkeypatch.setattr(core.module, "NodeGraph", RecordingGraph)
    core_scene = RecordingScene()
    core_scene.warnings = []
    warn = core_scene.warnings.append
    return MaterialTable(core_scene, ImageTable(core_scene, 1, warn), None, warn), core_scene


@pytest.fixture
def export(table, depsgraph_of):
    """Exports one material; gives it as recorded, with the warnings as `.warnings`."""

    def run(material: bpy.types.Material):
        mesh = quad_mesh()
        mesh.materials.append(material)
        shown = add_object(mesh).evaluated_get(depsgraph_of())
        table[0].worn_by(shown)
        (exported,) = table[1].materials
        exported.warnings = table[1].warnings
        return exported

    return run


def test_the_shader_at_the_output_with_its_inputs_and_options(export):
    material = node_material()
    glass = surface(material, "ShaderNodeBsdfGlass", distribution="GGX")
    glass.inputs["Color"].default_value = (0.5, 0.25, 0.125, 1.0)
    glass.inputs["IOR"].default_value = 1.25
    exported = export(material)
    shader, output = exported.surface
    assert (shader.kind, output) == ("BSDF_GLASS", "BSDF")
    assert shader.options["distribution"] == "GGX"
    assert shader.inputs["Color"] == (0.5, 0.25, 0.125)
    assert shader.inputs["IOR"] == 1.25
    assert "Normal" not in shader.inputs
    assert exported.warnings == []


def test_a_new_material_of_blender_is_taken_over_without_a_word(export):
    material = bpy.data.materials.new("New")
    material.use_nodes = True
    exported = export(material)
    assert exported.surface.node.kind == "BSDF_PRINCIPLED"
    assert exported.surface.node.inputs["Specular IOR Level"] == 0.5
    assert exported.warnings == []


def test_the_output_for_cycles_counts(export):
    material = node_material()
    surface(material, "ShaderNodeBsdfDiffuse")
    material.node_tree.nodes[0].target = "EEVEE"
    output = add_node(material, "ShaderNodeOutputMaterial", target="CYCLES")
    glossy = add_node(material, "ShaderNodeBsdfAnisotropic")
    link(material, glossy.outputs[0], output.inputs["Surface"])
    assert export(material).surface.node.kind == "BSDF_GLOSSY"


def test_an_output_without_surface_is_black(export):
    exported = export(node_material())
    assert (exported.surface, exported.warnings) == (None, [])


def test_without_nodes_the_plain_colour_counts(export):
    material = bpy.data.materials.new("Plain")
    material.use_nodes = False
    if material.use_nodes:
        pytest.skip("this Blender's materials always use nodes")
    material.diffuse_color = (0.25, 0.5, 1.0, 1.0)
    shader = export(material).surface.node
    assert shader.kind == "BSDF_DIFFUSE"
    assert shader.inputs["Color"] == (0.25, 0.5, 1.0)


def test_displacement_goes_with_the_surface(export):
    material = node_material()
    surface(material, "ShaderNodeBsdfDiffuse")
    displacement = add_node(material, "ShaderNodeDisplacement")
    noise = add_node(material, "ShaderNodeTexNoise")
    link(material, noise.outputs["Fac"], displacement.inputs["Height"])
    output = material.node_tree.get_output_node("CYCLES")
    link(material, displacement.outputs[0], output.inputs["Displacement"])
    exported = export(material)
    assert exported.displacement.node.kind == "DISPLACEMENT"
    assert exported.displacement.node.inputs["Height"].node.kind == "TEX_NOISE"
    assert exported.warnings == []


def test_a_shadow_is_opaque_if_the_material_says_so(export):
    material = node_material()
    surface(material, "ShaderNodeBsdfTransparent")
    in_cycles = not hasattr(material, "use_transparent_shadow")
    (material.cycles if in_cycles else material).use_transparent_shadow = False
    mix = export(material).surface.node
    assert mix.kind == "MIX_SHADER"
    assert mix.inputs["Fac"].identifier == "Is Shadow Ray"
    assert mix.inputs["Shader"].node.kind == "BSDF_TRANSPARENT"
    assert mix.inputs["Shader_001"].node.inputs["Color"] == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("method", ["DISPLACEMENT", "BOTH"])
def test_displacement_of_the_surface_itself_is_named(export, method):
    material = node_material("Rock")
    settings = material if hasattr(material, "displacement_method") else material.cycles
    settings.displacement_method = method
    surface(material, "ShaderNodeBsdfDiffuse")
    displacement = add_node(material, "ShaderNodeDisplacement")
    output = material.node_tree.get_output_node("CYCLES")
    link(material, displacement.outputs[0], output.inputs["Displacement"])
    (warning,) = export(material).warnings
    assert "Rock" in warning
    assert "bump" in warning


def test_a_volume_goes_with_the_surface_or_alone(export):
    material = node_material("Fog")
    principled = add_node(material, "ShaderNodeVolumePrincipled")
    principled.inputs["Blackbody Intensity"].default_value = 0.5
    output = material.node_tree.get_output_node("CYCLES")
    link(material, principled.outputs[0], output.inputs["Volume"])
    exported = export(material)
    assert exported.surface is None
    assert exported.volume.node.kind == "PRINCIPLED_VOLUME"
    assert exported.volume.node.inputs["Blackbody Intensity"] == 0.5
    assert exported.warnings == []


@pytest.mark.skipif(bpy.app.version < (4, 0, 0), reason="one model of hair")
def test_an_elliptical_fibre_is_round_and_named(export):
    material = node_material("Fur")
    hair = surface(material, "ShaderNodeBsdfHairPrincipled", model="HUANG")
    hair.inputs["Roughness"].default_value = 0.4
    exported = export(material)
    assert exported.surface.node.inputs["Radial Roughness"] == pytest.approx(0.4)
    (warning,) = exported.warnings
    assert "Fur" in warning
    assert "elliptical" in warning


def test_what_the_core_refuses_is_named_and_grey(table, export, monkeypatch):
    material = node_material("Odd")
    surface(material, "ShaderNodeBsdfGlass")
    add_material = table[1].add_material

    def refuse_glass(name, surface=None, displacement=None, volume=None, pass_index=0, aovs=()):
        if surface.node.kind == "BSDF_GLASS":
            raise ValueError("the graph runs in a circle")
        return add_material(name, surface, displacement, volume, pass_index)

    monkeypatch.setattr(table[1], "add_material", refuse_glass)
    exported = export(material)
    assert exported.surface.node.kind == "BSDF_DIFFUSE"
    (warning,) = exported.warnings
    assert "Odd" in warning
    assert "runs in a circle" in warning


def test_a_material_keeps_its_pass_index(export):
    material = node_material()
    material.pass_index = 3
    assert export(material).pass_index == 3


def test_a_material_is_exported_once_however_often_it_is_worn(table, depsgraph_of):
    material = node_material()
    surface(material, "ShaderNodeBsdfDiffuse")
    for _ in range(2):
        mesh = quad_mesh()
        mesh.materials.append(material)
        table[0].worn_by(add_object(mesh).evaluated_get(depsgraph_of()))
    assert len(table[1].materials) == 1


def test_the_view_layers_override_replaces_every_material(scene, depsgraph_of):
    override = bpy.data.materials.new("Clay")
    mesh = quad_mesh()
    mesh.materials.append(bpy.data.materials.new("Own"))
    shown = add_object(mesh).evaluated_get(depsgraph_of())
    core_scene = RecordingScene()
    table = MaterialTable(core_scene, ImageTable(core_scene, 1, print), override, print)
    table.worn_by(shown)
    assert [material.name for material in core_scene.materials] == ["Clay"]


def test_the_name_for_cryptomatte_is_without_the_library(export, table, tmp_path):
    node_material("Rock").use_fake_user = True
    library = str(tmp_path / "library.blend")
    bpy.data.libraries.write(library, {bpy.data.materials["Rock"]})
    bpy.data.materials.remove(bpy.data.materials["Rock"])
    with bpy.data.libraries.load(library, link=True) as (_, linked):
        linked.materials = ["Rock"]
    assert export(linked.materials[0]).name == "Rock"
    assert table[0].names == {"Rock"}
