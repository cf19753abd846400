"""Light that is scattered below surfaces, beyond the plain cases of the shaders."""

import math

from features import feature
from stage import add, ball, ball_of, camera, dressed, floor, lamp, new_tree, shader, world
from tools.meshes import cube_mesh
from tree import SKIN, WALK

GREEN = {"Color": (0.7, 0.8, 0.5), "Radius": (1.0, 0.6, 0.3)}


@feature(bounces=4, samples=512)
def skin():
    """Below skin, whose radius is another length"""
    ball_of("SubsurfaceScattering", GREEN | {"Scale": 0.1, "IOR": 1.6}, falloff=SKIN)


@feature(bounces=4, samples=1024)
def anisotropic():
    """Scattered mostly ahead"""
    ball_of("SubsurfaceScattering", GREEN | {"Scale": 1.5, "Anisotropy": 0.8}, falloff=WALK)


@feature(bounces=4, samples=512)
def textured():
    """Checkered colour and radius, waves for a bump"""
    tree = new_tree()
    shown = tree.surface("SubsurfaceScattering", {"Scale": 1.0}, falloff=WALK)
    colors = {"Color1": (0.9, 0.3, 0.2), "Color2": (0.3, 0.8, 0.4), "Scale": 4.0}
    lengths = {"Color1": (0.6, 0.3, 0.3), "Color2": (0.02, 0.05, 0.2), "Scale": 4.0}
    tree.set(shown, "Color", tree.node("TexChecker", colors))
    tree.set(shown, "Radius", tree.node("TexChecker", lengths))
    waves = tree.node("TexWave", {"Scale": 2.0})
    tree.set(shown, "Normal", tree.node("Bump", {"Height": waves, "Distance": 0.1}))
    ball(tree.datablock)


@feature(bounces=4, samples=512)
def thin():
    """A slab lit from behind"""
    camera()
    floor()
    world((0.05, 0.05, 0.05))
    lamp("POINT", 200.0, location=(0.3, 1.5, 1.0), shadow_soft_size=0.1)
    inputs = {"Color": (0.8, 0.6, 0.4), "Scale": 1.0, "Radius": (1.0, 0.5, 0.25)}
    material = shader("SubsurfaceScattering", inputs, falloff=WALK)
    slab = add(dressed(cube_mesh(1.0), material), (0, 0, 0.75), "Slab")
    slab.scale = (1.6, 0.1, 1.4)
    slab.rotation_euler.z = math.radians(20)
