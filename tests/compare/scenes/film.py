"""The film: alpha, pixel filter, exposure, clamping, caustics and the part that is rendered."""

import bpy
from features import feature
from stage import (
    BALL_CENTRE,
    add,
    ball,
    ball_mesh,
    ball_of,
    camera,
    diffuse,
    dressed,
    floor,
    glow,
    grid_mesh,
    lamp,
    new_tree,
    shader,
    shows,
    world,
)
from tree import out

PAINT = (0.6, 0.45, 0.3)


@feature(view="OVER_MAGENTA")
def transparent():
    """A transparent film: the sky is not there, its light is"""
    ball(diffuse(PAINT))
    bpy.data.objects["Floor"].hide_render = True
    bpy.context.scene.render.film_transparent = True


@feature(view="OVER_MAGENTA", bounces=4)
def transparent_alpha():
    """A transparent film behind a ball whose alpha is a half"""
    ball_of("BsdfPrincipled", {"Base Color": PAINT, "Alpha": 0.5, "Roughness": 1.0})
    bpy.data.objects["Floor"].hide_render = True
    bpy.context.scene.render.film_transparent = True


@feature(view="OVER_MAGENTA", samples=256)
def transparent_sum():
    """A transparent film behind a ball that is clear and mirrors, too: it covers nothing"""
    tree = new_tree()
    clear = tree.node("BsdfTransparent")
    glossy = tree.node("BsdfAnisotropic", {"Color": PAINT, "Roughness": 0.5})
    tree.surface("AddShader", {"Shader": clear, "Shader_001": glossy})
    ball(tree.datablock)
    bpy.data.objects["Floor"].hide_render = True
    bpy.context.scene.render.film_transparent = True


@feature(view="OVER_MAGENTA", bounces=4)
def transparent_glass():
    """A transparent film behind glass, through which nothing shines unless asked for"""
    ball_of("BsdfGlass", {"Color": (0.9, 0.9, 0.9), "Roughness": 0.0, "IOR": 1.3})
    bpy.data.objects["Floor"].hide_render = True
    scene = bpy.context.scene
    scene.render.film_transparent = scene.cycles.film_transparent_glass = True


@feature()
def exposure():
    """The film's exposure of a half"""
    ball(diffuse(PAINT))
    bpy.context.scene.cycles.film_exposure = 0.5


def grille() -> None:
    """Black and white bars a pixel and a half wide."""
    camera((0, 0, 4), (0, 0, 0), 28.0)
    world()

    def paint(tree):
        vector = tree.scaled(out(tree.node("TexCoord"), "UV"), 1.0, 0.013)
        inputs = {"Vector": vector, "Scale": 21.0, "Color1": (0.9, 0.9, 0.9)}
        return tree.node("TexChecker", inputs | {"Color2": (0.02, 0.02, 0.02)})

    add(dressed(grid_mesh(1, 1, (1.7, 1.7)), shows(paint))).rotation_euler = (0, 0, 0.3)


@feature()
def filter_blackman_harris():
    """Blackman-Harris, 1.5 pixels, of bars at the limit"""
    grille()


@feature()
def filter_wide():
    """Blackman-Harris, 4 pixels"""
    grille()
    bpy.context.scene.cycles.filter_width = 4.0


@feature()
def filter_gaussian():
    """Gaussian, 3 pixels"""
    grille()
    cycles = bpy.context.scene.cycles
    cycles.pixel_filter_type, cycles.filter_width = "GAUSSIAN", 3.0


@feature()
def filter_box():
    """Box"""
    grille()
    bpy.context.scene.cycles.pixel_filter_type = "BOX"


@feature()
def border():
    """A part of the picture, cropped"""
    ball(diffuse(PAINT))
    render = bpy.context.scene.render
    render.use_border = render.use_crop_to_border = True
    render.border_min_x, render.border_max_x = 0.25, 0.75
    render.border_min_y, render.border_max_y = 0.5, 1.0


def bright_corner() -> None:
    """A ball beside a shining sheet, so that indirect light is strong."""
    camera()
    floor()
    world((0.1, 0.1, 0.12))
    add(dressed(ball_mesh(), diffuse(PAINT)), BALL_CENTRE)
    sheet = add(dressed(grid_mesh(1, 1, (1.0, 1.0)), glow((1, 0.9, 0.8), 15.0)), (-1.6, 0, 0.8))
    sheet.rotation_euler = (0, 1.57, 0)


@feature(bounces=4)
def clamp_indirect():
    """Indirect light clamped to 0.5"""
    bright_corner()
    bpy.context.scene.cycles.sample_clamp_indirect = 0.5


@feature(bounces=4, differs="what is cut off depends on how light is sampled")
def clamp_direct():
    """Direct light clamped to 1"""
    bright_corner()
    bpy.context.scene.cycles.sample_clamp_direct = 1.0


def glass_and_mirror() -> None:
    camera()
    floor()
    world((0.1, 0.1, 0.12))
    glass = shader("BsdfGlass", {"Color": (1, 1, 1), "Roughness": 0.05, "IOR": 1.5})
    metal = shader("BsdfAnisotropic", {"Color": (0.9, 0.7, 0.4), "Roughness": 0.15})
    add(dressed(ball_mesh(0.6), glass), (-0.7, 0, 0.6))
    add(dressed(ball_mesh(0.6), metal), (0.7, 0, 0.6))
    lamp("AREA", 150.0, (-2.5, -1.0, 3.0), shape="SQUARE", size=1.5)


@feature(bounces=4)
def without_caustics():
    """No caustics of either kind"""
    glass_and_mirror()
    cycles = bpy.context.scene.cycles
    cycles.caustics_reflective = cycles.caustics_refractive = False


@feature(bounces=4, samples=1024)
def caustics():
    """Caustics of glass and metal"""
    glass_and_mirror()


@feature(bounces=0)
def direct_light_only():
    """No bounce at all"""
    ball(diffuse(PAINT))


@feature(bounces=8)
def many_bounces():
    """Eight bounces in a white corner"""
    camera()
    world((0.5, 0.5, 0.5))
    white = diffuse((0.9, 0.9, 0.9))
    add(dressed(grid_mesh(1, 1, (8, 8)), white))
    for x, turn in ((-0.8, 1.57), (0.8, -1.57)):
        add(dressed(grid_mesh(1, 1, (3, 3)), white), (x, 0, 1.0)).rotation_euler = (0, turn, 0)
