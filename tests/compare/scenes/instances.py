"""Instances, by every way that Blender has."""

import bpy
import numpy as np
from features import feature
from scenes.geometry import geometry_nodes
from stage import BALL_CENTRE, add, ball_mesh, diffuse, dressed, outdoors, shows
from tools.meshes import cube_mesh
from tree import Tree, out

PAINT = (0.6, 0.45, 0.3)


@feature()
def by_geometry_nodes():
    """Instances of a cube on the points of a ball, by geometry nodes"""
    outdoors()
    cube = add(dressed(cube_mesh(0.16), diffuse(PAINT)), (0, 0, -5))
    shown = add(ball_mesh(0.7, 12, 8), (0, 0, 0.8))

    def build(tree, geometry):
        source = tree.nodes.new("GeometryNodeObjectInfo")
        source.inputs["Object"].default_value = cube
        scatter = tree.nodes.new("GeometryNodeInstanceOnPoints")
        tree.links.new(geometry, scatter.inputs["Points"])
        tree.links.new(source.outputs["Geometry"], scatter.inputs["Instance"])
        return scatter.outputs[0]

    geometry_nodes(shown, build)


def strewn(material: bpy.types.Material) -> None:
    """Cubes of that material where particles are born."""
    outdoors()
    cube = add(dressed(cube_mesh(1.0), material), (0, 0, -5))
    shown = add(dressed(ball_mesh(), diffuse((0.2, 0.3, 0.5))), BALL_CENTRE)
    shown.modifiers.new("Particles", "PARTICLE_SYSTEM")
    settings = shown.particle_systems[0].settings
    settings.type, settings.count, settings.hair_length = "HAIR", 40, 1.0
    settings.render_type, settings.instance_object = "OBJECT", cube
    settings.particle_size = 0.15


@feature()
def by_particles():
    """Cubes where particles are born"""
    strewn(diffuse(PAINT))


@feature()
def coordinates_of_instancer():
    """Cubes painted by where on the ball they were born"""

    def paint(tree: Tree):
        place = tree.node("TexCoord", from_instancer=True)
        uv = tree.vector_math("MULTIPLY", out(place, "UV"), (0.0, 0.8, 0.0))
        lifted = tree.vector_math("ADD", out(place, "Generated"), (0.5, 0.0, 0.5))
        return tree.vector_math("ADD", tree.vector_math("MULTIPLY", lifted, (0.9, 0.0, 0.9)), uv)

    strewn(shows(paint))


@feature()
def particle_info():
    """Cubes painted by which particle they are and where it was born"""

    def paint(tree: Tree):
        info = tree.node("ParticleInfo")
        random = tree.vector_math("MULTIPLY", out(info, "Random"), (0.6, 0.0, 0.2))
        index = tree.vector_math("MULTIPLY", out(info, "Index"), (0.0, 0.02, 0.0))
        place = tree.vector_math("MULTIPLY", out(info, "Location"), (0.0, 0.0, 0.4))
        return tree.vector_math("ADD", tree.vector_math("ADD", random, index), place)

    strewn(shows(paint))


@feature()
def of_collections():
    """A collection of two objects, instanced thrice"""
    outdoors()
    pair = bpy.data.collections.new("Pair")
    for data, place in ((cube_mesh(0.4), (0, 0, 0.2)), (ball_mesh(0.2), (0, 0, 0.6))):
        shown = bpy.data.objects.new("Part", dressed(data, diffuse(PAINT)))
        shown.location = place
        pair.objects.link(shown)
    for x in (-0.8, 0.0, 0.8):
        holder = add(None, (x, 0, 0))
        holder.instance_type, holder.instance_collection = "COLLECTION", pair
        holder.rotation_euler, holder.scale = (0, 0, x), (1, 1, 1.0 + 0.5 * x)


@feature()
def on_vertices():
    """An object on each vertex of its parent"""
    outdoors()
    places = bpy.data.meshes.new("Places")
    places.from_pydata([(x, y, 0.3) for x in (-0.7, 0, 0.7) for y in (-0.7, 0, 0.7)], [], [])
    parent = add(places)
    parent.instance_type = "VERTS"
    child = add(dressed(ball_mesh(0.25, 24, 12), diffuse(PAINT)))
    child.parent = parent


@feature()
def many():
    """Ten thousand balls of one mesh"""
    outdoors()
    mesh = dressed(ball_mesh(0.03, 12, 6), diffuse(PAINT))
    parent_mesh = bpy.data.meshes.new("Places")
    places = np.random.default_rng(4).uniform((-2, -2, 0.03), (2, 2, 1.5), (10_000, 3))
    parent_mesh.from_pydata(places.tolist(), [], [])
    parent = add(parent_mesh)
    parent.instance_type = "VERTS"
    add(mesh).parent = parent
