"""Kinds of geometry, all in grey on the floor in sun and sky."""

import math

import bpy
import numpy as np
from features import feature
from mathutils import Matrix
from stage import (
    BALL_CENTRE,
    add,
    at,
    ball,
    ball_mesh,
    camera,
    diffuse,
    dressed,
    floor,
    grid_mesh,
    outdoors,
    shader,
    world,
)
from tools.meshes import cube_mesh

PAINT = (0.6, 0.45, 0.3)


def stand(data: bpy.types.ID, location=(0, 0, 0.6)) -> bpy.types.Object:
    """The object of that data, painted, outdoors."""
    outdoors()
    if hasattr(data, "materials"):
        dressed(data, diffuse(PAINT))
    return add(data, location)


@feature()
def subdivision():
    """A cube that a modifier subdivides"""
    shown = stand(cube_mesh(1.4), (0, 0, 0.7))
    shown.modifiers.new("Subdivision", "SUBSURF").render_levels = 3
    shown.data.polygons.foreach_set("use_smooth", np.ones(6, bool))


@feature()
def modifiers():
    """A solidified, arrayed, bevelled plate"""
    shown = stand(grid_mesh(1, 1, (0.5, 1.0)), (-0.9, 0, 0.3))
    shown.modifiers.new("Solid", "SOLIDIFY").thickness = 0.2
    shown.modifiers.new("Bevel", "BEVEL").width = 0.05
    array = shown.modifiers.new("Array", "ARRAY")
    array.count, array.relative_offset_displace = 3, (1.4, 0, 0.3)


@feature()
def material_slots():
    """Faces of four materials, one slot of the object's own"""
    outdoors()
    colors = ((0.8, 0.1, 0.1), (0.1, 0.7, 0.1), (0.1, 0.2, 0.8), (0.7, 0.7, 0.1))
    mesh = dressed(ball_mesh(), *map(diffuse, colors))
    slots = np.arange(len(mesh.polygons)) // 8 % 4
    mesh.polygons.foreach_set("material_index", slots.astype(np.int32))
    shown = add(mesh, BALL_CENTRE)
    shown.material_slots[3].link = "OBJECT"
    shown.material_slots[3].material = diffuse((0.9, 0.9, 0.9))


def ring_curve(kind: str = "BEZIER") -> bpy.types.Curve:
    curve = bpy.data.curves.new("Ring", "CURVE")
    curve.dimensions = "3D"
    spline = curve.splines.new(kind)
    points = [(0.8, 0, 0), (0, 0.8, 0.3), (-0.8, 0, 0), (0, -0.8, 0.3)]
    if kind == "BEZIER":
        spline.bezier_points.add(3)
        for point, place in zip(spline.bezier_points, points, strict=True):
            point.co = place
            point.handle_left_type = point.handle_right_type = "AUTO"
    else:
        spline.points.add(3)
        for point, place in zip(spline.points, points, strict=True):
            point.co = (*place, 1.0)
    spline.use_cyclic_u = True
    return curve


@feature()
def curve_bevel():
    """A Bezier curve with thickness"""
    curve = ring_curve()
    curve.bevel_depth, curve.bevel_resolution = 0.15, 4
    stand(curve)


@feature()
def curve_extruded():
    """An extruded, filled NURBS curve"""
    curve = ring_curve("NURBS")
    curve.extrude, curve.bevel_depth = 0.2, 0.05
    stand(curve).rotation_euler = (0.5, 0, 0)


@feature()
def text():
    """Text with depth"""
    font = bpy.data.curves.new("Text", "FONT")
    font.body, font.size, font.align_x = "Eye", 1.3, "CENTER"
    font.extrude, font.bevel_depth = 0.1, 0.02
    stand(font, (0, 0, 0.3)).rotation_euler = (math.radians(75), 0, 0)


@feature()
def metaballs():
    """Three metaballs that melt into one"""
    meta = bpy.data.metaballs.new("Meta")
    meta.render_resolution = 0.08
    for place in ((-0.6, 0, 0), (0.5, 0, 0), (0.0, 0.0, 0.6)):
        element = meta.elements.new()
        element.co, element.radius = place, 0.8
    stand(meta)


@feature()
def nurbs_surface():
    """A NURBS surface"""
    outdoors()
    bpy.ops.surface.primitive_nurbs_surface_torus_add(radius=0.5, location=(0, 0, 0.6))
    shown = bpy.context.active_object
    shown.scale = (0.7, 0.7, 0.7)
    dressed(shown.data, diffuse(PAINT))


def geometry_nodes(shown: bpy.types.Object, build) -> None:
    """A modifier whose tree `build(tree, geometry socket)` gives the geometry's output."""
    tree = bpy.data.node_groups.new("Geometry", "GeometryNodeTree")
    if hasattr(tree, "interface"):
        for direction in ("INPUT", "OUTPUT"):
            tree.interface.new_socket("Geometry", in_out=direction,
                                      socket_type="NodeSocketGeometry")  # fmt: skip
    else:
        tree.inputs.new("NodeSocketGeometry", "Geometry")
        tree.outputs.new("NodeSocketGeometry", "Geometry")
    enter, leave = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    tree.links.new(build(tree, enter.outputs[0]), leave.inputs[0])
    shown.modifiers.new("Nodes", "NODES").node_group = tree


def strands(shape: str, **settings) -> None:
    """A ball with hair of particles."""
    shown = ball(diffuse((0.3, 0.15, 0.1)))
    shown.scale = (0.6, 0.6, 0.6)
    shown.modifiers.new("Hair", "PARTICLE_SYSTEM")
    hair = shown.particle_systems[0].settings
    hair.type, hair.count, hair.hair_length, hair.hair_step = "HAIR", 150, 1.2, 4
    hair.root_radius, hair.tip_radius, hair.radius_scale = 1.0, 0.3, 0.05
    for name, value in settings.items():
        setattr(hair, name, value)
    bpy.context.scene.cycles_curves.shape = shape


@feature(samples=512)
def hair_thick():
    """Hair of particles as round curves"""
    strands("THICK")


@feature(samples=512)
def hair_ribbons():
    """Hair of particles as flat ribbons"""
    strands("RIBBONS")


@feature(samples=512)
def hair_children():
    """Hair with children between the strands"""
    strands("THICK", child_type="INTERPOLATED", rendered_child_count=4, radius_scale=0.03)


def set_material(tree, geometry, material):
    node = tree.nodes.new("GeometryNodeSetMaterial")
    node.inputs["Material"].default_value = material
    tree.links.new(geometry, node.inputs["Geometry"])
    return node.outputs[0]


@feature(samples=512)
def hair_curves():
    """Curves that geometry nodes make, with radii"""
    outdoors()
    shown = add(bpy.data.hair_curves.new("Curves"), (0, 0, 0.7))
    material = diffuse(PAINT)

    def build(tree, _geometry):
        sphere = tree.nodes.new("GeometryNodeMeshUVSphere")
        sphere.inputs["Segments"].default_value, sphere.inputs["Rings"].default_value = 12, 6
        sphere.inputs["Radius"].default_value = 0.6
        curves = tree.nodes.new("GeometryNodeMeshToCurve")
        radius = tree.nodes.new("GeometryNodeSetCurveRadius")
        radius.inputs["Radius"].default_value = 0.03
        tree.links.new(sphere.outputs[0], curves.inputs[0])
        tree.links.new(curves.outputs[0], radius.inputs[0])
        return set_material(tree, radius.outputs[0], material)

    geometry_nodes(shown, build)


@feature()
def point_cloud():
    """Points that geometry nodes make, with radii"""
    outdoors()
    shown = add(ball_mesh(0.7, 12, 8), (0, 0, 0.8))
    material = diffuse(PAINT)

    def build(tree, geometry):
        points = tree.nodes.new("GeometryNodeMeshToPoints")
        points.inputs["Radius"].default_value = 0.12
        tree.links.new(geometry, points.inputs[0])
        return set_material(tree, points.outputs[0], material)

    geometry_nodes(shown, build)


@feature()
def mirrored():
    """A mirrored, unevenly scaled, turned object with smooth normals"""
    shown = ball(diffuse(PAINT))
    turn = Matrix.Rotation(0.6, 4, (0.3, 1, 0.2))
    shown.matrix_world = at((0, 0, 0.9)) @ turn @ Matrix.Diagonal((-1.0, 0.5, 0.8, 1))


@feature()
def sheared():
    """An object sheared by its parent"""
    shown = ball(diffuse(PAINT))
    parent = add(None)
    parent.scale = (1.2, 1.0, 0.5)
    shown.parent, shown.location = parent, (0, 0, 1.6)
    shown.rotation_euler, shown.scale = (0.0, 0.8, 0.0), (0.5, 0.9, 1.2)


@feature()
def single_sided_sheet():
    """A sheet that is seen from its back, lit from its front"""
    shown = stand(grid_mesh(1, 1, (1.6, 1.6)), (0, 0, 0.9))
    shown.rotation_euler = (math.radians(-100), 0, 0.4)


@feature()
def clip_planes():
    """A camera whose near plane cuts the ball, and whose far plane the floor"""
    ball(diffuse(PAINT))
    data = bpy.context.scene.camera.data
    data.clip_start, data.clip_end = 4.6, 7.0


@feature()
def camera_shift():
    """Lens shift, a vertical sensor and pixels that are not square"""
    ball(diffuse(PAINT))
    data = bpy.context.scene.camera.data
    data.shift_x, data.shift_y, data.sensor_fit = 0.15, -0.1, "VERTICAL"
    bpy.context.scene.render.pixel_aspect_x = 1.5


@feature(refused="an eye needs a perspective camera")
def orthographic():
    """An orthographic camera"""
    ball(diffuse(PAINT))
    data = bpy.context.scene.camera.data
    data.type, data.ortho_scale = "ORTHO", 2.6


@feature()
def far_from_origin():
    """Everything a hundred kilometres from the origin"""
    ball(diffuse(PAINT))
    for shown in bpy.context.scene.objects:
        shown.location.x += 100_000.0


@feature()
def hidden_in_render():
    """A ball that is hidden in renders, one that is only a shadow, one without a shadow"""
    outdoors()
    places = ((-0.9, 0, 0.35), (0, 0, 0.35), (0.9, 0, 0.35))
    hidden, shadow, bright = (add(dressed(ball_mesh(0.35), diffuse(PAINT)), p) for p in places)
    hidden.hide_render = True
    shadow.visible_camera = False
    bright.visible_shadow = False


@feature()
def hidden_from_glossy():
    """A ball that a mirror does not show, one that does not light the floor"""
    camera()
    floor()
    world()
    mirror = shader("BsdfAnisotropic", {"Color": (0.9, 0.9, 0.9), "Roughness": 0.0})
    wall_ = add(dressed(grid_mesh(1, 1, (4, 3)), mirror), (0, 1.2, 1.0))
    wall_.rotation_euler = (math.radians(90), 0, 0)
    add(dressed(ball_mesh(0.35), diffuse((0.8, 0.1, 0.1))), (-0.5, 0, 0.35)).visible_glossy = False
    add(dressed(ball_mesh(0.35), diffuse((0.1, 0.2, 0.8))), (0.5, 0, 0.35)).visible_diffuse = False


@feature(view="OVER_MAGENTA")
def holdout_object():
    """An object that is a hole"""
    ball(diffuse(PAINT)).is_holdout = True


@feature(view="OVER_MAGENTA", samples=512)
def shadow_catcher():
    """A floor that is only what falls on it"""
    ball(diffuse(PAINT))
    bpy.context.scene.render.film_transparent = True
    bpy.data.objects["Floor"].is_shadow_catcher = True


@feature(bounces=4)
def sheets():
    """Seven sheets, each nearly clear"""
    outdoors()
    tree = shader("BsdfPrincipled", {"Base Color": PAINT, "Alpha": 0.06, "Roughness": 1.0})
    for index in range(7):
        sheet = add(dressed(grid_mesh(1, 1, (1.6, 1.6)), tree), (0, -0.5 + 0.15 * index, 0.9))
        sheet.rotation_euler = (math.radians(90), 0, 0.1)
