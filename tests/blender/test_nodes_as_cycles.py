"""Pictures of shader trees beside Cycles of the same Blender, texel by texel.

The surfaces shine, so that a pixel is what the tree makes of its place: nothing is left to chance
but the place within the pixel.
"""

import math

import bpy
import numpy as np
import pytest
from mathutils import Euler
from scenes import add_group_socket, add_node, add_object, link, node_material, surface
from tools.engines import SET_UP
from tools.meshes import cube_mesh

# Of the mean difference: edges of a pattern fall otherwise within a pixel.
TOLERANCE = 0.01
RESOLUTION = 40


@pytest.fixture
def difference(scene, render):
    """Renders the scene by both engines; gives the mean difference of linear colours."""

    def run() -> float:
        scene.render.resolution_x = scene.render.resolution_y = RESOLUTION
        pictures = {}
        for engine, set_up in SET_UP.items():
            set_up(scene, samples=128)
            pictures[engine] = render()[..., :3].astype(np.float64)
        assert pictures["CYCLES"].std() > 0.01, "a picture of one colour compares nothing"
        return float(np.abs(pictures["EYE_RENDER"] - pictures["CYCLES"]).mean())

    return run


@pytest.fixture
def shown(scene) -> bpy.types.Object:
    """A cube of two metres that shows three faces to the camera."""
    cube = add_object(cube_mesh(), "Shown")
    cube.location = (0.2, 0.1, -5.0)
    cube.rotation_euler = (0.7, 0.5, 0.2)
    return cube


def glow(material: bpy.types.Material) -> bpy.types.NodeSocket:
    """The Color input of the surface, which shines."""
    return surface(material, "ShaderNodeEmission").inputs["Color"]


def coordinate(material: bpy.types.Material, name: str) -> bpy.types.NodeSocket:
    return add_node(material, "ShaderNodeTexCoord").outputs[name]


def stripes(material: bpy.types.Material, vector: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    """A pattern that tells all three coordinates apart."""
    fraction = add_node(material, "ShaderNodeVectorMath", operation="FRACTION")
    link(material, vector, fraction.inputs[0])
    return fraction.outputs["Vector"]


def show(material: bpy.types.Material, vector: bpy.types.NodeSocket) -> None:
    link(material, stripes(material, vector), glow(material))


def generated(material, _shown):
    show(material, coordinate(material, "Generated"))


def texture_space(material, shown):
    shown.data.use_auto_texspace = False
    shown.data.texspace_location = (0.5, 0.0, -0.5)
    shown.data.texspace_size = (1.0, 2.0, 0.5)
    show(material, coordinate(material, "Generated"))


def object_of_another(material, _shown):
    other = add_object(None, "Other")
    other.matrix_world = Euler((0.3, 0.4, 0.5)).to_matrix().to_4x4()
    other.location = (0.5, 0.0, -4.0)
    other.scale = (1.0, 2.0, 0.5)
    socket = coordinate(material, "Object")
    socket.node.object = other
    show(material, socket)


def second_uv_map(material, shown):
    layer = shown.data.uv_layers.new(name="Second")
    corners = [(0, 0), (3, 0), (3, 2), (0, 2)] * 6
    layer.data.foreach_set("uv", np.array(corners, np.float32).ravel())
    show(material, add_node(material, "ShaderNodeUVMap", uv_map="Second").outputs[0])


def attribute_of_faces(material, shown):
    numbers = shown.data.attributes.new("Shade", "FLOAT", "FACE")
    numbers.data.foreach_set("value", np.linspace(0, 1, 6, dtype=np.float32))
    node = add_node(material, "ShaderNodeAttribute", attribute_name="Shade")
    link(material, node.outputs["Fac"], glow(material))


def attribute_of_points(material, shown):
    values = shown.data.attributes.new("Place", "FLOAT_VECTOR", "POINT")
    values.data.foreach_set("vector", np.linspace(0, 1, 24, dtype=np.float32))
    node = add_node(material, "ShaderNodeAttribute", attribute_name="Place")
    link(material, node.outputs["Vector"], glow(material))


def object_info(material, shown):
    for number in range(5):
        copy = add_object(shown.data, f"Größe {number}")
        copy.location = (2.5 * (number - 2.0), 3.0, -12.0)
        copy.color = (0.2 * number, 0.5, 1.0, 1.0)
        copy.pass_index = number % 2
    info = add_node(material, "ShaderNodeObjectInfo")
    combine = add_node(material, "ShaderNodeCombineXYZ")
    link(material, info.outputs["Random"], combine.inputs["X"])
    link(material, info.outputs["Object Index"], combine.inputs["Y"])
    link(material, info.outputs["Color"], combine.inputs["Z"])
    link(material, combine.outputs[0], glow(material))


def geometry_output(material, name):
    return add_node(material, "ShaderNodeNewGeometry").outputs[name]


def pointiness(material, shown):
    bpy.ops.mesh.primitive_monkey_add()
    shown.data = bpy.context.object.data
    bpy.data.objects.remove(bpy.context.object)
    shown.data.materials.append(material)
    contrast = add_node(material, "ShaderNodeMath", operation="MULTIPLY_ADD")
    contrast.inputs[1].default_value, contrast.inputs[2].default_value = 5.0, -2.0
    link(material, geometry_output(material, "Pointiness"), contrast.inputs[0])
    link(material, contrast.outputs[0], glow(material))


def random_per_island(material, shown):
    shown.location.z = -12.0
    array = shown.modifiers.new("Array", "ARRAY")
    array.count, array.relative_offset_displace = 3, (1.3, 0.0, 0.0)
    link(material, geometry_output(material, "Random Per Island"), glow(material))


def random_of_instances(material, shown):
    collection = bpy.data.collections.new("Inner")
    bpy.context.scene.collection.objects.unlink(shown)
    collection.objects.link(shown)
    shown.location = (0, 0, 0)
    for number in range(3):
        empty = add_object(None, f"Instance {number}")
        empty.instance_type, empty.instance_collection = "COLLECTION", collection
        empty.location = (2.5 * number - 2.5, 0, -8)
    info = add_node(material, "ShaderNodeObjectInfo")
    link(material, info.outputs["Random"], glow(material))


def group_in_a_group(material, _shown):
    inner = bpy.data.node_groups.new("Inner", "ShaderNodeTree")
    add_group_socket(inner, "INPUT", "NodeSocketVector", "Vector")
    add_group_socket(inner, "INPUT", "NodeSocketFloat", "Scale")
    add_group_socket(inner, "OUTPUT", "NodeSocketVector", "Vector")
    scale = inner.nodes.new("ShaderNodeVectorMath")
    scale.operation = "SCALE"
    entry = inner.nodes.new("NodeGroupInput")
    inner.links.new(entry.outputs["Vector"], scale.inputs[0])
    inner.links.new(entry.outputs["Scale"], scale.inputs["Scale"])
    inner.links.new(scale.outputs[0], inner.nodes.new("NodeGroupOutput").inputs[0])
    outer = bpy.data.node_groups.new("Outer", "ShaderNodeTree")
    add_group_socket(outer, "INPUT", "NodeSocketVector", "Vector")
    add_group_socket(outer, "OUTPUT", "NodeSocketVector", "Vector")
    node = outer.nodes.new("ShaderNodeGroup")
    node.node_tree = inner
    node.inputs["Scale"].default_value = 2.9  # the faces lie within a stripe
    outer.links.new(outer.nodes.new("NodeGroupInput").outputs[0], node.inputs["Vector"])
    outer.links.new(node.outputs[0], outer.nodes.new("NodeGroupOutput").inputs[0])
    group = add_node(material, "ShaderNodeGroup", node_tree=outer)
    link(material, coordinate(material, "Object"), group.inputs[0])
    show(material, group.outputs[0])


def curves(material, _shown):
    node = add_node(material, "ShaderNodeRGBCurve")
    for curve, height in zip(node.mapping.curves, (0.3, 0.6, 0.9, 0.7), strict=True):
        curve.points.new(0.5, height)
    node.mapping.update()
    link(material, coordinate(material, "Generated"), node.inputs["Color"])
    link(material, node.outputs[0], glow(material))


def color_ramp(material, _shown):
    node = add_node(material, "ShaderNodeValToRGB")
    node.color_ramp.interpolation = "B_SPLINE"
    node.color_ramp.elements.new(0.3).color = (1.0, 0.2, 0.1, 1.0)
    separate = add_node(material, "ShaderNodeSeparateXYZ")
    link(material, coordinate(material, "Generated"), separate.inputs[0])
    link(material, separate.outputs["X"], node.inputs["Fac"])
    link(material, node.outputs["Color"], glow(material))


def texture_mapping(material, _shown):
    node = add_node(material, "ShaderNodeTexChecker")
    node.texture_mapping.translation = (0.1, 0.2, 0.3)
    node.texture_mapping.rotation = (0.1, 0.2, 0.3)
    node.texture_mapping.scale = (1.0, 2.0, 0.5)
    link(material, node.outputs["Color"], glow(material))


def a_picture() -> bpy.types.Image:
    image = bpy.data.images.new("Picture", 4, 4)
    pixels = np.random.default_rng(1).random((16, 4), np.float32)
    pixels[:, 3] = 1.0
    image.pixels.foreach_set(pixels.ravel())
    return image


def image_in_a_box(material, _shown):
    node = add_node(material, "ShaderNodeTexImage", image=a_picture(), projection="BOX")
    node.projection_blend = 0.3
    link(material, coordinate(material, "Generated"), node.inputs["Vector"])
    link(material, node.outputs["Color"], glow(material))


def color_at_the_output(material, _shown):
    node = add_node(material, "ShaderNodeTexImage", image=a_picture())
    output = material.node_tree.get_output_node("CYCLES")
    link(material, node.outputs["Color"], output.inputs["Surface"])


TREES = [
    generated,
    texture_space,
    object_of_another,
    second_uv_map,
    attribute_of_faces,
    attribute_of_points,
    object_info,
    pointiness,
    random_per_island,
    random_of_instances,
    group_in_a_group,
    curves,
    color_ramp,
    texture_mapping,
    image_in_a_box,
    color_at_the_output,
]


@pytest.mark.parametrize("build", TREES, ids=lambda build: build.__name__)
def test_a_tree_looks_as_in_cycles(shown, difference, build):
    material = node_material()
    shown.data.materials.append(material)
    build(material, shown)
    assert difference() < TOLERANCE


MUSGRAVES = ["MULTIFRACTAL", "RIDGED_MULTIFRACTAL", "HYBRID_MULTIFRACTAL", "FBM", "HETERO_TERRAIN"]


@pytest.mark.skipif(
    not hasattr(bpy.types, "ShaderNodeTexMusgrave"), reason="this Blender has Noise in its place"
)
@pytest.mark.parametrize("detail", [0.5, 2.5])
@pytest.mark.parametrize("kind", MUSGRAVES)
def test_a_musgrave_looks_as_in_the_cycles_that_had_it(shown, difference, kind, detail):
    material = node_material()
    shown.data.materials.append(material)
    node = add_node(material, "ShaderNodeTexMusgrave", musgrave_type=kind)
    node.inputs["Scale"].default_value = 1.5
    node.inputs["Detail"].default_value = detail
    node.inputs["Dimension"].default_value = 0.7
    node.inputs["Offset"].default_value = 0.6
    shift = add_node(material, "ShaderNodeMath", operation="MULTIPLY_ADD")
    shift.inputs[1].default_value = shift.inputs[2].default_value = 0.3
    link(material, node.outputs[0], shift.inputs[0])
    link(material, shift.outputs[0], glow(material))
    assert difference() < TOLERANCE


def test_a_world_looks_as_in_cycles(scene, difference):
    scene.camera.rotation_euler = (math.radians(100), 0.0, 0.4)
    scene.world = bpy.data.worlds.new("Sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes.clear()
    add_node(scene.world, "ShaderNodeOutputWorld")
    background = surface(scene.world, "ShaderNodeBackground")
    picture = add_node(scene.world, "ShaderNodeTexEnvironment", image=a_picture())
    mapping = add_node(scene.world, "ShaderNodeMapping")
    mapping.inputs["Rotation"].default_value = (0.2, 0.3, 0.4)
    link(scene.world, coordinate(scene.world, "Generated"), mapping.inputs["Vector"])
    link(scene.world, mapping.outputs[0], picture.inputs["Vector"])
    link(scene.world, picture.outputs["Color"], background.inputs["Color"])
    assert difference() < TOLERANCE
