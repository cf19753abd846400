import bpy
import pytest
from eye_render import core
from eye_render.export.image import ImageTable
from eye_render.export.material import MaterialTable
from scenes import RecordingScene, add_node, add_object, link, node_material, quad_mesh, surface


def approx(values):
    return pytest.approx(values, abs=1e-6)


@pytest.fixture
def export(scene, depsgraph_of, monkeypatch):
    """Exports one material; gives (surface, inputs, warnings)."""
    module = core.module
    monkeypatch.setattr(module, "ImageInput", lambda *args, **more: ("image", *args, more))
    monkeypatch.setattr(module, "AttributeInput", lambda *args, **more: ("attribute", *args, more))

    def run(material: bpy.types.Material):
        mesh = quad_mesh()
        mesh.materials.append(material)
        shown = add_object(mesh).evaluated_get(depsgraph_of())
        core_scene, warnings = RecordingScene(), []
        images = ImageTable(core_scene, warnings.append)
        MaterialTable(core_scene, images, None, warnings.append).worn_by(shown)
        (exported,) = core_scene.materials
        return exported.surface, exported.inputs, warnings

    return run


def a_picture() -> bpy.types.Image:
    return bpy.data.images.new("Picture", 2, 2)


def set_inputs(node: bpy.types.Node, **values):
    for socket in node.inputs:
        if socket.identifier in values:
            socket.default_value = values[socket.identifier]


def test_principled_constants(export):
    material = node_material()
    principled = surface(material, "ShaderNodeBsdfPrincipled", distribution="MULTI_GGX")
    principled.inputs["Base Color"].default_value = (0.1, 0.2, 0.3, 1.0)
    principled.inputs["Roughness"].default_value = 0.25
    set_inputs(principled, **{"Transmission": 0.5, "Transmission Weight": 0.5})
    set_inputs(principled, **{"Specular": 0.75, "Specular IOR Level": 0.75, "IOR": 1.25})
    kind, inputs, warnings = export(material)
    assert (kind, warnings) == ("PRINCIPLED", [])
    assert inputs["base_color"] == approx((0.1, 0.2, 0.3))
    assert inputs["roughness"] == 0.25
    assert inputs["specular"] == 0.75
    assert inputs["transmission"] == 0.5
    assert inputs["ior"] == 1.25
    assert inputs["alpha"] == 1.0
    assert inputs["multiple_scattering"] is True


def test_old_principled_reflects_by_its_specular_alone(export):
    material = node_material()
    principled = surface(material, "ShaderNodeBsdfPrincipled")
    if "Specular" not in principled.inputs:
        pytest.skip("this Blender's Principled has Specular IOR Level")
    principled.inputs["IOR"].default_value = 2.0
    assert export(material)[1]["ior"] == 1.5


@pytest.mark.parametrize(
    ("node_kind", "kind", "color_input"),
    [
        ("ShaderNodeBsdfDiffuse", "DIFFUSE", "base_color"),
        ("ShaderNodeBsdfGlossy", "GLOSSY", "base_color"),
        ("ShaderNodeBsdfGlass", "GLASS", "base_color"),
        ("ShaderNodeEmission", "EMISSION", "emission_color"),
        ("ShaderNodeBsdfTransparent", "TRANSPARENT", "base_color"),
    ],
)
def test_each_supported_shader_and_its_colour(export, node_kind, kind, color_input):
    material = node_material()
    surface(material, node_kind).inputs["Color"].default_value = (0.5, 0.25, 0.125, 1.0)
    exported_kind, inputs, warnings = export(material)
    assert (exported_kind, warnings) == (kind, [])
    assert inputs[color_input] == (0.5, 0.25, 0.125)


def test_value_and_rgb_nodes_are_constants_even_through_a_reroute(export):
    material = node_material()
    principled = surface(material, "ShaderNodeBsdfPrincipled")
    rgb = add_node(material, "ShaderNodeRGB")
    rgb.outputs[0].default_value = (0.5, 0.0, 1.0, 1.0)
    value = add_node(material, "ShaderNodeValue")
    value.outputs[0].default_value = 0.125
    reroute = add_node(material, "NodeReroute")
    link(material, rgb.outputs[0], reroute.inputs[0])
    link(material, reroute.outputs[0], principled.inputs["Base Color"])
    link(material, value.outputs[0], principled.inputs["Roughness"])
    _, inputs, warnings = export(material)
    assert inputs["base_color"] == (0.5, 0.0, 1.0)
    assert inputs["roughness"] == 0.125
    assert warnings == []


def test_image_colour_alpha_and_uv_map(export):
    material = node_material()
    principled = surface(material, "ShaderNodeBsdfPrincipled")
    texture = add_node(material, "ShaderNodeTexImage", image=a_picture())
    uv_map = add_node(material, "ShaderNodeUVMap", uv_map="Second")
    link(material, uv_map.outputs["UV"], texture.inputs["Vector"])
    link(material, texture.outputs["Color"], principled.inputs["Base Color"])
    link(material, texture.outputs["Color"], principled.inputs["Roughness"])
    link(material, texture.outputs["Alpha"], principled.inputs["Alpha"])
    _, inputs, warnings = export(material)
    assert inputs["base_color"] == ("image", 0, {"uv_layer": "Second", "channel": "COLOR"})
    assert inputs["roughness"] == ("image", 0, {"uv_layer": "Second", "channel": "LUMINANCE"})
    assert inputs["alpha"] == ("image", 0, {"uv_layer": "Second", "channel": "ALPHA"})
    assert warnings == []


def test_a_colour_attribute(export):
    material = node_material()
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    attribute = add_node(material, "ShaderNodeVertexColor", layer_name="Col")
    link(material, attribute.outputs["Color"], diffuse.inputs["Color"])
    assert export(material)[1]["base_color"] == ("attribute", "Col", {"channel": "COLOR"})


def test_a_normal_map(export):
    material = node_material()
    principled = surface(material, "ShaderNodeBsdfPrincipled")
    normal_map = add_node(material, "ShaderNodeNormalMap", uv_map="UVMap")
    normal_map.inputs["Strength"].default_value = 0.5
    texture = add_node(material, "ShaderNodeTexImage", image=a_picture())
    link(material, texture.outputs["Color"], normal_map.inputs["Color"])
    link(material, normal_map.outputs["Normal"], principled.inputs["Normal"])
    _, inputs, warnings = export(material)
    assert inputs["normal_map"] == ("image", 0, {"uv_layer": "UVMap"})
    assert inputs["normal_strength"] == 0.5
    assert warnings == []


def test_what_is_not_supported_is_named_once_and_the_sockets_colour_stays(export):
    material = node_material("Marble")
    principled = surface(material, "ShaderNodeBsdfPrincipled")
    principled.inputs["Base Color"].default_value = (0.5, 0.25, 0.0, 1.0)
    noise = add_node(material, "ShaderNodeTexNoise", name="Veins")
    bump = add_node(material, "ShaderNodeBump", name="Cracks")
    link(material, noise.outputs["Color"], principled.inputs["Base Color"])
    link(material, bump.outputs["Normal"], principled.inputs["Normal"])
    _, inputs, warnings = export(material)
    assert inputs["base_color"] == (0.5, 0.25, 0.0)
    (warning,) = warnings
    assert "Marble" in warning
    assert "Veins" in warning
    assert "Cracks" in warning


def test_a_mix_of_shaders_falls_back_to_the_first_ones_colour(export):
    material = node_material()
    mix = surface(material, "ShaderNodeMixShader", name="Blend")
    red = add_node(material, "ShaderNodeBsdfDiffuse")
    red.inputs["Color"].default_value = (1.0, 0.0, 0.0, 1.0)
    link(material, red.outputs[0], mix.inputs[1])
    kind, inputs, warnings = export(material)
    assert (kind, inputs["base_color"]) == ("DIFFUSE", (1.0, 0.0, 0.0))
    assert "Blend" in warnings[0]


def test_a_node_group_is_named_once_or_looked_through(export):
    group = bpy.data.node_groups.new("Paint", "ShaderNodeTree")
    if hasattr(group, "outputs"):  # until Blender 3.6
        group.outputs.new("NodeSocketShader", "Shader")
    else:
        group.interface.new_socket("Shader", in_out="OUTPUT", socket_type="NodeSocketShader")
    inside = group.nodes.new("ShaderNodeBsdfGlossy")
    group.links.new(inside.outputs[0], group.nodes.new("NodeGroupOutput").inputs[0])
    material = node_material()
    surface(material, "ShaderNodeGroup", node_tree=group)
    kind, _, warnings = export(material)
    if hasattr(material, "inline_shader_nodes"):
        assert (kind, warnings) == ("GLOSSY", [])
    else:
        assert kind == "DIFFUSE"
        assert len(warnings) == 1


def test_without_nodes_the_plain_settings_count(export):
    material = bpy.data.materials.new("Plain")
    material.use_nodes = False
    if material.use_nodes:
        pytest.skip("this Blender's materials always use nodes")
    material.diffuse_color = (0.25, 0.5, 1.0, 1.0)
    kind, inputs, _ = export(material)
    assert kind == "PRINCIPLED"
    assert inputs["base_color"] == (0.25, 0.5, 1.0)


def test_an_output_without_surface_is_black(export):
    kind, inputs, _ = export(node_material())
    assert (kind, inputs["base_color"]) == ("DIFFUSE", (0.0, 0.0, 0.0))


def test_muted_nodes_are_passed_through(export):
    material = node_material()
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    rgb = add_node(material, "ShaderNodeRGB")
    rgb.outputs[0].default_value = (0.0, 1.0, 0.0, 1.0)
    invert = add_node(material, "ShaderNodeInvert")
    invert.mute = True
    link(material, rgb.outputs[0], invert.inputs["Color"])
    link(material, invert.outputs[0], diffuse.inputs["Color"])
    _, inputs, warnings = export(material)
    assert inputs["base_color"] == (0.0, 1.0, 0.0)
    assert warnings == []


def test_the_view_layers_override_replaces_every_material(scene, depsgraph_of):
    override = bpy.data.materials.new("Clay")
    mesh = quad_mesh()
    mesh.materials.append(bpy.data.materials.new("Own"))
    shown = add_object(mesh).evaluated_get(depsgraph_of())
    core_scene = RecordingScene()
    table = MaterialTable(core_scene, ImageTable(core_scene, print), override, print)
    table.worn_by(shown)
    assert [material.name for material in core_scene.materials] == ["Clay"]
