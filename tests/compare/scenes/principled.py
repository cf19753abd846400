"""The Principled BSDF, an input at a time, under the names of Blender 4."""

from features import feature
from stage import ball, ball_of, new_tree
from tree import WALK, out, set_property

PAINT = (0.6, 0.25, 0.1)
GOLD = (0.9, 0.65, 0.3)

LAYERS = "before Blender 4.0 Principled layers its lobes otherwise"


def principled(**more) -> None:
    """Inputs by their names with underscores for spaces."""
    inputs = {"Base Color": PAINT, "Roughness": 0.4}
    inputs |= {name.replace("_", " "): value for name, value in more.items()}
    ball_of("BsdfPrincipled", inputs)


@feature()
def base():
    """A dielectric over a diffuse base, roughness 0.4"""
    principled()


@feature()
def smooth():
    """Roughness 0.05"""
    principled(Roughness=0.05)


@feature()
def rough():
    """Roughness 1"""
    principled(Roughness=1.0)


@feature()
def ior():
    """IOR 2.2"""
    principled(IOR=2.2)


@feature(since=(4, 3))
def diffuse_roughness():
    """Oren-Nayar base, roughness 1"""
    principled(Diffuse_Roughness=1.0, Roughness=0.6)


@feature()
def metal():
    """Metallic 1, roughness 0.3"""
    principled(Base_Color=GOLD, Metallic=1.0, Roughness=0.3)


@feature()
def mirror():
    """Metallic 1, roughness 0"""
    principled(Base_Color=GOLD, Metallic=1.0, Roughness=0.0)


@feature()
def half_metal():
    """Metallic 0.5"""
    principled(Base_Color=GOLD, Metallic=0.5)


@feature(before_4=LAYERS)
def specular():
    """Specular level 1"""
    principled(Specular_IOR_Level=1.0)


@feature(since=(4, 0))
def specular_tint():
    """A metal whose edge is tinted"""
    principled(Base_Color=GOLD, Metallic=1.0, Specular_Tint=(0.2, 0.4, 1.0, 1.0))


@feature(since=(4, 0))
def specular_tint_dielectric():
    """A dielectric whose reflection is tinted"""
    principled(IOR=2.0, Roughness=0.2, Specular_Tint=(0.2, 0.4, 1.0, 1.0))


@feature()
def anisotropic():
    """Anisotropic 0.8, turned by an eighth"""
    principled(
        Base_Color=GOLD, Metallic=1.0, Roughness=0.3, Anisotropic=0.8, Anisotropic_Rotation=0.125
    )


@feature(before_4="before Blender 4.0 the sheen was another model")
def sheen():
    """Sheen 1"""
    principled(Base_Color=(0.1, 0.02, 0.02), Roughness=1.0, Sheen_Weight=1.0)


@feature(since=(4, 0))
def sheen_tint():
    """Sheen of a colour, roughness 0.3"""
    principled(
        Base_Color=(0.02, 0.02, 0.1),
        Roughness=1.0,
        Sheen_Weight=1.0,
        Sheen_Roughness=0.3,
        Sheen_Tint=(1.0, 0.4, 0.1, 1.0),
    )


@feature(before_4=LAYERS)
def coat():
    """A smooth coat over a rough base"""
    principled(Roughness=0.8, Coat_Weight=1.0, Coat_Roughness=0.05)


@feature(since=(4, 0))
def coat_tint():
    """A coat that colours what is below, IOR 1.8"""
    principled(Coat_Weight=1.0, Coat_IOR=1.8, Coat_Tint=(0.3, 0.9, 0.4, 1.0), Roughness=0.5)


@feature(bounces=4)
def transmission():
    """Clear glass"""
    principled(Base_Color=(1, 1, 1), Transmission_Weight=1.0, Roughness=0.0, IOR=1.45)


@feature(bounces=4, samples=512)
def rough_transmission():
    """Green rough glass, roughness 0.3"""
    principled(Base_Color=(0.5, 0.9, 0.6), Transmission_Weight=1.0, Roughness=0.3, IOR=1.45)


@feature(bounces=4)
def half_transmission():
    """Transmission 0.5"""
    principled(Transmission_Weight=0.5, Roughness=0.1, IOR=1.45)


@feature()
def emission():
    """Emission of a colour over a base"""
    principled(Emission_Color=(0.1, 0.3, 0.8), Emission_Strength=0.6)


@feature(bounces=4)
def alpha():
    """Alpha 0.4"""
    principled(Alpha=0.4)


@feature(bounces=4, samples=512)
def subsurface():
    """Random walk, a third of the radius deep"""
    _subsurface(WALK)


@feature(bounces=4, samples=512)
def subsurface_burley():
    """Burley's diffusion"""
    _subsurface("BURLEY")


def _subsurface(method: str | tuple[str, ...]) -> None:
    tree = new_tree()
    node = tree.surface("BsdfPrincipled", {"Base Color": (0.8, 0.5, 0.4), "Roughness": 0.5})
    set_property(node, "subsurface_method", method)
    tree.set(node, "Subsurface Weight", 1.0)
    if "Subsurface Color" in node.inputs:  # before Blender 4.0, with the scale in the radius
        tree.set(node, "Subsurface Color", (0.8, 0.5, 0.4))
        tree.set(node, "Subsurface Radius", (0.3, 0.1, 0.05))
    else:
        tree.set(node, "Subsurface Radius", (1.0, 1 / 3, 1 / 6))
        tree.set(node, "Subsurface Scale", 0.3)
    ball(tree.datablock)


@feature(since=(4, 2))
def thin_film():
    """A film of 500 nm on a dielectric"""
    principled(
        Base_Color=(0.05, 0.05, 0.05), Roughness=0.1, Thin_Film_Thickness=500.0, Thin_Film_IOR=1.8
    )


@feature(before_4=LAYERS)
def coat_normal():
    """A coat whose normal is bumped, over a base whose normal is not"""
    tree = new_tree()
    noise = tree.node("TexNoise", {"Scale": 4.0, "Detail": 0.0})
    bump = tree.node("Bump", {"Height": out(noise, "Fac"), "Distance": 0.5})
    tree.surface(
        "BsdfPrincipled",
        {
            "Base Color": PAINT,
            "Roughness": 0.5,
            "Coat Weight": 1.0,
            "Coat Roughness": 0.1,
            "Coat Normal": bump,
        },
    )
    ball(tree.datablock)


@feature()
def multiple_scattering():
    """Rough metal by the GGX without the energy of later scatterings"""
    ball_of(
        "BsdfPrincipled",
        {"Base Color": GOLD, "Metallic": 1.0, "Roughness": 0.8},
        distribution="GGX",
    )
