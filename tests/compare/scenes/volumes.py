"""Volumes within a mesh: homogeneous ones, and the mean of others."""

from features import feature
from stage import BALL_CENTRE, add, ball_mesh, dressed, lamp, new_tree, outdoors
from tools.meshes import cube_mesh
from tree import Tree, out


def filled(volume) -> None:
    """A ball of what `volume` gives, without a surface."""
    tree = new_tree()
    tree.set(tree.output, "Volume", volume(tree))
    outdoors()
    add(dressed(ball_mesh(), tree.datablock), BALL_CENTRE)


@feature(bounces=4)
def absorption():
    """A ball that absorbs"""
    inputs = {"Color": (0.8, 0.3, 0.2), "Density": 1.0}
    filled(lambda tree: tree.node("VolumeAbsorption", inputs))


@feature(bounces=4, samples=512)
def scatter():
    """A ball of smoke, alike everywhere"""
    inputs = {"Color": (0.7, 0.75, 0.8), "Density": 1.0, "Anisotropy": 0.3}
    filled(lambda tree: tree.node("VolumeScatter", inputs))


@feature(bounces=4)
def emission():
    """A ball of glowing gas"""
    filled(lambda tree: tree.node("Emission", {"Color": (0.9, 0.4, 0.1), "Strength": 0.6}))


@feature(bounces=4)
def absorbing_glass():
    """Glass whose colour comes from its inside"""
    tree = new_tree()
    tree.surface("BsdfGlass", {"Color": (1, 1, 1), "Roughness": 0.0, "IOR": 1.4})
    inputs = {"Color": (0.2, 0.7, 0.4), "Density": 1.5}
    tree.set(tree.output, "Volume", tree.node("VolumeAbsorption", inputs))
    outdoors()
    add(dressed(ball_mesh(), tree.datablock), BALL_CENTRE)


@feature(bounces=4, samples=512)
def heterogeneous():
    """Smoke that is denser in some places"""

    def volume(tree: Tree):
        noise = tree.node("TexNoise", {"Scale": 4.0})
        density = tree.math("MULTIPLY", out(noise, "Fac"), 3.0)
        return tree.node("VolumeScatter", {"Color": (0.8, 0.8, 0.8), "Density": density})

    filled(volume)


@feature(bounces=4, samples=512)
def principled():
    """A ball of smoke that glows by its heat"""
    inputs = {"Color": (0.3, 0.5, 0.8), "Density": 1.5, "Absorption Color": (0.6, 0.2, 0.1)}
    inputs |= {"Anisotropy": -0.3, "Blackbody Intensity": 0.3, "Temperature": 1800.0}
    filled(lambda tree: tree.node("VolumePrincipled", inputs))


@feature(bounces=4, samples=512, since=(4, 3))
def phase_functions():
    """Balls of droplets, of dust and of air under a lamp behind them"""
    outdoors()
    lamp("POINT", 300.0, (0.0, 3.0, 2.5), shadow_soft_size=0.1)
    for place, phase in enumerate(("MIE", "DRAINE", "RAYLEIGH")):
        tree = new_tree(phase)
        inputs = {"Color": (0.9, 0.9, 0.9), "Density": 1.5, "Anisotropy": 0.4, "Alpha": 5.0}
        node = tree.node("VolumeScatter", inputs | {"Diameter": 12.0}, phase=phase)
        tree.set(tree.output, "Volume", node)
        add(dressed(ball_mesh(0.5), tree.datablock), (1.05 * (place - 1), 0.0, 0.7))


@feature(bounces=4, samples=512, since=(4, 3))
def fournier_forand():
    """Balls of water with fine, with coarse and with dense particles, a lamp behind them"""
    outdoors()
    lamp("POINT", 300.0, (0.0, 3.0, 2.5), shadow_soft_size=0.1)
    waters = ({"IOR": 1.33, "Backscatter": 0.1}, {"IOR": 1.1, "Backscatter": 0.01})
    for place, water in enumerate((*waters, {"IOR": 1.9, "Backscatter": 0.35})):
        tree = new_tree("Water")
        inputs = {"Color": (0.8, 0.9, 0.95), "Density": 1.5, **water}
        node = tree.node("VolumeScatter", inputs, phase="FOURNIER_FORAND")
        tree.set(tree.output, "Volume", node)
        add(dressed(ball_mesh(0.5), tree.datablock), (1.05 * (place - 1), 0.0, 0.7))


@feature(bounces=4, samples=512)
def overlapping():
    """Two balls that overlap, one within tinted glass, and one without a surface"""
    outdoors()
    glass = new_tree("Glass")
    glass.surface("BsdfGlass", {"Color": (1, 1, 1), "Roughness": 0.2, "IOR": 1.3})
    inputs = {"Color": (0.3, 0.6, 0.8), "Density": 1.0}
    glass.set(glass.output, "Volume", glass.node("VolumeAbsorption", inputs))
    add(dressed(ball_mesh(0.7), glass.datablock), (-0.4, 0.0, 0.9))
    mist = new_tree("Mist")
    inputs = {"Color": (0.9, 0.7, 0.5), "Density": 1.5}
    mist.set(mist.output, "Volume", mist.node("VolumeScatter", inputs))
    add(dressed(ball_mesh(0.7), mist.datablock), (0.4, 0.0, 0.9))


@feature(bounces=4, samples=512)
def around_the_camera():
    """A room full of mist with the camera in it, and a lamp"""
    outdoors()
    lamp("POINT", 60.0, (0.6, -1.5, 1.6), shadow_soft_size=0.1)
    tree = new_tree("Mist")
    inputs = {"Color": (0.8, 0.85, 0.9), "Density": 0.12, "Anisotropy": 0.5}
    tree.set(tree.output, "Volume", tree.node("VolumeScatter", inputs))
    add(dressed(cube_mesh(11.0), tree.datablock), (0.0, 0.0, 1.0))
    add(dressed(ball_mesh()), BALL_CENTRE)
