"""What the feature scenes share: a camera, a ball on a tiled floor in sun and sky, walls that show
a colour, lamps and meshes. Units are metres and watts."""

import math
from collections.abc import Callable

import bpy
import numpy as np
from mathutils import Matrix, Vector
from tree import Tree

GREY = (0.5, 0.5, 0.5)
SKY = (0.35, 0.4, 0.5)
DIM = (0.05, 0.06, 0.08)  # sky of a night
BALL_RADIUS = 0.9
BALL_CENTRE = (0.0, 0.0, BALL_RADIUS)


def add(data: bpy.types.ID | None, location=(0, 0, 0), name: str = "Object") -> bpy.types.Object:
    shown = bpy.data.objects.new(name, data)
    shown.location = location
    bpy.context.scene.collection.objects.link(shown)
    return shown


def aim(shown: bpy.types.Object, target) -> None:
    """Turn the object's -Z to the target."""
    direction = Vector(target) - shown.location
    shown.rotation_euler = direction.to_track_quat("-Z", "Y").to_euler()


def camera(location=(0.0, -5.0, 2.0), target=(0.0, 0.0, 0.85), angle_deg=28.0) -> bpy.types.Object:
    data = bpy.data.cameras.new("Camera")
    data.angle = math.radians(angle_deg)
    shown = add(data, location, "Camera")
    aim(shown, target)
    bpy.context.scene.camera = shown
    return shown


# --- materials -----------------------------------------------------------------------------


def new_tree(name: str = "Material") -> Tree:
    return Tree(bpy.data.materials.new(name))


def diffuse(color=GREY) -> bpy.types.Material:
    tree = new_tree("Diffuse")
    tree.surface("BsdfDiffuse", {"Color": color, "Roughness": 0.0})
    return tree.datablock


def shader(kind: str, inputs: dict | None = None, **properties) -> bpy.types.Material:
    """A material of one shader node."""
    tree = new_tree(kind)
    tree.surface(kind, inputs, **properties)
    return tree.datablock


def glow(color, strength: float = 1.0) -> bpy.types.Material:
    return shader("Emission", {"Color": color, "Strength": strength})


def shows(paint: Callable[[Tree], object]) -> bpy.types.Material:
    """A material that shines with the colour, value or vector whose socket `paint` gives."""
    tree = new_tree("Shows")
    tree.surface("Emission", {"Color": paint(tree)})
    return tree.datablock


# --- meshes --------------------------------------------------------------------------------


def grid_mesh(columns: int, rows: int, size=(2.0, 2.0), name: str = "Grid") -> bpy.types.Mesh:
    """Separate rectangles in the XY plane, normal +Z, each with UVs from 0 to 1, row by row from
    the bottom."""
    x = np.linspace(-size[0] / 2, size[0] / 2, columns + 1)
    y = np.linspace(-size[1] / 2, size[1] / 2, rows + 1)
    corners, faces = [], []
    for j in range(rows):
        for i in range(columns):
            first = len(corners)
            corners += [(x[i], y[j], 0), (x[i + 1], y[j], 0)]
            corners += [(x[i + 1], y[j + 1], 0), (x[i], y[j + 1], 0)]
            faces.append(tuple(range(first, first + 4)))
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], faces)
    uvs = [(0, 0), (1, 0), (1, 1), (0, 1)] * len(faces)
    mesh.uv_layers.new(name="UVMap").data.foreach_set("uv", np.array(uvs, np.float32).ravel())
    return mesh


def ball_mesh(radius: float = BALL_RADIUS, segments: int = 64, rings: int = 32) -> bpy.types.Mesh:
    """A smooth sphere of quads, with UVs as on a globe."""
    corners, uvs, faces = [], [], []
    for ring in range(rings + 1):
        polar = math.pi * ring / rings
        for segment in range(segments + 1):
            around = 2 * math.pi * segment / segments
            corners.append(
                (
                    radius * math.sin(polar) * math.cos(around),
                    radius * math.sin(polar) * math.sin(around),
                    -radius * math.cos(polar),
                )
            )
    uv_of = [(s / segments, r / rings) for r in range(rings + 1) for s in range(segments + 1)]
    # The seam and the poles share their vertices, or normals would not be smooth there.
    stride = segments + 1

    def shared(ring: int, segment: int) -> int:
        return ring * stride + (0 if ring in (0, rings) else segment % segments)

    for ring in range(rings):
        for segment in range(segments):
            places = [(ring, segment), (ring, segment + 1)]
            places += [(ring + 1, segment + 1), (ring + 1, segment)]
            if ring == 0:
                places = [places[0], *places[2:]]
            elif ring == rings - 1:
                places = places[:3]
            faces.append([shared(*place) for place in places])
            uvs += [uv_of[r * stride + s] for r, s in places]
    used = sorted({vertex for face in faces for vertex in face})
    number = {vertex: index for index, vertex in enumerate(used)}
    mesh = bpy.data.meshes.new("Ball")
    mesh.from_pydata([corners[v] for v in used], [], [[number[v] for v in face] for face in faces])
    mesh.uv_layers.new(name="UVMap").data.foreach_set("uv", np.array(uvs, np.float32).ravel())
    mesh.polygons.foreach_set("use_smooth", np.ones(len(faces), bool))
    return mesh


def dressed(mesh: bpy.types.ID, *materials: bpy.types.Material) -> bpy.types.ID:
    for material in materials:
        mesh.materials.append(material)
    return mesh


# --- light ---------------------------------------------------------------------------------


def world(color=SKY, strength: float = 1.0) -> Tree:
    """A world of one colour; gives its tree."""
    data = bpy.data.worlds.new("World")
    # Cycles' own choice takes seconds a render.
    data.cycles.sampling_method, data.cycles.sample_map_resolution = "MANUAL", 512
    bpy.context.scene.world = data
    tree = Tree(data)
    tree.surface("Background", {"Color": color, "Strength": strength})
    return tree


def lamp(kind: str, energy: float, location=(-2.0, -2.0, 4.0), target=(0, 0, 0.5), **settings):
    """A lamp that shines at the target. Watts are those of Blender 4 and later, where an area
    lamp's are 4 / pi of what they were."""
    data = bpy.data.lights.new("Lamp", kind)
    data.energy = energy
    if kind == "AREA" and bpy.app.version < (4, 0, 0):
        data.energy *= 4 / math.pi
    for name, value in settings.items():
        setattr(data, name, value)
    shown = add(data, location, "Lamp")
    aim(shown, target)
    return shown


def sun(energy: float = 2.0, angle: float = 0.7) -> bpy.types.Object:
    return lamp("SUN", energy, location=(-2.0, -2.5, 4.0), target=(0, 0, 0), angle=angle)


# --- whole scenes --------------------------------------------------------------------------


def floor(dark=(0.25, 0.25, 0.27), light=(0.6, 0.58, 0.55)) -> bpy.types.Object:
    """Tiles of 0.8 m in two colours, so that what is seen through glass or in a mirror tells."""
    mesh = dressed(grid_mesh(15, 15, (12.0, 12.0), "Floor"), diffuse(dark), diffuse(light))
    slots = np.indices((15, 15)).sum(axis=0).ravel() % 2
    mesh.polygons.foreach_set("material_index", slots.astype(np.int32))
    return add(mesh, name="Floor")


def outdoors() -> None:
    """Camera, floor, sky and sun, for what is put in their middle."""
    camera()
    floor()
    world()
    sun()


def by_night() -> None:
    """Camera, floor, grey ball and almost no sky."""
    camera()
    floor()
    world(DIM)
    add(dressed(ball_mesh(), diffuse()), BALL_CENTRE, "Ball")


def lit_by(kind: str, energy: float, **settings) -> bpy.types.Object:
    by_night()
    if kind in ("POINT", "SPOT") and bpy.app.version >= (4, 0, 0):
        settings.setdefault("use_soft_falloff", True)
    return lamp(kind, energy, (-1.6, -1.6, 2.8), **settings)


def ball(material: bpy.types.Material) -> bpy.types.Object:
    """The lit ball of the material."""
    outdoors()
    return add(dressed(ball_mesh(), material), BALL_CENTRE, "Ball")


def ball_of(kind: str, inputs: dict | None = None, **properties) -> bpy.types.Object:
    """The lit ball of one shader node."""
    return ball(shader(kind, inputs, **properties))


def painted_ball(paint: Callable[[Tree], object]) -> bpy.types.Object:
    """The ball, unlit, with the colour, value or vector that `paint` gives."""
    camera()
    world(GREY)
    return add(dressed(ball_mesh(), shows(paint)), BALL_CENTRE, "Ball")


def facing_camera() -> bpy.types.Object:
    """Above the XY plane, so that two metres of it fill the picture."""
    return camera((0.0, 0.0, 4.0), (0, 0, 0), math.degrees(2 * math.atan(0.25)))


def wall(paint: Callable[[Tree], object]) -> bpy.types.Object:
    """A picture full of the colour, value or vector that `paint` gives."""
    return tiles([paint])


def tiles(paints: list[Callable[[Tree], object]], columns: int = 0) -> bpy.types.Object:
    """The picture in equal tiles, row by row from the bottom, one for each paint."""
    columns = columns or math.ceil(math.sqrt(len(paints)))
    rows = math.ceil(len(paints) / columns)
    facing_camera()
    world((0.0, 0.0, 0.0))
    mesh = dressed(grid_mesh(columns, rows), *map(shows, paints))
    # What is left over is as the last.
    slots = np.minimum(np.arange(columns * rows), len(paints) - 1)
    mesh.polygons.foreach_set("material_index", slots.astype(np.int32))
    return add(mesh, name="Wall")


def at(location) -> Matrix:
    return Matrix.Translation(location)
