"""Blender's working spaces: which one it is, and that colours follow it as in Cycles."""

import math
from collections.abc import Callable
from pathlib import Path

import bpy
import numpy as np
import pytest
from eye_render import found
from eye_render import working_space as module
from eye_render.export import export_scene
from eye_render.working_space import luminance, working_space
from mathutils import Color
from scenes import add_node, add_object, link, node_material, quad_mesh, surface
from tools.engines import SET_UP

HAS_CHOICE = hasattr(bpy.data, "colorspace")
SPACES = ("Linear Rec.709", "Linear Rec.2020", "ACEScg")
# Of a colour's largest channel: the least of what separates the spaces for these subjects is 0.01.
TOLERANCE = 0.005
RED = (1.0, 0.3, 0.1, 1.0)


def test_blender_begins_with_rec709(scene, depsgraph_of):
    warnings = []
    assert working_space(warnings.append) == "Linear Rec.709"
    export_scene(depsgraph_of(), warnings.append, lambda: None)
    assert warnings == []
    assert luminance((1.0, 0.0, 0.0)) == pytest.approx(0.2126, abs=1e-4)


def test_another_space_is_named_and_shown_as_the_nearest(scene, monkeypatch):
    def ap0(color):  # SMPTE ST 2065-1, with its own white
        return Color(
            np.array([(0.9526, 0.0, 0.0001), (0.3440, 0.7282, -0.0721), (0.0, 0.0, 1.0088)])
            @ np.array(color)
        )

    warnings = []
    monkeypatch.setattr(module, "_xyz", ap0)
    assert working_space(warnings.append) == "ACEScg"
    (warning,) = warnings
    assert "shown as in ACEScg" in warning


def screen(material: bpy.types.Material) -> None:
    """Fills the picture."""
    shown = add_object(quad_mesh(size=20.0), "Screen")
    shown.location.z = -2.0
    shown.data.materials.append(material)


def glow(kind: str, output: int | str = 0, inputs: tuple = (), **settings) -> bpy.types.Node:
    """A screen that shines with what the node gives."""
    material = node_material()
    node = add_node(material, kind, **settings)
    for socket, value in zip(node.inputs, inputs, strict=False):
        socket.default_value = value
    link(material, node.outputs[output], surface(material, "ShaderNodeEmission").inputs["Color"])
    screen(material)
    return node


def blackbody(_folder):
    glow("ShaderNodeBlackbody", inputs=(2500.0,))


def wavelength(_folder):
    glow("ShaderNodeWavelength", inputs=(600.0,))


def rgb_to_bw(_folder):
    node = glow("ShaderNodeRGBToBW")
    material = bpy.data.materials[-1]
    rgb = add_node(material, "ShaderNodeRGB")
    rgb.outputs[0].default_value = RED
    link(material, rgb.outputs[0], node.inputs[0])


def colour_as_number(_folder):
    node = glow("ShaderNodeMath", operation="ADD")
    material = bpy.data.materials[-1]
    attribute = add_node(material, "ShaderNodeAttribute", attribute_name="tint")
    shown = bpy.data.objects["Screen"]
    tint = shown.data.attributes.new("tint", "FLOAT_COLOR", "POINT")
    tint.data.foreach_set("color", RED * 4)
    link(material, attribute.outputs["Color"], node.inputs[0])


def colour_through_a_number_of_a_group(_folder):
    tree = bpy.data.node_groups.new("Group", "ShaderNodeTree")
    tree.interface.new_socket("In", in_out="INPUT", socket_type="NodeSocketFloat")
    tree.interface.new_socket("Out", in_out="OUTPUT", socket_type="NodeSocketFloat")
    tree.links.new(
        tree.nodes.new("NodeGroupInput").outputs[0], tree.nodes.new("NodeGroupOutput").inputs[0]
    )
    node = glow("ShaderNodeGroup", node_tree=tree)
    material = bpy.data.materials[-1]
    rgb = add_node(material, "ShaderNodeRGB")
    rgb.outputs[0].default_value = RED
    link(material, rgb.outputs[0], node.inputs[0])


def picture(folder: Path, colorspace: str, is_float: bool = False) -> bpy.types.Image:
    drawn = bpy.data.images.new("drawn", 4, 4, float_buffer=is_float)
    drawn.pixels.foreach_set(np.tile(np.array((0.9, 0.3, 0.1, 1.0), np.float32), 16))
    drawn.filepath_raw = str(folder / f"drawn.{'exr' if is_float else 'png'}")
    drawn.file_format = "OPEN_EXR" if is_float else "PNG"
    drawn.save()
    image = bpy.data.images.load(drawn.filepath_raw)
    image.colorspace_settings.name = colorspace
    return image


def show(image: bpy.types.Image) -> None:
    glow("ShaderNodeTexImage", image=image)


def picture_in_srgb(folder):
    show(picture(folder, "sRGB"))


def packed_picture(folder):
    image = picture(folder, "sRGB")
    image.pack()
    show(image)


def picture_of_numbers(folder):
    show(picture(folder, "Non-Color"))


def bright_picture(folder):
    show(picture(folder, "Linear Rec.709", is_float=True))


def picture_in_acescg(folder):
    show(picture(folder, "ACEScg", is_float=True))


def byte_colours(_folder):
    glow("ShaderNodeVertexColor", layer_name="tint")
    mesh = bpy.data.objects["Screen"].data
    for corner in mesh.color_attributes.new("tint", "BYTE_COLOR", "CORNER").data:
        corner.color_srgb = RED


def sky(**settings) -> None:
    world = bpy.data.worlds.new("World")
    world.use_nodes = True
    bpy.context.scene.world = world
    node = add_node(world, "ShaderNodeTexSky", **settings)
    link(world, node.outputs[0], world.node_tree.nodes["Background"].inputs["Color"])
    bpy.context.scene.camera.rotation_euler = (1.9, 0.0, 0.4)


def preetham(_folder):
    sky(sky_type="PREETHAM")


def hosek_wilkie(_folder):
    sky(sky_type="HOSEK_WILKIE")


def single_scattering(_folder):
    sky(sky_type="SINGLE_SCATTERING", sun_disc=False)


def sun_disc(_folder):
    sky(sky_type="SINGLE_SCATTERING", sun_size=0.3, sun_elevation=0.5)
    camera = bpy.context.scene.camera
    camera.rotation_euler = (math.pi / 2 + 0.5, 0.0, 0.0)
    camera.data.angle = 0.05


def warm_lamp(_folder):
    material = node_material()
    surface(material, "ShaderNodeBsdfDiffuse")
    screen(material)
    light = bpy.data.lights.new("Sun", "SUN")
    light.use_temperature, light.temperature = True, 2500.0
    add_object(light, "Sun")


def hot_volume(_folder):
    material = node_material()
    volume = add_node(material, "ShaderNodeVolumePrincipled")
    volume.inputs["Density"].default_value = 0.0
    volume.inputs["Blackbody Intensity"].default_value = 1.0
    volume.inputs["Temperature"].default_value = 2500.0
    output = material.node_tree.get_output_node("CYCLES")
    link(material, volume.outputs[0], output.inputs["Volume"])
    bpy.ops.mesh.primitive_cube_add(location=(0.0, 0.0, -5.0))
    bpy.context.object.data.materials.append(material)
    bpy.context.scene.camera.data.angle = 0.05


SUBJECTS: list[Callable[[Path], None]] = [
    blackbody,
    wavelength,
    rgb_to_bw,
    colour_as_number,
    colour_through_a_number_of_a_group,
    picture_in_srgb,
    packed_picture,
    picture_of_numbers,
    bright_picture,
    picture_in_acescg,
    byte_colours,
    preetham,
    hosek_wilkie,
    single_scattering,
    sun_disc,
    warm_lamp,
    hot_volume,
]


@pytest.mark.skipif(not HAS_CHOICE, reason="before Blender 5.0 files have no working space")
@pytest.mark.parametrize("space", SPACES)
@pytest.mark.parametrize("subject", SUBJECTS, ids=lambda subject: subject.__name__)
def test_colours_are_those_of_cycles(subject, space, scene, render, tmp_path):
    if space != working_space():
        bpy.ops.wm.set_working_color_space(working_space=space, convert_colors=True)
    assert working_space() == space
    scene.render.resolution_x = scene.render.resolution_y = 8
    subject(tmp_path)
    means = {}
    for engine, set_up in SET_UP.items():
        set_up(scene, samples=16)
        means[engine] = render()[..., :3].mean(axis=(0, 1))
    difference = np.abs(means["EYE_RENDER"] - means["CYCLES"]).max()
    assert difference <= TOLERANCE * means["CYCLES"].max(), means


@pytest.mark.skipif(not HAS_CHOICE, reason="before Blender 5.0 files have no working space")
def test_the_pupil_knows_how_bright_a_working_colour_is(scene):
    def luminance_found(space: str) -> float:
        bpy.ops.wm.set_working_color_space(working_space=space, convert_colors=False)
        world = bpy.data.worlds.new("World")
        world.use_nodes = True
        world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.0, 0.0, 1.0, 1.0)
        scene.world = world
        scene.camera.data.eye_render.pupil_mode = "AUTO"
        bpy.ops.render.render()
        return float(found.last_pupil(scene.camera.data).facts["luminance_cd_m2"])

    blue = luminance_found("ACEScg") / luminance_found("Linear Rec.709")
    assert blue == pytest.approx(0.0580 / 0.0722, rel=1e-2)
