"""Passes, each as the compositor hands it on: what is seen is the pass."""

import bpy
from animation import animated
from features import feature
from stage import (
    add,
    ball_mesh,
    camera,
    diffuse,
    dressed,
    floor,
    new_tree,
    shader,
    sun,
    world,
)
from tools.meshes import cube_mesh


def still_life() -> None:
    """A diffuse cube with UVs, a shiny ball, a glass ball and a glowing one."""
    camera((0.0, -6.0, 2.2), (0, 0, 0.6), 30.0)
    floor()
    world()
    sun()
    cube = add(dressed(cube_mesh(0.8), diffuse((0.7, 0.3, 0.2))), (-1.0, 0.5, 0.4))
    cube.rotation_euler, cube.pass_index = (0, 0, 0.5), 3
    shiny = shader("BsdfPrincipled", {"Base Color": (0.2, 0.4, 0.8), "Roughness": 0.3})
    shiny.pass_index = 5
    add(dressed(ball_mesh(0.45), shiny), (0.1, -0.5, 0.45)).pass_index = 7
    glass = shader("BsdfGlass", {"Color": (0.8, 0.95, 0.8), "Roughness": 0.15, "IOR": 1.4})
    add(dressed(ball_mesh(0.45), glass), (1.0, 0.4, 0.45))
    glow = shader("Emission", {"Color": (0.9, 0.6, 0.2), "Strength": 0.8})
    add(dressed(ball_mesh(0.2), glow), (-0.5, -1.0, 0.2))


def still_life_in_clear_pixels() -> None:
    """For light that is divided by the surfaces' colour: of a surface that a few samples of a
    pixel meet, at the filter's far end, the quotient would be noise."""
    still_life()
    bpy.context.scene.cycles.pixel_filter_type = "BOX"


QUOTIENT = "a quotient, at edges of little by little"
BEFORE_4 = "before Blender 4.0 Principled splits its light otherwise"

# What it is, the view layer's switch, the pass's names from new to old, and how it is looked at.
PASSES = {
    "depth": ("Depth", "use_pass_z", ("Depth",), {"view": "TENTH"}),
    "position": ("Position", "use_pass_position", ("Position",), {"view": "SIGNED"}),
    "normal": ("Normal", "use_pass_normal", ("Normal",), {"view": "SIGNED"}),
    "uv": ("UV", "use_pass_uv", ("UV",), {}),
    "object_index": ("Object index", "use_pass_object_index", ("Object Index", "IndexOB"),
                     {"view": "TENTH"}),
    "material_index": ("Material index", "use_pass_material_index",
                       ("Material Index", "IndexMA"), {"view": "TENTH"}),
    "emission": ("Emission", "use_pass_emit", ("Emission", "Emit"), {}),
    "environment": ("Environment", "use_pass_environment", ("Environment", "Env"), {}),
    "ambient_occlusion": ("Ambient occlusion", "use_pass_ambient_occlusion",
                          ("Ambient Occlusion", "AO"), {}),
    "denoising_albedo": ("Denoising albedo", "denoising_store_passes", ("Denoising Albedo",),
                         {"before_4": BEFORE_4}),
    "denoising_normal": ("Denoising normal", "denoising_store_passes", ("Denoising Normal",),
                         {"view": "SIGNED"}),
    "diffuse_direct": ("Direct diffuse light", "use_pass_diffuse_direct",
                       ("Diffuse Direct", "DiffDir"),
                       {"samples": 512}),
    "diffuse_indirect": ("Indirect diffuse light", "use_pass_diffuse_indirect",
                         ("Diffuse Indirect", "DiffInd"),
                         {"samples": 512}),
    "diffuse_color": ("Diffuse colour", "use_pass_diffuse_color",
                      ("Diffuse Color", "DiffCol"), {}),
    "glossy_direct": ("Direct glossy light", "use_pass_glossy_direct",
                      ("Glossy Direct", "GlossDir"), {}),
    "glossy_indirect": ("Indirect glossy light", "use_pass_glossy_indirect",
                        ("Glossy Indirect", "GlossInd"),
                        {"samples": 512}),
    "glossy_color": ("Glossy colour", "use_pass_glossy_color", ("Glossy Color", "GlossCol"),
                     {"before_4": BEFORE_4}),
    "transmission_direct": ("Direct light through glass", "use_pass_transmission_direct",
                            ("Transmission Direct", "TransDir"), {}),
    "transmission_indirect": ("Indirect light through glass", "use_pass_transmission_indirect",
                              ("Transmission Indirect", "TransInd"), {"samples": 512}),
    "transmission_color": ("Colour of glass", "use_pass_transmission_color",
                           ("Transmission Color", "TransCol"), {}),
    "cryptomatte_object": ("Coverage by the foremost object of Cryptomatte",
                           "use_pass_cryptomatte_object",
                           ("CryptoObject00", "Cryptomatte Object 00"), {"view": "GREEN"}),
    "cryptomatte_material": ("Coverage by the foremost material of Cryptomatte",
                             "use_pass_cryptomatte_material",
                             ("CryptoMaterial00", "Cryptomatte Material 00"), {"view": "GREEN"}),
}  # fmt: skip

for _name, (_about, _switch, _sockets, _more) in PASSES.items():
    _build = (
        still_life_in_clear_pixels if "_direct" in _name or "_indirect" in _name else still_life
    )
    feature(_name, _about, shows_pass=(_switch, *_sockets), bounces=4, **_more)(_build)


@feature(shows_pass=("use_pass_mist", "Mist"))
def mist():
    """Mist from 4 to 9 metres, quadratic"""
    still_life()
    settings = bpy.context.scene.world.mist_settings
    settings.start, settings.depth, settings.falloff = 4.0, 5.0, "QUADRATIC"


@feature(shows_pass=(None, "Weight"))
def aov_value():
    """A number that a material writes"""
    _aov("Weight", "VALUE", "Value", 0.6)


@feature(shows_pass=(None, "Paint"))
def aov_color():
    """A colour that a material writes"""
    _aov("Paint", "COLOR", "Color", (0.9, 0.3, 0.1, 1.0))


def _aov(name: str, kind: str, socket: str, value) -> None:
    still_life()
    aov = bpy.context.scene.view_layers[0].aovs.add()
    aov.name, aov.type = name, kind
    tree = new_tree()
    tree.surface("BsdfDiffuse", {"Color": (0.3, 0.6, 0.3)})
    node = tree.node("OutputAOV", {socket: value})
    if hasattr(node, "aov_name"):
        node.aov_name = name
    else:  # before Blender 4.0
        node.name = name
    add(dressed(ball_mesh(0.3), tree.datablock), (0.5, -1.4, 0.3))


@feature(shows_pass=(None, "Combined_key"))
def light_group():
    """The light of one group of lamps"""
    still_life()
    layer = bpy.context.scene.view_layers[0]
    layer.lightgroups.add(name="key")
    bpy.data.objects["Lamp"].lightgroup = "key"


@feature(shows_pass=("use_pass_shadow_catcher", "Shadow Catcher"), samples=512, differs=QUOTIENT)
def shadow_catcher():
    """What the light leaves on a shadow catcher"""
    still_life()
    bpy.data.objects["Floor"].is_shadow_catcher = True


@feature(shows_pass=("use_pass_shadow_catcher", "Shadow Catcher"), samples=512)
def shadow_catcher_unlit():
    """The same in red light alone: what nothing lights is not darkened"""
    camera((0.0, -6.0, 2.2), (0, 0, 0.6), 30.0)
    floor()
    world((0.0, 0.0, 0.0))
    sun().data.color = (1.0, 0.0, 0.0)
    add(dressed(ball_mesh(0.6), diffuse((0.7, 0.7, 0.7))), (0.0, 0.0, 0.6))
    bpy.data.objects["Floor"].is_shadow_catcher = True


@feature(
    shows_pass=("use_pass_vector", "Vector"),
    view="MOTION",
    differs="at edges what lies on the middle ray, as in Depth, where Cycles has a mean",
)
def vector():
    """How things move in the picture: a turning cube, a ball that grows, and the camera"""
    still_life()
    scene = bpy.context.scene
    cube = next(shown for shown in scene.objects if shown.pass_index == 3)
    animated(cube, "rotation_euler", (0, 0, -0.1), (0, 0, 1.1))
    shiny = next(shown for shown in scene.objects if shown.pass_index == 7)
    shiny.shape_key_add(name="Basis")
    wide = shiny.shape_key_add(name="Wide")
    for vertex, point in zip(shiny.data.vertices, wide.data, strict=True):
        point.co = vertex.co * 1.5
    animated(wide, "value", -0.4, 0.4)
    animated(scene.camera, "location", (0.3, -6.0, 2.1), (-0.3, -6.0, 2.3))


@feature(shows_pass=(None, "Combined_fire"), bounces=4)
def light_group_of_a_volume():
    """The light of a glowing gas"""
    still_life()
    bpy.context.scene.view_layers[0].lightgroups.add(name="fire")
    tree = new_tree()
    gas = tree.node("Emission", {"Color": (0.9, 0.4, 0.1), "Strength": 2.0})
    tree.set(tree.output, "Volume", gas)
    add(dressed(ball_mesh(0.5), tree.datablock), (0.2, -1.4, 0.6)).lightgroup = "fire"
