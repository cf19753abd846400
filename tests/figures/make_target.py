"""Builds a target that glows evenly and saves it. Runs inside Blender:

blender -b --factory-startup --python make_target.py -- FILE.blend lines|near_lines|lamps

lines: black ones on white, as many horizontal as vertical, alike under a quarter turn.
near_lines: the same at reading distance.
lamps: four small ones and a letter on black.
"""

import math
import sys

import bpy

DISTANCE_M = 6.0  # beyond 1/3 m, where -6.00DC leaves no line in focus but those of one direction
READING_M = 0.4
FIELD_DEG = 16.0
CARD_ARCMIN = 840
LINES = 7  # in each quarter of the card
LINE_ARCMIN = 24  # as wide as the gap to the next
LAMP_ARCMIN = 8
LETTER_ARCMIN = 200


def main(path: str, target: str) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("dark")
    scene.world.color = (0, 0, 0)
    # From Blender 5.0 a new world has nodes, and they are grey.
    for node in scene.world.node_tree.nodes if scene.world.node_tree else ():
        if node.bl_idname == "ShaderNodeBackground":
            node.inputs["Color"].default_value = (0, 0, 0, 1)
    if target in ("lines", "near_lines"):
        distance_m = DISTANCE_M if target == "lines" else READING_M
        _rectangles("card", 0.8, distance_m, [(0, 0, CARD_ARCMIN / 2, CARD_ARCMIN / 2)])
        _rectangles("lines", 0.02, 0.998 * distance_m, list(_lines()))
    else:
        _rectangles("lamps", 30.0, DISTANCE_M, list(_lamps()))
        _rectangles("letter", 0.8, DISTANCE_M, list(_letter()))
    camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
    camera.data.angle = math.radians(FIELD_DEG)
    camera.rotation_euler = (math.pi / 2, 0, 0)  # looks along +y
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.view_settings.view_transform = "Standard"
    bpy.ops.wm.save_as_mainfile(filepath=path, compress=True)


def _lines():
    """Centres and half sizes (arcmin). The lines of two opposite quarters are horizontal."""
    half_length = (LINES - 0.5) * LINE_ARCMIN
    centre = CARD_ARCMIN / 4
    for right in (-1, 1):
        for up in (-1, 1):
            for number in range(LINES):
                across = (2 * number - LINES + 1) * LINE_ARCMIN
                if right == up:
                    yield right * centre + across, up * centre, LINE_ARCMIN / 2, half_length
                else:
                    yield right * centre, up * centre + across, half_length, LINE_ARCMIN / 2


def _lamps():
    for right in (-1, 1):
        for up in (-1, 1):
            x, y = right * CARD_ARCMIN * 0.35, up * CARD_ARCMIN * 0.35
            yield x, y, LAMP_ARCMIN / 2, LAMP_ARCMIN / 2


def _letter():
    """An E of strokes and gaps of a fifth of its height."""
    stroke = LETTER_ARCMIN / 5
    yield -2 * stroke, 0, stroke / 2, LETTER_ARCMIN / 2
    for up in (-2, 0, 2):
        yield stroke / 2, up * stroke, 2 * stroke, stroke / 2


def _rectangles(name: str, radiance: float, distance_m: float, rectangles: list) -> None:
    def metres(arcmin: float) -> float:
        return distance_m * math.tan(math.radians(arcmin / 60))

    corners = [
        (metres(x + right * w), distance_m, metres(y + up * h))
        for x, y, w, h in rectangles
        for right, up in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], [range(4 * k, 4 * k + 4) for k in range(len(rectangles))])
    mesh.materials.append(_glowing(name, radiance))
    bpy.context.scene.collection.objects.link(bpy.data.objects.new(name, mesh))


def _glowing(name: str, radiance: float) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    if material.node_tree is None:  # before Blender 5
        material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    emission = tree.nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = (radiance, radiance, radiance, 1)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(emission.outputs[0], output.inputs["Surface"])
    return material


main(*sys.argv[sys.argv.index("--") + 1 :])
