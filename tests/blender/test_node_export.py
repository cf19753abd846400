"""What of a tree reaches the core, and what is said of the rest."""

import bpy
import numpy as np
import pytest
from eye_render import compat, core
from eye_render.export.image import MISSING_COLOR, ImageTable
from eye_render.export.nodes import DIFFUSE, export_sockets
from scenes import RecordingGraph, RecordingScene, add_node, link, node_material, surface


@pytest.fixture
def material(scene) -> bpy.types.Material:
    return node_material()


@pytest.fixture
def export(monkeypatch):
    """Exports the surface; gives its shader's node and what was left out."""
    monkeypatch.setattr(core.module, "NodeGraph", RecordingGraph)

    def run(material: bpy.types.Material):
        inlined = compat.inline_shader_nodes(material)
        output = inlined.node_tree.get_output_node("CYCLES")
        images = ImageTable(RecordingScene(), 1, print)
        tree = export_sockets([output.inputs["Surface"]], images, DIFFUSE)
        return tree.sockets[0].node, tree.left_out

    return run


@pytest.fixture
def without_kind(monkeypatch):
    """Makes the core forget a kind of node."""

    def forget(kind: str) -> None:
        types = dict(core.module.NODE_TYPES)
        types.pop(kind, None)
        monkeypatch.setattr(core.module, "NODE_TYPES", types)

    return forget


def feed_color(material: bpy.types.Material, kind: str, output: str = "Color", **settings):
    """A node of the kind, which gives the Color of a diffuse surface."""
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (0.5, 0.25, 0.0, 1.0)
    node = add_node(material, kind, **settings)
    link(material, node.outputs[output], diffuse.inputs["Color"])
    return node


def test_links_go_by_identifier(material, export):
    feed_color(material, "ShaderNodeTexNoise", name="Veins")
    shader, left_out = export(material)
    noise, output = shader.inputs["Color"]
    assert (noise.kind, output) == ("TEX_NOISE", "Color")
    assert noise.inputs["Scale"] == 5.0
    assert "Vector" not in noise.inputs
    assert left_out == []


def test_a_value_that_is_not_supported_is_named_and_the_sockets_own_stays(
    material, export, without_kind
):
    without_kind("TEX_NOISE")
    feed_color(material, "ShaderNodeTexNoise", name="Veins")
    shader, (left_out,) = export(material)
    assert shader.inputs["Color"] == (0.5, 0.25, 0.0)
    assert "Veins" in left_out


def test_nobody_hears_of_what_is_behind_something_unsupported(material, export, without_kind):
    without_kind("TEX_NOISE")
    without_kind("TEX_COORD")
    noise = feed_color(material, "ShaderNodeTexNoise", name="Veins")
    coordinates = add_node(material, "ShaderNodeTexCoord")
    link(material, coordinates.outputs["Object"], noise.inputs["Vector"])
    _, left_out = export(material)
    assert len(left_out) == 1


def test_a_shader_that_is_not_supported_is_plain_in_its_own_colour(material, export, without_kind):
    without_kind("BSDF_TOON")
    toon = surface(material, "ShaderNodeBsdfToon", name="Comic")
    rgb = add_node(material, "ShaderNodeTexNoise")
    link(material, rgb.outputs["Color"], toon.inputs["Color"])
    shader, (left_out,) = export(material)
    assert shader.kind == "BSDF_DIFFUSE"
    assert shader.inputs["Color"].node.kind == "TEX_NOISE"
    assert "Comic" in left_out


def test_an_output_that_is_not_supported_is_named(material, export, monkeypatch):
    types = dict(core.module.NODE_TYPES)
    types["TEX_NOISE"] = types["TEX_NOISE"] | {"outputs": ["Fac"]}
    monkeypatch.setattr(core.module, "NODE_TYPES", types)
    feed_color(material, "ShaderNodeTexNoise", name="Veins")
    shader, (left_out,) = export(material)
    assert shader.inputs["Color"] == (0.5, 0.25, 0.0)
    assert left_out.startswith("Color of")


def test_an_option_that_is_not_supported_is_named_if_it_is_used(material, export, monkeypatch):
    types = dict(core.module.NODE_TYPES)
    types["BUMP"] = types["BUMP"] | {"options": []}
    monkeypatch.setattr(core.module, "NODE_TYPES", types)
    node = feed_color(material, "ShaderNodeBump", "Normal")
    assert export(material)[1] == []
    node.invert = True
    (left_out,) = export(material)[1]
    assert left_out.startswith("invert of")


NEEDS_FILE = ("ShaderNodeTexImage", "ShaderNodeTexEnvironment", "ShaderNodeTexIES")
# What something close is shown for.
STANDS_IN = ("ShaderNodeBsdfHair",)
if bpy.app.version >= (5, 0, 0):
    STANDS_IN += ("ShaderNodeTexSky",)  # a fresh one scatters more than once


def test_a_fresh_node_of_each_kind_is_taken_over_without_a_word(scene, export):
    said = {}
    supported = core.module.NODE_TYPES
    for name in dir(bpy.types):
        material = node_material()
        try:
            node = add_node(material, name) if name.startswith("ShaderNode") else None
        except RuntimeError:
            continue
        if node is None or node.type not in supported or not node.outputs:
            continue
        output = next(socket for socket in node.outputs if socket.enabled)
        link(material, output, material.node_tree.nodes[0].inputs["Surface"])
        left_out = export(material)[1]
        if left_out and not name.startswith(NEEDS_FILE + STANDS_IN):
            said[name] = left_out
    assert said == {}


def test_a_ramp_is_a_table(material, export):
    node = feed_color(material, "ShaderNodeValToRGB")
    noise = add_node(material, "ShaderNodeTexNoise")
    link(material, noise.outputs["Fac"], node.inputs["Fac"])
    options = export(material)[0].inputs["Color"].node.options
    ramp = np.array(options["ramp"]).reshape(-1, 4)
    assert np.allclose(ramp[:, 0], np.linspace(0, 1, len(ramp)), atol=1e-6)
    assert np.allclose(ramp[:, 3], 1.0)
    assert options["interpolate"]


def test_curves_are_tables_behind_the_combined_one(material, export):
    node = feed_color(material, "ShaderNodeRGBCurve")
    noise = add_node(material, "ShaderNodeTexNoise")
    link(material, noise.outputs["Color"], node.inputs["Color"])
    combined, red = node.mapping.curves[3], node.mapping.curves[0]
    combined.points[1].location.y = 0.5
    red.points[1].location.y = 0.5
    node.mapping.update()
    options = export(material)[0].inputs["Color"].node.options
    curve = np.array(options["curve"]).reshape(3, -1)
    assert np.allclose(curve[:, -1], (0.25, 0.5, 0.5), atol=1e-3)
    assert (options["curve_min"], options["curve_max"]) == (0.0, 1.0)
    assert options["extrapolate"]


def test_an_object_for_coordinates_is_a_matrix(material, scene, export):
    empty = bpy.data.objects.new("Empty", None)
    scene.collection.objects.link(empty)
    empty.location = (1.0, 2.0, 3.0)
    bpy.context.view_layer.update()
    feed_color(material, "ShaderNodeTexCoord", "Object", object=empty)
    matrix = export(material)[0].inputs["Color"].node.options["object_from_world"]
    assert np.allclose(np.reshape(matrix, (4, 4))[:3, 3], (-1.0, -2.0, -3.0))


def test_the_texture_mapping_of_old_files_is_a_mapping_node(material, export):
    node = feed_color(material, "ShaderNodeTexNoise")
    node.texture_mapping.scale = (2.0, 2.0, 2.0)
    noise = export(material)[0].inputs["Color"].node
    mapping, _ = noise.inputs["Vector"]
    assert (mapping.kind, mapping.inputs["Scale"]) == ("MAPPING", (2.0, 2.0, 2.0))
    coordinates, output = mapping.inputs["Vector"]
    assert (coordinates.kind, output) == ("TEX_COORD", "Generated")


def test_an_image_texture_has_the_number_of_a_texture(material, export):
    image = bpy.data.images.new("Picture", 2, 2)
    feed_color(material, "ShaderNodeTexImage", image=image, projection="BOX")
    shader, left_out = export(material)
    picture = shader.inputs["Color"].node
    assert picture.kind == "TEX_IMAGE"
    assert picture.options["texture"] == 0
    assert picture.options["projection"] == "BOX"
    assert left_out == []


def test_a_mirrored_picture_is_one_whose_coordinates_are_folded(material, export):
    extensions = bpy.types.ShaderNodeTexImage.bl_rna.properties["extension"].enum_items
    if "MIRROR" not in extensions:
        pytest.skip("this Blender's pictures are not mirrored")
    image = bpy.data.images.new("Picture", 2, 2)
    feed_color(material, "ShaderNodeTexImage", image=image, extension="MIRROR")
    shader, left_out = export(material)
    combined = shader.inputs["Color"].node.inputs["Vector"].node
    folded = combined.inputs["X"].node
    assert folded.options["operation"] == "PINGPONG"
    assert folded.inputs["Value"].node.inputs["Vector"].identifier == "UV"
    assert left_out == []


def test_a_texture_without_a_picture_is_magenta_and_named(material, export):
    feed_color(material, "ShaderNodeTexImage", name="Lost")
    shader, (left_out,) = export(material)
    assert shader.inputs["Color"].node.options["value"] == list(MISSING_COLOR)
    assert "Lost" in left_out


def test_an_image_without_alpha_is_opaque(material, export):
    image = bpy.data.images.new("Picture", 2, 2)
    image.alpha_mode = "NONE"
    diffuse = surface(material, "ShaderNodeBsdfDiffuse")
    picture = add_node(material, "ShaderNodeTexImage", image=image)
    link(material, picture.outputs["Alpha"], diffuse.inputs["Roughness"])
    assert export(material)[0].inputs["Roughness"] == 1.0


def test_a_node_whose_option_the_core_refuses_is_replaced_alone(material, export, monkeypatch):
    class Strict(RecordingGraph):
        def add(self, kind, inputs=None, **options):
            if options.get("noise_dimensions") == "4D":
                raise ValueError("noise_dimensions is 4D; expected one of 3D")
            return super().add(kind, inputs, **options)

    monkeypatch.setattr(core.module, "NodeGraph", Strict)
    shader = surface(material, "ShaderNodeBsdfDiffuse")
    noise = add_node(material, "ShaderNodeTexNoise", name="Grain", noise_dimensions="4D")
    link(material, noise.outputs["Color"], shader.inputs["Color"])
    shader.inputs["Color"].default_value = (0.25, 0.5, 0.75, 1.0)
    checker = add_node(material, "ShaderNodeTexChecker")
    link(material, checker.outputs["Fac"], shader.inputs["Roughness"])
    node, (left_out,) = export(material)
    assert node.inputs["Color"] == (0.25, 0.5, 0.75)
    assert node.inputs["Roughness"].node.kind == "TEX_CHECKER"
    assert "Grain" in left_out
    assert "expected one of 3D" in left_out
