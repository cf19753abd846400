"""What the filter of a view layer leaves out."""

import bpy
from features import feature
from scenes.geometry import strands
from stage import add, ball, ball_mesh, diffuse, dressed, glow, lamp

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
