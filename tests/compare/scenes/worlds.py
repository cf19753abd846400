"""Worlds: what is seen of them, and a ball and a mirror in their light."""

import math

import bpy
import numpy as np
from features import feature
from stage import add, ball_mesh, camera, diffuse, dressed, floor, lamp, shader, sun, world
from tree import Tree, out

NEW_SKY = "Blender 5 computes this sky otherwise"


def under(paint, roughness: float = 0.0) -> Tree:
    """A grey ball and a metal one under a sky of what `paint` gives."""
    camera((0.0, -6.0, 2.0), (0, 0, 1.1), 40.0)
    floor()
    add(dressed(ball_mesh(), diffuse()), (-1.0, 0.0, 0.9))
    metal = shader("BsdfAnisotropic", {"Color": (0.9, 0.9, 0.9), "Roughness": roughness})
    add(dressed(ball_mesh(), metal), (1.0, 0.0, 0.9))
    tree = world()
    background = next(node for node in tree.nodes if node.type == "BACKGROUND")
    tree.set(background, "Color", paint(tree))
    return tree


@feature()
def gradient():
    """A sky by nodes: the direction's height in a colour ramp"""

    def paint(tree: Tree):
        up = tree.node("SeparateXYZ", {"Vector": out(tree.node("TexCoord"), "Generated")})
        node = tree.node("ValToRGB", {"Fac": tree.math("MULTIPLY_ADD", out(up, "Z"), 0.5, 0.5)})
        node.color_ramp.elements[0].color = (0.3, 0.2, 0.1, 1.0)
        node.color_ramp.elements[1].color = (0.2, 0.5, 1.0, 1.0)
        return out(node, "Color")

    under(paint)


def panorama(width: int = 64, sun: float = 0.0) -> bpy.types.Image:
    """Equirectangular: sky, ground and a window; `sun` shines from a few pixels."""
    height = width // 2
    picture = np.ones((height, width, 4), np.float32)
    picture[: height // 2, :, :3] = (0.25, 0.2, 0.15)
    picture[height // 2 :, :, :3] = (0.3, 0.45, 0.7)
    across, up = np.meshgrid(np.arange(width) / width, np.arange(height) / height)
    window = (abs(across - 0.35) < 0.08) & (abs(up - 0.65) < 0.1)
    picture[window, :3] = (1.5, 1.2, 0.8)
    if sun:
        disk = (abs(across - 0.62) < 0.016) & (abs(up - 0.8) < 0.03)
        picture[disk, :3] = (sun, 0.9 * sun, 0.7 * sun)
    image = bpy.data.images.new("Panorama", width, height, float_buffer=True)
    image.colorspace_settings.name = "Non-Color"
    image.pixels.foreach_set(picture.ravel())
    image.pack()
    return image


def environment(image: bpy.types.Image, turn=(0, 0, 0), **properties):
    def paint(tree: Tree):
        inputs = {"Vector": out(tree.node("TexCoord"), "Generated"), "Rotation": turn}
        mapping = tree.node("Mapping", inputs)
        node = tree.node("TexEnvironment", {"Vector": mapping}, **properties)
        node.image = image
        return node

    return paint


@feature()
def environment_picture():
    """An equirectangular picture"""
    under(environment(panorama()))


@feature(samples=512)
def environment_with_sun():
    """A picture with a sun a hundred times as bright, which must be aimed at"""
    under(environment(panorama(sun=60.0)), 0.4)


@feature(samples=512)
def environment_turned():
    """The picture with the sun, turned about two axes"""
    under(environment(panorama(sun=60.0), (0.2, 0.0, 2.0)), 0.4)


@feature()
def environment_mirror_ball():
    """A picture of a mirror ball"""
    under(environment(panorama(32), projection="MIRROR_BALL"))


@feature()
def environment_closest():
    """A coarse picture with its pixels to be seen"""
    under(environment(panorama(16), interpolation="Closest"))


def sky(kinds: tuple[str, ...], factor: float = 0.15, **settings):
    def paint(tree: Tree):
        node = tree.node("TexSky", {}, sky_type=kinds)
        for name, value in settings.items():
            if hasattr(node, name):
                setattr(node, name, value)
        return tree.scaled(node, factor, 0.0)

    return paint


@feature(samples=512)
def sky_nishita():
    """The sky by Nishita, its sun 20 degrees high, no disk"""
    settings = {"sun_elevation": math.radians(20), "sun_rotation": 2.0, "sun_disc": False}
    under(sky(("NISHITA", "SINGLE_SCATTERING"), **settings))


@feature(samples=512)
def sky_nishita_sun():
    """The sky by Nishita with the sun's disk"""
    settings = {"sun_elevation": math.radians(35), "sun_rotation": 2.5, "sun_disc": True}
    settings |= {"sun_intensity": 0.02, "sun_size": math.radians(4), "air_density": 1.5}
    under(sky(("NISHITA", "SINGLE_SCATTERING"), **settings, altitude=500.0, ozone_density=2.0))


@feature()
def sky_hosek():
    """The sky by Hosek and Wilkie"""
    settings = {"turbidity": 3.0, "ground_albedo": 0.4, "sun_direction": (0.4, 0.5, 0.6)}
    under(sky(("HOSEK_WILKIE",), 0.6, **settings))


@feature()
def sky_preetham():
    """The sky by Preetham"""
    under(sky(("PREETHAM",), 0.6, turbidity=4.0, sun_direction=(-0.4, 0.5, 0.4)))


@feature()
def seen_but_not_lighting():
    """A world that is one colour to the camera and another to the rest"""

    def paint(tree: Tree):
        inputs = {"Fac": out(tree.node("LightPath"), "Is Camera Ray")}
        inputs |= {"Color1": (0.9, 0.5, 0.2), "Color2": (0.05, 0.3, 0.1)}
        return tree.node("MixRGB", inputs)

    under(paint)


@feature()
def noise():
    """A sky of noise"""
    under(lambda tree: out(tree.node("TexNoise", {"Scale": 3.0}), "Color"))


@feature()
def none():
    """No world"""
    under(lambda tree: (0, 0, 0, 1), 0.4)
    sun()
    bpy.context.scene.world = None


@feature()
def without_nodes():
    """A world that uses no nodes"""
    under(lambda tree: (0, 0, 0, 1))
    plain = bpy.data.worlds.new("Plain")
    bpy.context.scene.world = plain
    if plain.node_tree is None:
        plain.color = (0.3, 0.2, 0.4)
    else:  # from Blender 5.0 every world has nodes
        Tree(plain).surface("Background", {"Color": (0.3, 0.2, 0.4)})


@feature()
def hidden_from_glossy():
    """A world that mirrors do not see"""
    under(lambda tree: (0.3, 0.5, 0.9, 1))
    bpy.context.scene.world.cycles_visibility.glossy = False


@feature()
def hidden_from_diffuse():
    """A world that lights no diffuse surface, but mirrors show; and a sun"""
    under(lambda tree: (0.3, 0.5, 0.9, 1), 0.2)
    sun(1.5)
    bpy.context.scene.world.cycles_visibility.diffuse = False


@feature(bounces=4, samples=512)
def fog():
    """A world full of thin fog about a lamp"""
    tree = under(lambda tree: (0.4, 0.5, 0.7, 1), 0.5)
    lamp("POINT", 200.0, (0.0, -1.5, 2.5), shadow_soft_size=0.3)
    scatter = tree.node("VolumeScatter", {"Color": (0.8, 0.8, 0.8), "Density": 0.05})
    tree.set(tree.output, "Volume", scatter)


@feature(bounces=4)
def absorbing_fog():
    """A world full of what only absorbs, about a lamp"""
    tree = under(lambda tree: (0.4, 0.5, 0.7, 1), 0.5)
    lamp("POINT", 600.0, (0.0, -1.5, 2.5), shadow_soft_size=0.3)
    inputs = {"Color": (0.9, 0.4, 0.2), "Density": 0.1}
    tree.set(tree.output, "Volume", tree.node("VolumeAbsorption", inputs))
