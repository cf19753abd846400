"""Volumes within a mesh: homogeneous ones are to be shown, others at least named."""

from features import feature
from stage import BALL_CENTRE, add, ball_mesh, dressed, new_tree, outdoors
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


@feature(bounces=4, samples=512, threshold=1.0, differs="a heterogeneous volume is only named")
def heterogeneous():
    """Smoke that is denser in some places"""

    def volume(tree: Tree):
        noise = tree.node("TexNoise", {"Scale": 4.0})
        density = tree.math("MULTIPLY", out(noise, "Fac"), 3.0)
        return tree.node("VolumeScatter", {"Color": (0.8, 0.8, 0.8), "Density": density})

    filled(volume)
