"""What Cycles makes of the converter, vector and colour nodes: the reference of tests/shading.

Run inside Blender 4.3, then turned into tests/data/nodes/converters.json:

    blender -b --factory-startup --python tests/tools/converter_references.py -- OUT_FOLDER
    python3 tests/tools/converter_references.py OUT_FOLDER tests/data/nodes/converters.json

Every pixel looks at a face of its own, whose attributes are the inputs ("channels"); every node's
output is an AOV. A case names the node, its options, the channel of each input, and its outputs.
Numbers that are no finite number are texts.
"""

import json
import math
import sys
from array import array
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from converter_cases import Case, cases, channels

COLUMNS, LINES = 8, 6
ROWS = COLUMNS * LINES
HEIGHT = 5.0  # of the camera above the faces
NEAR = 0.5  # where its rays start
BATCH = 40  # cases a picture: more would not fit the stack of Cycles' shader machine
AOV = "case{}_{}"  # Blender puts _ for a dot


def is_vector(values: list) -> bool:
    return isinstance(values[0], list)


def stage():
    """The frame that everything stands in, so that camera and world are two things."""
    from mathutils import Euler, Matrix

    return Matrix.LocRotScale((0.5, -2.0, 1.0), Euler((0.4, -0.7, 1.1)), None)


def make_faces(bpy) -> None:
    """One unit square a row: the camera above sees each with one pixel, from the top left on."""
    from mathutils import Euler, Matrix, Vector

    corners = [
        (row % COLUMNS + dx, LINES - 1 - row // COLUMNS + dy, 0.0)
        for row in range(ROWS)
        for dx, dy in ((0, 0), (1, 0), (1, 1), (0, 1))
    ]
    object_matrix = Matrix.LocRotScale((1.0, 2.0, -3.0), Euler((0.3, 0.2, -0.9)), (2.0, -0.5, 1.5))
    into_object = object_matrix.inverted() @ stage()
    mesh = bpy.data.meshes.new("rows")
    mesh.from_pydata(
        [into_object @ Vector(corner) for corner in corners],
        [],
        [tuple(range(4 * i, 4 * i + 4)) for i in range(ROWS)],
    )
    for name, values in channels(ROWS).items():
        kind = "FLOAT_VECTOR" if is_vector(values) else "FLOAT"
        attribute = mesh.attributes.new(name, kind, "FACE")
        # One by one, Blender would limit infinities to the greatest float.
        if kind == "FLOAT":
            attribute.data.foreach_set("value", array("f", values))
        else:
            flat = array("f", [number for vector in values for number in vector])
            attribute.data.foreach_set("vector", flat)
    rows = bpy.data.objects.new("rows", mesh)
    rows.matrix_world = object_matrix
    bpy.context.collection.objects.link(rows)
    material = bpy.data.materials.new("rows")
    material.use_nodes = True
    mesh.materials.append(material)


def make_camera(bpy) -> None:
    from mathutils import Matrix

    camera = bpy.data.cameras.new("camera")
    camera.type = "ORTHO"
    camera.clip_start = NEAR
    camera.ortho_scale = max(COLUMNS, LINES)
    holder = bpy.data.objects.new("camera", camera)
    holder.matrix_world = stage() @ Matrix.Translation((COLUMNS / 2, LINES / 2, HEIGHT))
    bpy.context.collection.objects.link(holder)
    scene = bpy.context.scene
    scene.camera = holder
    scene.render.resolution_x, scene.render.resolution_y = COLUMNS, LINES
    scene.render.resolution_percentage = 100


def set_up_render(bpy) -> None:
    from engines import look_at_middles, set_up_cycles

    scene = bpy.context.scene
    set_up_cycles(scene, samples=1)
    look_at_middles(scene)
    scene.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.exr_codec = "ZIP"
    scene.use_nodes = False


def add_case(tree, case: Case, number: int, layer) -> None:
    node = tree.nodes.new(case.blender_type)
    case.apply(node)
    for socket, channel in case.inputs.items():
        attribute = tree.nodes.new("ShaderNodeAttribute")
        attribute.attribute_name = channel
        by_identifier = {s.identifier: s for s in node.inputs}
        output = "Fac" if not is_vector(channels(ROWS)[channel]) else "Vector"
        tree.links.new(attribute.outputs[output], by_identifier[socket])
    for output in node.outputs:
        if output.identifier not in case.outputs:
            continue
        name = AOV.format(number, output.identifier)
        aov = layer.aovs.add()
        aov.name = name
        aov.type = "VALUE" if output.type == "VALUE" else "COLOR"
        sink = tree.nodes.new("ShaderNodeOutputAOV")
        sink.aov_name = name
        tree.links.new(output, sink.inputs["Value" if aov.type == "VALUE" else "Color"])


def render_all(folder: Path) -> None:
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    make_faces(bpy)
    make_camera(bpy)
    set_up_render(bpy)
    layer = bpy.context.view_layer
    tree = bpy.data.materials["rows"].node_tree
    everything = list(cases())
    for first in range(0, len(everything), BATCH):
        tree.nodes.clear()
        # Cycles evaluates the AOVs of a material that has a surface.
        surface = tree.nodes.new("ShaderNodeEmission").outputs["Emission"]
        tree.links.new(surface, tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
        while layer.aovs:
            layer.aovs.remove(layer.aovs[0])
        for number in range(first, min(first + BATCH, len(everything))):
            add_case(tree, everything[number], number, layer)
        bpy.context.scene.render.filepath = str(folder / f"{first:04}.exr")
        bpy.ops.render.render(write_still=True)
    options = [case.options_of_blender(bpy) for case in everything]
    matrices = {
        name: [list(row) for row in bpy.data.objects[name].matrix_world]
        for name in ("rows", "camera")
    }
    facts = {"options": options, "matrices": matrices}
    (folder / "facts.json").write_text(json.dumps(facts), encoding="utf-8")


def shortest(value) -> float | str:
    """The shortest decimal that is this float32."""
    import numpy

    if not math.isfinite(value):
        return str(float(value))
    return float(str(numpy.float32(value)))


def pictures(folder: Path) -> Iterator[tuple[str, list]]:
    """The name of each AOV, and its rows."""
    import OpenImageIO as oiio

    for path in sorted(folder.glob("*.exr")):
        picture = oiio.ImageInput.open(str(path))
        names = picture.spec().channelnames
        pixels = picture.read_image(oiio.FLOAT).reshape(ROWS, len(names))
        column = {name.split(".", 1)[1]: pixels[:, i] for i, name in enumerate(names)}
        for name in {name.rsplit(".", 1)[0] for name in column if name.startswith("case")}:
            parts = [column[f"{name}.{c}"] for c in "RGB" if f"{name}.{c}" in column]
            if parts:
                yield name, [[shortest(v) for v in row] for row in zip(*parts, strict=True)]
            else:
                yield name, [shortest(v) for v in column[f"{name}.X"]]


def write_table(folder: Path, table: Path) -> None:
    outputs = dict(pictures(folder))
    facts = json.loads((folder / "facts.json").read_text(encoding="utf-8"))
    lines = []
    for number, case in enumerate(cases()):
        lines.append(
            {
                "node": case.node_type,
                "options": facts["options"][number],
                "inputs": case.inputs,
                "outputs": {name: outputs[AOV.format(number, name)] for name in case.outputs},
            }
        )
    inputs = {
        name: [
            [shortest(v) for v in row] if is_vector(values) else shortest(row) for row in values
        ]
        for name, values in channels(ROWS).items()
    }
    compact = {"separators": (",", ":")}
    rows = ",\n".join(json.dumps(line, **compact) for line in lines)
    head = {
        "world_from_object": facts["matrices"]["rows"],
        "world_from_camera": facts["matrices"]["camera"],
        "ray_length": HEIGHT - NEAR,
        "channels": inputs,
    }
    text = json.dumps(head, **compact).removesuffix("}")
    table.write_text(f'{text},\n"cases":[\n{rows}\n]}}\n', encoding="utf-8")


if __name__ == "__main__":
    if "--" in sys.argv:
        render_all(Path(sys.argv[sys.argv.index("--") + 1]))
    else:
        write_table(Path(sys.argv[1]), Path(sys.argv[2]))
