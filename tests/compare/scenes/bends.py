"""What bends the normal: normal maps, bumps, bevels and displacement."""

import bpy
import numpy as np
from features import feature
from stage import (
    BALL_CENTRE,
    BALL_RADIUS,
    add,
    at,
    ball,
    ball_mesh,
    diffuse,
    dressed,
    new_tree,
    outdoors,
)
from tools.meshes import cube_mesh
from tree import Tree, out

PAINT = (0.6, 0.6, 0.5)


def bumped_ball(bend) -> bpy.types.Object:
    """A diffuse ball with the normal that `bend` gives."""
    tree = new_tree()
    tree.surface("BsdfDiffuse", {"Color": PAINT, "Roughness": 0.0, "Normal": bend(tree)})
    return ball(tree.datablock)


def bumps(tree: Tree, scale: float = 5.0):
    inputs = {"Vector": out(tree.node("TexCoord"), "Object"), "Scale": scale, "Detail": 0.0}
    return out(tree.node("TexNoise", inputs), "Fac")


@feature()
def bump():
    """Bump by noise"""
    bumped_ball(lambda t: t.node("Bump", {"Height": bumps(t), "Strength": 0.8, "Distance": 0.3}))


@feature()
def bump_inverted():
    """Bump inwards, on glossy"""
    tree = new_tree()
    node = tree.node("Bump", {"Height": bumps(tree), "Strength": 0.5, "Distance": 0.2})
    node.invert = True
    tree.surface("BsdfAnisotropic", {"Color": PAINT, "Roughness": 0.5, "Normal": node})
    ball(tree.datablock)


@feature()
def bump_on_bump():
    """A bump on the normal of another"""

    def bend(tree: Tree):
        coarse = tree.node("Bump", {"Height": bumps(tree, 3.0), "Distance": 0.3})
        fine = {"Height": bumps(tree, 14.0), "Distance": 0.06, "Normal": coarse}
        return tree.node("Bump", fine)

    bumped_ball(bend)


@feature()
def displacement_bump():
    """Displacement as a bump"""
    tree = new_tree()
    tree.surface("BsdfDiffuse", {"Color": PAINT, "Roughness": 0.0})
    inputs = {"Height": bumps(tree), "Midlevel": 0.5, "Scale": 0.3}
    tree.set(tree.output, "Displacement", tree.node("Displacement", inputs))
    ball(tree.datablock)


def slanted_picture() -> bpy.types.Image:
    """A normal map of 8 x 8 cells, each slanted another way."""
    slopes = np.random.default_rng(3).uniform(-0.6, 0.6, (8, 8, 2))
    normals = np.dstack([slopes, np.ones((8, 8))])
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    pixels = np.ones((8, 8, 4), np.float32)
    pixels[..., :3] = normals * 0.5 + 0.5
    image = bpy.data.images.new("Normals", 8, 8, float_buffer=True)
    image.colorspace_settings.name = "Non-Color"
    image.pixels.foreach_set(pixels.ravel())
    image.pack()
    return image


def normal_map(space: str, strength: float = 1.0):
    def bend(tree: Tree):
        picture = tree.node("TexImage", interpolation="Closest")
        picture.image = slanted_picture()
        inputs = {"Color": out(picture, "Color"), "Strength": strength}
        return tree.node("NormalMap", inputs, space=space)

    return bend


@feature()
def normal_map_tangent():
    """A normal map in tangent space"""
    bumped_ball(normal_map("TANGENT", 0.8))


@feature()
def normal_map_object():
    """A normal map in the space of an object that is turned"""
    bumped_ball(normal_map("OBJECT")).rotation_euler = (0.9, 0.2, 0.4)


@feature()
def normal_map_world():
    """A normal map in world space"""
    bumped_ball(normal_map("WORLD"))


def mirrored_ball(material: bpy.types.Material) -> None:
    """A ball of few smooth faces, whose UV map is mirrored at its middle and broken at a seam."""
    outdoors()
    mesh = dressed(ball_mesh(segments=14, rings=7), material)
    layer = mesh.uv_layers[0].data
    uvs = np.empty((len(layer), 2), np.float32)
    layer.foreach_get("uv", uvs.ravel())
    uvs[:, 0] = np.abs(2.0 * uvs[:, 0] - 1.0)
    sides = [face.loop_total for face in mesh.polygons]
    is_above = [uvs[list(face.loop_indices), 1].min() > 0.5 for face in mesh.polygons]
    turned = np.repeat(is_above, sides)  # lie sideways in the picture
    uvs[turned] = uvs[turned][:, ::-1]
    layer.foreach_set("uv", uvs.ravel())
    add(mesh, BALL_CENTRE).rotation_euler = (0.3, 0, 0.4)


@feature()
def normal_map_mirrored():
    """A normal map in tangent space, on few faces, across a seam and a mirror"""
    tree = new_tree()
    bend = normal_map("TANGENT")(tree)
    tree.surface("BsdfDiffuse", {"Color": PAINT, "Roughness": 0.0, "Normal": bend})
    mirrored_ball(tree.datablock)


@feature()
def normal_map_on_hexagons():
    """A normal map in tangent space, on faces of six sides"""
    tree = new_tree()
    bend = normal_map("TANGENT")(tree)
    tree.surface("BsdfDiffuse", {"Color": PAINT, "Roughness": 0.0, "Normal": bend})
    outdoors()
    coarse = ball_mesh(segments=14, rings=7)
    # Both halves of each pair of neighbouring quads in a ring.
    faces = [list(face.vertices) for face in coarse.polygons]
    uvs = [[tuple(coarse.uv_layers[0].data[i].uv) for i in face.loop_indices]
           for face in coarse.polygons]  # fmt: skip
    joined, joined_uvs = [], []
    for i in range(0, len(faces), 2):
        for kept, both in ((joined, faces), (joined_uvs, uvs)):
            first, second = both[i], both[i + 1]
            is_quad = len(faces[i]) == 4
            pair = [*first[:2], *second[1:3], *first[2:]] if is_quad else None
            kept += [pair] if pair else [first, second]
    mesh = bpy.data.meshes.new("Hexagons")
    mesh.from_pydata([vertex.co for vertex in coarse.vertices], [], joined)
    flat = np.array([uv for face in joined_uvs for uv in face], np.float32)
    mesh.uv_layers.new(name="UVMap").data.foreach_set("uv", flat.ravel())
    mesh.polygons.foreach_set("use_smooth", np.ones(len(joined), bool))
    add(dressed(mesh, tree.datablock), BALL_CENTRE)


@feature()
def tangent_mirrored():
    """The tangent of a UV map, on few faces, across a seam and a mirror"""
    tree = new_tree()
    tangent = tree.node("Tangent", direction_type="UV_MAP")
    inputs = {"Color": PAINT, "Roughness": 0.3, "Anisotropy": 0.7, "Tangent": tangent}
    tree.surface("BsdfAnisotropic", inputs)
    mirrored_ball(tree.datablock)


@feature(samples=512)
def bevel():
    """Bevel as the normal of a cube's rounded edges"""
    tree = new_tree()
    node = tree.node("Bevel", {"Radius": 0.15}, samples=8)
    tree.surface("BsdfAnisotropic", {"Color": PAINT, "Roughness": 0.5, "Normal": node})
    outdoors()
    shown = add(dressed(cube_mesh(1.2), tree.datablock), (0, 0, 0.6))
    shown.rotation_euler = (0, 0, 0.7)


@feature(differs="a face that smooth normals turn away from the sun is lit otherwise at its end")
def custom_normals():
    """Split normals that the mesh brings along"""
    outdoors()
    mesh = dressed(cube_mesh(1.2), diffuse(PAINT))
    mesh.polygons.foreach_set("use_smooth", np.ones(6, bool))
    if hasattr(mesh, "use_auto_smooth"):
        mesh.use_auto_smooth = True
    corners = np.array([mesh.vertices[loop.vertex_index].co for loop in mesh.loops])
    mesh.normals_split_custom_set(corners / np.linalg.norm(corners, axis=1, keepdims=True))
    add(mesh, (0, 0, 0.6)).rotation_euler = (0, 0, 0.7)


@feature()
def flat_shading():
    """A ball of few flat faces"""
    outdoors()
    mesh = dressed(ball_mesh(segments=16, rings=8), diffuse(PAINT))
    mesh.polygons.foreach_set("use_smooth", np.zeros(len(mesh.polygons), bool))
    add(mesh, BALL_CENTRE)


def few_faces(geometry_offset: float) -> None:
    """A ball of few smooth faces, with what its object says of where light turns the corner."""
    outdoors()
    shown = add(dressed(ball_mesh(segments=16, rings=8), diffuse(PAINT)), BALL_CENTRE)
    has_own = hasattr(shown, "shadow_terminator_geometry_offset")  # from Blender 4.4
    (shown if has_own else shown.cycles).shadow_terminator_geometry_offset = geometry_offset


@feature()
def terminator_as_it_is():
    """A ball of few smooth faces, whose edges throw shadows where light turns the corner"""
    few_faces(0.0)


@feature()
def terminator_of_geometry():
    """A ball of few smooth faces, whose shadow rays start from the round surface"""
    few_faces(0.5)


@feature()
def coarse_smooth():
    """A ball of few smooth faces, where light turns the corner"""
    outdoors()
    add(dressed(ball_mesh(segments=16, rings=8), diffuse(PAINT)), BALL_CENTRE)


@feature()
def bump_of_a_scaled_object():
    """The bump of an object that is half as wide as high"""
    shown = bumped_ball(lambda tree: tree.node("Bump", {"Height": bumps(tree), "Distance": 0.3}))
    shown.matrix_world = at((0, 0, BALL_RADIUS)) @ shown.matrix_world.Diagonal((0.5, 0.7, 1, 1))
