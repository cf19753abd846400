"""Trees with groups, reroutes and muted nodes, as the plain nodes that they amount to."""

import inspect
import sys

import bpy
import pytest
from eye_render import compat
from eye_render.export.nodes.flat import Input
from eye_render.export.nodes.flatten import TreeReader
from scenes import add_group_socket, add_node, link, node_material, surface


@pytest.fixture
def material(scene) -> bpy.types.Material:
    return node_material()


def read(material: bpy.types.Material) -> tuple[Input, list[str]]:
    """The surface, and the kinds of all nodes that were read for it."""
    inlined = compat.inline_shader_nodes(material)
    output = inlined.node_tree.get_output_node("CYCLES")
    reader = TreeReader()
    found = reader.read(output.inputs["Surface"])
    return found, sorted(node.kind for node in reader.nodes)


def color_of(material: bpy.types.Material) -> Input:
    """What the Color input of the shader at the output is."""
    found, _ = read(material)
    return found.source.node.inputs["Color"]


def rgb(datablock, color=(0.5, 0.25, 1.0)) -> bpy.types.NodeSocket:
    node = add_node(datablock, "ShaderNodeRGB")
    node.outputs[0].default_value = (*color, 1.0)
    return node.outputs[0]


def test_only_what_the_output_depends_on_is_read(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    noise = add_node(material, "ShaderNodeTexNoise")
    link(material, noise.outputs["Color"], diffuse.inputs["Color"])
    add_node(material, "ShaderNodeTexVoronoi")
    unused = add_node(material, "ShaderNodeBsdfGlossy")
    link(material, noise.outputs["Color"], unused.inputs["Color"])
    assert read(material)[1] == ["BSDF_DIFFUSE", "TEX_NOISE"]


def test_a_node_with_two_readers_is_one(material):
    mix = surface(material, "ShaderNodeMixShader")
    noise = add_node(material, "ShaderNodeTexNoise")
    for place in (1, 2):
        diffuse = add_node(material, "ShaderNodeBsdfDiffuse")
        link(material, noise.outputs["Color"], diffuse.inputs["Color"])
        link(material, diffuse.outputs[0], mix.inputs[place])
    assert read(material)[1].count("TEX_NOISE") == 1


def test_values_are_numbers_and_triples_and_hidden_ones_are_none(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (0.5, 0.25, 0.125, 1.0)
    inputs = read(material)[0].source.node.inputs
    assert inputs["Color"].value == (0.5, 0.25, 0.125)
    assert inputs["Roughness"].value == 0.0
    assert inputs["Normal"].value is None


def test_options_are_the_properties_of_the_kind_alone(material):
    mix = add_node(material, "ShaderNodeMix", data_type="RGBA", blend_type="MULTIPLY")
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    link(material, next(s for s in mix.outputs if s.enabled), diffuse.inputs["Color"])
    link(material, rgb(material), next(s for s in mix.inputs if s.identifier == "A_Color"))
    node = color_of(material).source.node
    assert node.options["blend_type"] == "MULTIPLY"
    assert {"data_type", "blend_type"} <= node.changed
    assert "location" not in node.options


@pytest.mark.skipif(
    hasattr(bpy.types.Material, "inline_shader_nodes"), reason="this Blender folds constants"
)
def test_value_nodes_have_their_value_as_an_option(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    link(material, rgb(material), diffuse.inputs["Color"])
    assert color_of(material).source.node.options["value"] == [0.5, 0.25, 1.0]


def test_reroutes_are_passed_through(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    noise = add_node(material, "ShaderNodeTexNoise")
    output = noise.outputs["Color"]
    for _ in range(3):
        reroute = add_node(material, "NodeReroute")
        link(material, output, reroute.inputs[0])
        output = reroute.outputs[0]
    link(material, output, diffuse.inputs["Color"])
    source = color_of(material).source
    assert (source.node.kind, source.identifier) == ("TEX_NOISE", "Color")


def test_muted_nodes_are_passed_through(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    noise = add_node(material, "ShaderNodeTexNoise")
    invert = add_node(material, "ShaderNodeInvert")
    invert.mute = True
    link(material, noise.outputs["Color"], invert.inputs["Color"])
    link(material, invert.outputs[0], diffuse.inputs["Color"])
    assert color_of(material).source.node.kind == "TEX_NOISE"


def test_behind_a_muted_source_the_sockets_own_value_counts(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (0.5, 0.25, 0.0, 1.0)
    noise = add_node(material, "ShaderNodeTexNoise")
    noise.mute = True
    link(material, noise.outputs["Color"], diffuse.inputs["Color"])
    assert color_of(material) == Input("RGBA", (0.5, 0.25, 0.0))


def test_a_muted_link_is_none(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    noise = add_node(material, "ShaderNodeTexNoise")
    link(material, noise.outputs["Color"], diffuse.inputs["Color"])
    material.node_tree.links[-1].is_muted = True
    assert color_of(material).source is None


@pytest.mark.skipif(
    hasattr(bpy.types.Material, "inline_shader_nodes"), reason="this Blender removes them itself"
)
def test_a_muted_node_that_nothing_is_linked_to_is_zero_as_in_cycles(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    invert = add_node(material, "ShaderNodeInvert")
    invert.inputs["Color"].default_value = (0.5, 0.5, 0.5, 1.0)
    invert.mute = True
    link(material, invert.outputs[0], diffuse.inputs["Color"])
    assert color_of(material) == Input("RGBA", (0.0, 0.0, 0.0))


@pytest.mark.skipif(
    hasattr(bpy.types.Material, "inline_shader_nodes"), reason="this Blender removes them itself"
)
def test_a_reroute_from_nowhere_is_zero_as_in_cycles(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    reroute = add_node(material, "NodeReroute")
    link(material, reroute.outputs[0], diffuse.inputs["Color"])
    link(material, reroute.outputs[0], diffuse.inputs["Normal"])
    inputs = read(material)[0].source.node.inputs
    assert inputs["Color"].value == (0.0, 0.0, 0.0)
    assert inputs["Normal"].value is None


@pytest.fixture
def group(scene) -> bpy.types.NodeTree:
    """Noise of the group's Scale and Vector, as its Color."""
    tree = bpy.data.node_groups.new("Veins", "ShaderNodeTree")
    add_group_socket(tree, "INPUT", "NodeSocketFloat", "Scale")
    add_group_socket(tree, "INPUT", "NodeSocketVector", "Vector")
    add_group_socket(tree, "OUTPUT", "NodeSocketColor", "Color")
    inside = tree.nodes.new("NodeGroupInput")
    noise = tree.nodes.new("ShaderNodeTexNoise")
    tree.links.new(inside.outputs["Scale"], noise.inputs["Scale"])
    tree.links.new(inside.outputs["Vector"], noise.inputs["Vector"])
    outside = tree.nodes.new("NodeGroupOutput")
    tree.links.new(noise.outputs["Color"], outside.inputs["Color"])
    return tree


def add_group(datablock, tree: bpy.types.NodeTree, scale: float) -> bpy.types.Node:
    node = add_node(datablock, "ShaderNodeGroup", node_tree=tree)
    node.inputs["Scale"].default_value = scale
    coordinates = add_node(datablock, "ShaderNodeTexCoord")
    link(datablock, coordinates.outputs["Object"], node.inputs["Vector"])
    return node


def test_a_group_used_twice_is_two_nodes_with_their_own_values(material, group):
    mix = surface(material, "ShaderNodeMixShader")
    for place, scale in ((1, 3.0), (2, 7.0)):
        diffuse = add_node(material, "ShaderNodeBsdfDiffuse")
        link(material, add_group(material, group, scale).outputs[0], diffuse.inputs["Color"])
        link(material, diffuse.outputs[0], mix.inputs[place])
    shaders = read(material)[0].source.node.inputs
    scales = [
        shaders[name].source.node.inputs["Color"].source.node.inputs["Scale"].value
        for name in ("Shader", "Shader_001")
    ]
    assert scales == [3.0, 7.0]


def test_groups_in_groups_read_what_is_linked_outside(material, group):
    outer = bpy.data.node_groups.new("Marble", "ShaderNodeTree")
    add_group_socket(outer, "INPUT", "NodeSocketFloat", "Size")
    add_group_socket(outer, "OUTPUT", "NodeSocketColor", "Stone")
    holder = type("Holder", (), {"node_tree": outer})
    inner = add_group(holder, group, 1.0)
    outer.links.new(outer.nodes.new("NodeGroupInput").outputs["Size"], inner.inputs["Scale"])
    outer.links.new(inner.outputs[0], outer.nodes.new("NodeGroupOutput").inputs["Stone"])
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    node = add_node(material, "ShaderNodeGroup", node_tree=outer)
    path = add_node(material, "ShaderNodeLightPath")
    link(material, path.outputs["Ray Length"], node.inputs["Size"])
    link(material, node.outputs[0], diffuse.inputs["Color"])
    noise = color_of(material).source.node
    assert noise.kind == "TEX_NOISE"
    assert noise.inputs["Scale"].source.identifier == "Ray Length"
    assert noise.inputs["Vector"].source.identifier == "Object"


def test_the_active_output_of_a_group_counts(material, group):
    other = group.nodes.new("NodeGroupOutput")
    path = group.nodes.new("ShaderNodeLightPath")
    group.links.new(path.outputs["Ray Length"], other.inputs["Color"])
    for output in (node for node in group.nodes if node.type == "GROUP_OUTPUT"):
        output.is_active_output = output == other
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    link(material, add_group(material, group, 1.0).outputs[0], diffuse.inputs["Color"])
    assert color_of(material).source.identifier == "Ray Length"


@pytest.mark.skipif(
    hasattr(bpy.types.Material, "inline_shader_nodes"),
    reason="this Blender flattens groups itself",
)
def test_a_group_without_a_tree_leaves_the_sockets_own_value(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (0.5, 0.25, 0.0, 1.0)
    tree = bpy.data.node_groups.new("Lost", "ShaderNodeTree")
    add_group_socket(tree, "OUTPUT", "NodeSocketColor", "Color")
    node = add_node(material, "ShaderNodeGroup", node_tree=tree)
    link(material, node.outputs[0], diffuse.inputs["Color"])
    bpy.data.node_groups.remove(tree)
    assert color_of(material) == Input("RGBA", (0.5, 0.25, 0.0))


@pytest.mark.skipif(
    hasattr(bpy.types.Material, "inline_shader_nodes"), reason="this Blender keeps the colour"
)
def test_a_colour_through_a_groups_number_becomes_its_luminance(material):
    tree = bpy.data.node_groups.new("Narrow", "ShaderNodeTree")
    add_group_socket(tree, "INPUT", "NodeSocketFloat", "Number")
    add_group_socket(tree, "OUTPUT", "NodeSocketColor", "Color")
    tree.links.new(
        tree.nodes.new("NodeGroupInput").outputs[0], tree.nodes.new("NodeGroupOutput").inputs[0]
    )
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    node = add_node(material, "ShaderNodeGroup", node_tree=tree)
    link(material, rgb(material), node.inputs[0])
    link(material, node.outputs[0], diffuse.inputs["Color"])
    assert color_of(material).source.node.kind == "RGBTOBW"


def test_a_colour_at_the_output_shines(material):
    output = material.node_tree.get_output_node("CYCLES")
    noise = add_node(material, "ShaderNodeTexNoise")
    link(material, noise.outputs["Color"], output.inputs["Surface"])
    source = read(material)[0].source
    assert (source.node.kind, source.type) == ("EMISSION", "SHADER")
    assert source.node.inputs["Color"].source.node.kind == "TEX_NOISE"


def test_a_long_chain_of_nodes_is_read(material):
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    output = add_node(material, "ShaderNodeTexNoise").outputs["Fac"]
    length = 300
    for _ in range(length):
        node = add_node(material, "ShaderNodeMath")
        link(material, output, node.inputs[0])
        output = node.outputs[0]
    link(material, output, diffuse.inputs["Color"])
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(len(inspect.stack()) + length // 2)
    try:
        kinds = read(material)[1]
    finally:
        sys.setrecursionlimit(limit)
    assert kinds.count("MATH") == length
