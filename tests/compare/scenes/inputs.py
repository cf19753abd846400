"""Nodes that read what is known at the hit."""

import math

import bpy
import numpy as np
from features import feature
from scenes.coordinates import reads
from stage import (
    BALL_CENTRE,
    GREY,
    add,
    ball_mesh,
    camera,
    diffuse,
    dressed,
    floor,
    grid_mesh,
    lamp,
    new_tree,
    outdoors,
    painted_ball,
    shows,
    wall,
    world,
)
from tools.meshes import cube_mesh
from tree import Tree, out


@feature()
def geometry_position():
    """Position in the world"""
    painted_ball(reads("NewGeometry", "Position"))


@feature()
def geometry_normal():
    """Normal, and the true normal of flat faces"""

    def paint(tree: Tree):
        node = tree.node("NewGeometry")
        both = tree.vector_math("ADD", out(node, "Normal"), out(node, "True Normal"))
        return tree.scaled(both, 0.25, 0.5)

    camera()
    world(GREY)
    add(dressed(ball_mesh(segments=16, rings=8), shows(paint)), BALL_CENTRE)


@feature()
def geometry_tangent():
    """Tangent about the object's Z"""
    painted_ball(reads("NewGeometry", "Tangent"))


@feature()
def geometry_incoming():
    """The direction to the viewer"""
    painted_ball(reads("NewGeometry", "Incoming"))


@feature()
def geometry_parametric():
    """Place within each triangle"""
    camera()
    world(GREY)
    paint = reads("NewGeometry", "Parametric", 1.0, 0.0)
    add(dressed(ball_mesh(segments=12, rings=6), shows(paint)), BALL_CENTRE)


def open_ball(material: bpy.types.Material) -> bpy.types.Object:
    """A bowl that shows its inside and its outside."""
    mesh = ball_mesh()
    kept = [p.index for p in mesh.polygons if p.center.z < 0.2]
    corners = [vertex.co[:] for vertex in mesh.vertices]
    bowl = bpy.data.meshes.new("Bowl")
    bowl.from_pydata(corners, [], [mesh.polygons[i].vertices[:] for i in kept])
    shown = add(dressed(bowl, material), (0, 0, 0.9))
    shown.rotation_euler = (0.5, 0, 0)
    return shown


@feature()
def geometry_backfacing():
    """Red outside, blue inside"""

    def paint(tree: Tree):
        inputs = {"Fac": out(tree.node("NewGeometry"), "Backfacing")}
        inputs |= {"Color1": (0.8, 0.1, 0.1), "Color2": (0.1, 0.2, 0.8)}
        return tree.node("MixRGB", inputs)

    camera()
    world(GREY)
    open_ball(shows(paint))


@feature()
def geometry_random_per_island():
    """A number for each island of a mesh"""
    wall(reads("NewGeometry", "Random Per Island", 1.0, 0.0)).data = dressed(
        grid_mesh(4, 4), shows(reads("NewGeometry", "Random Per Island", 1.0, 0.0))
    )


@feature()
def geometry_pointiness():
    """Pointiness of a bumpy ball"""

    def paint(tree: Tree):
        value = out(tree.node("NewGeometry"), "Pointiness")
        return tree.math("MULTIPLY_ADD", value, 6.0, -2.5)

    shown = painted_ball(paint)
    for vertex in shown.data.vertices:
        x, y, z = vertex.co
        vertex.co *= 1.0 + 0.06 * math.sin(9 * x) * math.sin(9 * y) * math.sin(9 * z)


def row_of_cubes(paint) -> list[bpy.types.Object]:
    camera()
    world(GREY)
    mesh = dressed(cube_mesh(0.7), shows(paint))
    return [add(mesh, (x, 0.0, 0.85), f"Cube {x}") for x in (-0.9, 0.0, 0.9)]


@feature()
def object_color():
    """The colour of each object"""
    for index, shown in enumerate(row_of_cubes(reads("ObjectInfo", "Color", 1.0, 0.0))):
        shown.color = (0.2 + 0.3 * index, 0.4, 0.9 - 0.4 * index, 1.0)


@feature()
def object_location():
    """The location of each object"""
    row_of_cubes(reads("ObjectInfo", "Location"))


@feature()
def object_index():
    """The index of each object, and the index of the material"""

    def paint(tree: Tree):
        node = tree.node("ObjectInfo")
        inputs = {"X": tree.math("MULTIPLY", out(node, "Object Index"), 0.2)}
        inputs["Y"] = tree.math("MULTIPLY", out(node, "Material Index"), 0.1)
        return tree.node("CombineXYZ", inputs)

    for index, shown in enumerate(row_of_cubes(paint)):
        shown.pass_index = index + 1
        shown.data.materials[0].pass_index = 4


@feature()
def object_random():
    """A random number for each object"""
    row_of_cubes(reads("ObjectInfo", "Random", 1.0, 0.0))


@feature(bounces=4)
def light_path():
    """Green to the camera, red in the light it throws on the floor"""

    def paint(tree: Tree):
        inputs = {"Fac": out(tree.node("LightPath"), "Is Camera Ray")}
        inputs |= {"Color1": (1.0, 0.1, 0.05), "Color2": (0.1, 0.7, 0.2)}
        return tree.node("MixRGB", inputs)

    camera()
    floor()
    world((0.05, 0.05, 0.05))
    add(dressed(ball_mesh(), shows(paint)), BALL_CENTRE)


@feature(bounces=4)
def light_path_shadow():
    """A ball that throws no shadow, by its shader"""
    tree = new_tree()
    mix = tree.node("MixShader", {"Fac": out(tree.node("LightPath"), "Is Shadow Ray")})
    tree.links.new(tree.node("BsdfDiffuse").outputs[0], mix.inputs[1])
    tree.links.new(tree.node("BsdfTransparent").outputs[0], mix.inputs[2])
    tree.set(tree.output, "Surface", mix)
    outdoors()
    add(dressed(ball_mesh(), tree.datablock), BALL_CENTRE)


@feature(bounces=4)
def light_path_length():
    """Colour by the length and the depth of the ray, seen directly and in a mirror"""

    def paint(tree: Tree):
        node = tree.node("LightPath")
        inputs = {"X": tree.math("MULTIPLY", out(node, "Ray Length"), 0.12)}
        inputs["Y"] = tree.math("MULTIPLY", out(node, "Ray Depth"), 0.6)
        inputs["Z"] = tree.math("MULTIPLY", out(node, "Is Glossy Ray"), 0.5)
        return tree.node("CombineXYZ", inputs)

    camera()
    world((0.1, 0.1, 0.1))
    tree = new_tree()
    tree.surface("BsdfAnisotropic", {"Color": (0.8, 0.8, 0.8), "Roughness": 0.0})
    add(dressed(ball_mesh(), tree.datablock), BALL_CENTRE)
    add(dressed(grid_mesh(1, 1, (8, 8)), shows(paint)))


@feature(bounces=4)
def light_path_length_of_clear_things():
    """Glass where the ray is long and clear where it is short, the way through what was clear
    counted, too"""
    tree = new_tree()
    length = tree.math("MULTIPLY", out(tree.node("LightPath"), "Ray Length"), 0.15)
    mix = tree.node("MixShader", {"Fac": length})
    tree.links.new(tree.node("BsdfTransparent").outputs[0], mix.inputs[1])
    tree.links.new(
        tree.node("BsdfAnisotropic", {"Color": (0.8, 0.3, 0.2)}).outputs[0], mix.inputs[2]
    )
    tree.set(tree.output, "Surface", mix)
    outdoors()
    add(dressed(ball_mesh(), tree.datablock), BALL_CENTRE)


@feature()
def layer_weight():
    """Layer Weight: Fresnel in red, facing in green"""

    def paint(tree: Tree):
        node = tree.node("LayerWeight", {"Blend": 0.4})
        inputs = {"X": out(node, "Fresnel"), "Y": out(node, "Facing")}
        return tree.node("CombineXYZ", inputs)

    painted_ball(paint)


@feature()
def fresnel():
    """Fresnel, IOR 1.8"""
    painted_ball(lambda tree: tree.node("Fresnel", {"IOR": 1.8}))


@feature()
def fresnel_inside():
    """Fresnel and Layer Weight on the back of a surface"""

    def paint(tree: Tree):
        inputs = {"X": tree.node("Fresnel", {"IOR": 1.3})}
        inputs["Y"] = out(tree.node("LayerWeight", {"Blend": 0.3}), "Fresnel")
        return tree.node("CombineXYZ", inputs)

    camera()
    world(GREY)
    open_ball(shows(paint))


@feature()
def camera_data():
    """Direction, depth and distance from the camera"""

    def paint(tree: Tree):
        node = tree.node("CameraData")
        inputs = {"X": tree.math("MULTIPLY", out(node, "View Z Depth"), 0.1)}
        inputs["Y"] = tree.math("MULTIPLY", out(node, "View Distance"), 0.15)
        sides = tree.node("SeparateXYZ", {"Vector": out(node, "View Vector")})
        inputs["Z"] = tree.math("MULTIPLY_ADD", out(sides, "X"), 1.5, 0.5)
        return tree.node("CombineXYZ", inputs)

    camera()
    world(GREY)
    add(dressed(grid_mesh(1, 1, (8, 8)), shows(paint)))


@feature()
def normal():
    """The Normal node's dot product"""

    def paint(tree: Tree):
        node = tree.node("Normal", {"Normal": out(tree.node("NewGeometry"), "Normal")})
        node.outputs[0].default_value = (0.3, -0.5, 0.8)
        return tree.math("MULTIPLY_ADD", out(node, "Dot"), 0.5, 0.5)

    painted_ball(paint)


@feature()
def tangent():
    """Tangents: about Z, about X, and of the UVs"""

    def paint(tree: Tree):
        return tree.scaled(tree.node("Tangent", direction_type="UV_MAP"), 0.5, 0.5)

    shown = painted_ball(paint)
    radial = shows(reads("Tangent", "Tangent", direction_type="RADIAL", axis="X"))
    shown.data.materials.append(radial)
    left = np.array([p.center.x < 0 for p in shown.data.polygons], np.int32)
    shown.data.polygons.foreach_set("material_index", left)


@feature()
def wireframe():
    """Wireframe, in metres"""
    camera()
    world(GREY)
    paint = reads("Wireframe", "Fac", 1.0, 0.0)

    def wider(tree: Tree):
        node = paint(tree).node
        tree.set(node.inputs[0].links[0].from_node, "Size", 0.04)
        return node

    add(dressed(ball_mesh(segments=12, rings=6), shows(wider)), BALL_CENTRE)


@feature()
def ambient_occlusion():
    """Ambient Occlusion under a cube"""

    def paint(tree: Tree):
        return out(tree.node("AmbientOcclusion", {"Distance": 1.0}, samples=16), "AO")

    camera()
    world(GREY)
    add(dressed(grid_mesh(1, 1, (8, 8)), shows(paint)))
    add(dressed(cube_mesh(1.0), diffuse()), (0, 0, 0.7))


@feature()
def ambient_occlusion_of_the_world():
    """Ambient Occlusion without a distance under a cube: as far as the world's"""

    def paint(tree: Tree):
        return out(tree.node("AmbientOcclusion", {"Distance": 0.0}, samples=16), "AO")

    camera()
    world(GREY).datablock.light_settings.distance = 0.6
    add(dressed(grid_mesh(1, 1, (8, 8)), shows(paint)))
    add(dressed(cube_mesh(1.0), diffuse()), (0, 0, 0.7))


@feature()
def ambient_occlusion_inside():
    """Ambient Occlusion of the inside, of the object alone: a flattened ball"""

    def paint(tree: Tree):
        inputs = {"Distance": 0.8, "Color": (1.0, 0.7, 0.3)}
        node = tree.node("AmbientOcclusion", inputs, samples=16, inside=True, only_local=True)
        return out(node, "Color")

    camera()
    world(GREY)
    shown = add(dressed(ball_mesh(), shows(paint)), BALL_CENTRE)
    shown.scale = (1.0, 1.0, 0.4)


@feature()
def light_falloff():
    """Light Falloff: a point lamp that does not weaken"""
    camera()
    floor()
    world((0.05, 0.05, 0.05))
    shown = lamp("POINT", 20.0, (-0.8, 0.0, 1.0))
    shown.data.use_nodes = True
    tree = Tree(shown.data)
    falloff = tree.node("LightFalloff", {"Strength": 4.0, "Smooth": 0.2})
    tree.surface("Emission", {"Strength": out(falloff, "Constant")})
