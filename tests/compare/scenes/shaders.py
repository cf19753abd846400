"""The other shader nodes."""

import bpy
from features import feature
from stage import ball, ball_of, diffuse, new_tree, world
from tree import WALK, Tree, out

RED = (0.8, 0.2, 0.1)
BLUE = (0.1, 0.3, 0.8)


@feature()
def diffuse_smooth():
    """Lambert"""
    ball_of("BsdfDiffuse", {"Color": RED, "Roughness": 0.0})


@feature()
def diffuse_rough():
    """Oren-Nayar, roughness 1"""
    ball_of("BsdfDiffuse", {"Color": RED, "Roughness": 1.0})


@feature()
def glossy_sharp():
    """A mirror"""
    ball_of("BsdfAnisotropic", {"Color": RED, "Roughness": 0.0}, distribution="GGX")


@feature()
def glossy_ggx():
    """GGX, roughness 0.4"""
    ball_of("BsdfAnisotropic", {"Color": RED, "Roughness": 0.4}, distribution="GGX")


@feature()
def glossy_multi_ggx():
    """GGX with all scatterings, roughness 0.8"""
    ball_of("BsdfAnisotropic", {"Color": RED, "Roughness": 0.8}, distribution="MULTI_GGX")


@feature()
def glossy_beckmann():
    """Beckmann, roughness 0.4"""
    ball_of("BsdfAnisotropic", {"Color": RED, "Roughness": 0.4}, distribution="BECKMANN")


@feature()
def glossy_ashikhmin():
    """Ashikhmin and Shirley, roughness 0.4"""
    ball_of("BsdfAnisotropic", {"Color": RED, "Roughness": 0.4}, distribution="ASHIKHMIN_SHIRLEY")


@feature()
def glossy_anisotropic():
    """Anisotropy 0.7 about a radial tangent, turned by an eighth"""
    tree = new_tree()
    tangent = tree.node("Tangent", direction_type="RADIAL", axis="Z")
    inputs = {"Color": RED, "Roughness": 0.4, "Anisotropy": 0.7, "Rotation": 0.125}
    tree.surface("BsdfAnisotropic", inputs | {"Tangent": tangent}, distribution="GGX")
    ball(tree.datablock)


@feature(since=(4, 3))
def metallic_f82():
    """Metallic, by colour and edge tint"""
    inputs = {"Base Color": (0.9, 0.6, 0.2), "Edge Tint": (0.3, 0.5, 1.0), "Roughness": 0.3}
    ball_of("BsdfMetallic", inputs, fresnel_type="F82")


@feature(since=(4, 3))
def metallic_conductor():
    """Metallic, by index and extinction of gold"""
    inputs = {"IOR": (0.18, 0.42, 1.37), "Extinction": (3.42, 2.35, 1.77), "Roughness": 0.3}
    ball_of("BsdfMetallic", inputs, fresnel_type="PHYSICAL_CONDUCTOR")


@feature(bounces=4)
def glass():
    """Clear glass"""
    inputs = {"Color": (1, 1, 1), "Roughness": 0.0, "IOR": 1.5}
    ball_of("BsdfGlass", inputs, distribution="GGX")


@feature(bounces=4, samples=512)
def glass_rough():
    """Coloured glass, roughness 0.3"""
    inputs = {"Color": (0.6, 0.9, 0.8), "Roughness": 0.3, "IOR": 1.5}
    ball_of("BsdfGlass", inputs, distribution="GGX")


@feature(bounces=4, samples=512)
def glass_multi_ggx():
    """Glass with all scatterings, roughness 0.6"""
    inputs = {"Color": (0.9, 0.9, 0.9), "Roughness": 0.6, "IOR": 1.5}
    ball_of("BsdfGlass", inputs, distribution="MULTI_GGX")


@feature(bounces=4)
def glass_lighter():
    """A bubble: IOR below 1"""
    inputs = {"Color": (1, 1, 1), "Roughness": 0.0, "IOR": 0.7}
    ball_of("BsdfGlass", inputs, distribution="GGX")


@feature(bounces=4)
def refraction():
    """Refraction without reflection"""
    inputs = {"Color": (0.9, 0.9, 0.6), "Roughness": 0.0, "IOR": 1.3}
    ball_of("BsdfRefraction", inputs, distribution="GGX")


@feature(bounces=4, samples=512)
def refraction_rough():
    """Refraction, roughness 0.3"""
    inputs = {"Color": (0.9, 0.9, 0.6), "Roughness": 0.3, "IOR": 1.3}
    ball_of("BsdfRefraction", inputs, distribution="GGX")


@feature(bounces=4)
def transparent():
    """A coloured filter, and its coloured shadow"""
    ball_of("BsdfTransparent", {"Color": (0.9, 0.6, 0.5)})


@feature(bounces=4)
def translucent():
    """Diffuse light through the surface"""
    ball_of("BsdfTranslucent", {"Color": (0.8, 0.7, 0.3)})


@feature(since=(4, 0))
def sheen():
    """Sheen by microfibers, roughness 0.4"""
    inputs = {"Color": (0.9, 0.7, 0.5), "Roughness": 0.4}
    ball_of("BsdfSheen", inputs, distribution="MICROFIBER")


@feature()
def velvet():
    """Sheen by Ashikhmin: the former Velvet"""
    tree = new_tree()
    node = tree.surface("BsdfSheen", {"Color": (0.9, 0.7, 0.5)})
    if hasattr(node, "distribution"):
        node.distribution = "ASHIKHMIN"
        tree.set(node, "Roughness", 0.4)
    else:
        tree.set(node, "Sigma", 0.4)
    ball(tree.datablock)


@feature()
def toon_diffuse():
    """Diffuse toon"""
    ball_of("BsdfToon", {"Color": RED, "Size": 0.5, "Smooth": 0.1}, component="DIFFUSE")


@feature()
def toon_glossy():
    """Glossy toon"""
    ball_of("BsdfToon", {"Color": RED, "Size": 0.3, "Smooth": 0.1}, component="GLOSSY")


@feature()
def emission():
    """A shining ball that lights the floor"""
    ball_of("Emission", {"Color": BLUE, "Strength": 1.0})


@feature(view="OVER_MAGENTA")
def holdout():
    """A hole in the picture's alpha"""
    ball_of("Holdout")


@feature()
def mix():
    """Mix of two shaders by a checker"""

    def build(tree: Tree):
        checker = tree.node("TexChecker", {"Vector": out(tree.node("TexCoord"), "UV")})
        tree.set(checker, "Scale", 8.0)
        return tree.node("MixShader", {"Fac": out(checker, "Fac")})

    _two_shaders(build)


@feature()
def mix_third():
    """Mix of two shaders by a third"""
    _two_shaders(lambda tree: tree.node("MixShader", {"Fac": 1 / 3}))


@feature()
def add():
    """Sum of two shaders"""
    _two_shaders(lambda tree: tree.node("AddShader"))


def _two_shaders(join) -> None:
    tree = new_tree()
    joined = join(tree)
    red = tree.node("BsdfDiffuse", {"Color": (0.5, 0.1, 0.05)})
    blue = tree.node("BsdfAnisotropic", {"Color": (0.1, 0.2, 0.4), "Roughness": 0.1})
    tree.links.new(red.outputs[0], joined.inputs[-2])
    tree.links.new(blue.outputs[0], joined.inputs[-1])
    tree.set(tree.output, "Surface", joined)
    ball(tree.datablock)


@feature(bounces=4, samples=512)
def subsurface():
    """Subsurface scattering, random walk"""
    _subsurface(WALK)


@feature(bounces=4, samples=512)
def subsurface_burley():
    """Subsurface scattering, Burley's diffusion"""
    _subsurface("BURLEY")


def _subsurface(falloff: str | tuple[str, ...]) -> None:
    inputs = {"Color": (0.7, 0.8, 0.5), "Scale": 0.3, "Radius": (1.0, 0.6, 0.3)}
    ball_of("SubsurfaceScattering", inputs, falloff=falloff)


@feature()
def nothing():
    """No shader at the output: black, and in the way"""
    ball(new_tree().datablock)


@feature()
def no_material():
    """A mesh without a material"""
    shown = ball(diffuse())
    shown.data.materials.clear()


@feature()
def without_nodes():
    """A material that uses no nodes"""
    material = bpy.data.materials.new("Plain")
    if material.node_tree is None:
        material.diffuse_color = (*RED, 1.0)
        ball(material)
    else:  # from Blender 5.0 every material has nodes
        ball(diffuse(RED))


@feature()
def background_strength():
    """A world of strength 2"""
    ball(diffuse())
    world((0.2, 0.25, 0.3), 2.0)


@feature(bounces=4)
def opaque_shadow():
    """A see-through ball whose shadow is not, in light that shadow rays alone find"""
    shown = ball_of("BsdfPrincipled", {"Base Color": RED, "Alpha": 0.3, "Roughness": 1.0})
    bpy.data.objects["Lamp"].data.angle = 0.0
    world((0.0, 0.0, 0.0))
    material = shown.data.materials[0]
    since_4 = hasattr(material, "use_transparent_shadow")
    (material if since_4 else material.cycles).use_transparent_shadow = False
