"""What a view layer leaves out, by its filter and its collections."""

import bpy
from features import feature
from scenes.geometry import strands
from stage import add, ball, ball_mesh, diffuse, dressed, glow, lamp, outdoors, shader
from tools.meshes import cube_mesh

PAINT = (0.6, 0.45, 0.3)


@feature()
def without_sky():
    """No sky, neither to be seen nor to shine"""
    ball(diffuse(PAINT))
    bpy.context.view_layer.use_sky = False


@feature(view="OVER_MAGENTA")
def without_surfaces():
    """Hair without the ball that it grows on, without the floor and what shines on it"""
    strands("THICK")
    add(dressed(ball_mesh(0.3), glow((1.0, 0.8, 0.6), 9.0)), (-1.2, -1.2, 1.6))
    lamp("POINT", 100.0, (1.2, -1.6, 2.6), shadow_soft_size=0.2)
    bpy.context.view_layer.use_solid = False


@feature()
def without_strands():
    """A ball without the hair that grows on it"""
    strands("THICK")
    bpy.context.view_layer.use_strand = False


def in_collection(name: str, data: bpy.types.ID, location) -> bpy.types.LayerCollection:
    collection = bpy.data.collections.new(name)
    bpy.context.scene.collection.children.link(collection)
    shown = bpy.data.objects.new(name, data)
    shown.location = location
    collection.objects.link(shown)
    return bpy.context.view_layer.layer_collection.children[name]


@feature()
def kinds_of_collections():
    """Beside a mirror a collection that is left out, one cut out and one seen only in the mirror,
    which stands on the floor with its lowest face in it"""
    outdoors()
    add(dressed(ball_mesh(0.6), shader("BsdfAnisotropic", {"Roughness": 0.0})), (0.2, 0.9, 0.7))
    in_collection("Left out", dressed(cube_mesh(0.6), diffuse(PAINT)), (-1, 1, 0.3)).exclude = True
    in_collection(
        "Cut out", dressed(ball_mesh(0.3), diffuse(PAINT)), (-0.5, 0, 0.4)
    ).holdout = True
    seen_in_mirror = in_collection(
        "Standing", dressed(cube_mesh(0.7), diffuse(PAINT)), (0.8, 0, 0.35)
    )
    seen_in_mirror.indirect_only = True
