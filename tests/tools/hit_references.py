"""What Cycles makes of the nodes that ask where the hit is: the reference of tests/scene.

Run inside Blender 4.3, then turned into tests/data/nodes/hits.json:

    blender -b --factory-startup --python tests/tools/hit_references.py -- OUT_FOLDER
    python3 tests/tools/hit_references.py OUT_FOLDER tests/data/nodes/hits.json

Two bodies fill the picture: a smooth one, turned and enlarged, and a flat one, mirrored and
stretched, half of whose faces show their backs. Every output of a case is an AOV; an input is a
constant or the output of another node. UV layers and attributes are a formula of the position, so
that both sides of the test can make them.
"""

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from hit_cases import cases, displacement_cases, height_cases

COLUMNS, LINES = 10, 6
LENS_MM, SENSOR_MM = 30.0, 36.0
BATCH = 24  # cases a picture: more would not fit the stack of Cycles' shader machine
AOV = "case{}_{}"
CELLS = 4  # of a body, along each side

BLENDER_TYPES = {
    "TEX_COORD": "TexCoord",
    "NEW_GEOMETRY": "NewGeometry",
    "UVMAP": "UVMap",
    "ATTRIBUTE": "Attribute",
    "VERTEX_COLOR": "VertexColor",
    "OBJECT_INFO": "ObjectInfo",
    "CAMERA": "CameraData",
    "LIGHT_PATH": "LightPath",
    "FRESNEL": "Fresnel",
    "LAYER_WEIGHT": "LayerWeight",
    "WIREFRAME": "Wireframe",
    "TEX_IMAGE": "TexImage",
    "TEX_ENVIRONMENT": "TexEnvironment",
    "TANGENT": "Tangent",
    "NORMAL_MAP": "NormalMap",
    "BUMP": "Bump",
    "DISPLACEMENT": "Displacement",
    "VECTOR_DISPLACEMENT": "VectorDisplacement",
}


def uv_first(p) -> tuple[float, float]:
    return 0.3 + 0.4 * p[0] + 0.1 * p[1], 0.6 - 0.1 * p[0] + 0.35 * p[1]


def uv_second(p) -> tuple[float, float]:
    return 0.8 - 0.3 * p[0], 0.2 + 0.5 * p[1]


def paint(p) -> tuple[float, float, float, float]:
    return 0.5 + 0.2 * p[0], 0.4 - 0.1 * p[1], 0.3 + 0.3 * p[2], 0.7 + 0.2 * p[0]


def weight(p) -> float:
    return 0.3 * p[0] - 0.2 * p[1] + 0.5 * p[2]


def picture_pixels() -> list[float]:
    """Eight by four, RGBA, smooth enough for the rounding of coordinates not to matter."""
    return [
        value
        for y in range(4)
        for x in range(8)
        for value in (0.1 + 0.1 * x, 0.2 + 0.2 * y, 0.5 + 0.05 * ((x * y) % 5), 1.0)
    ]


def make_body(bpy, name: str, matrix, is_smooth: bool) -> dict:
    """A wavy square of triangles; the flat one's second half is wound the other way."""
    import math

    side = CELLS + 1
    positions = [
        (
            -1.0 + 2.0 * i / CELLS,
            -1.0 + 2.0 * j / CELLS,
            0.25 * math.sin(1.3 * i + 0.4) * math.cos(0.9 * j),
        )
        for j in range(side)
        for i in range(side)
    ]
    triangles = []
    for j in range(CELLS):
        for i in range(CELLS):
            a, b, c, d = (
                j * side + i,
                j * side + i + 1,
                (j + 1) * side + i + 1,
                (j + 1) * side + i,
            )
            for triangle in ((a, b, c), (a, c, d)):
                turned = not is_smooth and j >= CELLS // 2
                triangles.append(triangle[::-1] if turned else triangle)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(positions, [], triangles)
    corners = [positions[v] for triangle in triangles for v in triangle]
    for layer, formula in (("first", uv_first), ("second", uv_second)):
        flat = [x for p in corners for x in formula(p)]
        mesh.uv_layers.new(name=layer).data.foreach_set("uv", flat)
    colors = mesh.attributes.new("paint", "FLOAT_COLOR", "CORNER")
    colors.data.foreach_set("color", [x for p in corners for x in paint(p)])
    weights = mesh.attributes.new("weight", "FLOAT", "POINT")
    weights.data.foreach_set("value", [weight(p) for p in positions])
    mesh.polygons.foreach_set("use_smooth", [is_smooth] * len(triangles))
    mesh.update()
    body = bpy.data.objects.new(name, mesh)
    body.matrix_world = matrix
    body.color = (0.2, 0.4, 0.6, 0.8) if is_smooth else (0.9, 0.7, 0.5, 0.3)
    body.pass_index = 3 if is_smooth else 5
    bpy.context.collection.objects.link(body)
    return {
        "world_from_object": [list(row) for row in body.matrix_world],
        "positions": [list(v.co) for v in mesh.vertices],
        "normals": [list(v.normal) for v in mesh.vertices] if is_smooth else [],
        "triangles": [list(p.vertices) for p in mesh.polygons],
        "color": list(body.color),
        "pass_index": body.pass_index,
        "uvs": {
            "first": [uv_first(p) for p in corners],
            "second": [uv_second(p) for p in corners],
        },
        "attributes": {
            "paint": [paint(p) for p in corners],
            "weight": [[weight(p)] * 3 + [1.0] for p in corners],
        },
    }


def make_stage(bpy) -> dict:
    from engines import look_at_middles, set_up_cycles
    from mathutils import Euler, Matrix

    holder = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    holder.data.lens, holder.data.sensor_width = LENS_MM, SENSOR_MM
    holder.matrix_world = Matrix.LocRotScale((0.3, -0.2, 4.0), Euler((0.06, 0.02, 0.1)), None)
    bpy.context.collection.objects.link(holder)
    scene = bpy.context.scene
    scene.camera = holder
    scene.render.resolution_x, scene.render.resolution_y = COLUMNS, LINES
    scene.render.resolution_percentage = 100
    set_up_cycles(scene, samples=1)
    look_at_middles(scene)
    scene.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
    scene.render.image_settings.color_depth = "32"
    scene.use_nodes = False
    left = Matrix.LocRotScale((-1.2, 0.1, 0.3), Euler((0.2, -0.3, 0.5)), (1.3, 1.3, 1.3))
    right = Matrix.LocRotScale((1.7, -0.1, -0.2), Euler((-0.3, 0.25, -0.4)), (-1.3, 1.5, 0.8))
    bodies = [
        make_body(bpy, "smooth", left, is_smooth=True),
        make_body(bpy, "flat", right, is_smooth=False),
    ]
    return {"world_from_camera": [list(row) for row in holder.matrix_world], "bodies": bodies}


def make_images(bpy, folder: Path) -> dict:
    smooth = bpy.data.images.new("smooth", 8, 4, alpha=True, float_buffer=True)
    smooth.colorspace_settings.name = "Non-Color"
    smooth.pixels.foreach_set(picture_pixels())
    smooth.pack()
    tile_colors = {1001: (0.2, 0.4, 0.6), 1002: (0.7, 0.1, 0.3), 1011: (0.9, 0.8, 0.5)}
    for number, color in tile_colors.items():
        tile = bpy.data.images.new(str(number), 4, 4, float_buffer=True)
        tile.colorspace_settings.name = "Non-Color"
        tile.pixels.foreach_set([*color, 1.0] * 16)
        tile.file_format = "OPEN_EXR"
        tile.filepath_raw = str(folder / f"tile.{number}.exr")
        tile.save()
    tiled = bpy.data.images.load(str(folder / "tile.1001.exr"))
    tiled.source = "TILED"
    tiled.filepath = str(folder / "tile.<UDIM>.exr")
    for number in (1002, 1011):
        tiled.tiles.new(number)
    tiled.colorspace_settings.name = "Non-Color"
    return {"smooth": smooth, "tiled": tiled}


def socket_of(sockets, identifier: str):
    return next(s for s in sockets if s.identifier == identifier)


def add_node(tree, case: dict, images: dict):
    node = tree.nodes.new("ShaderNode" + BLENDER_TYPES[case["node"]])
    for name, value in case["options"].items():
        if name == "texture":
            node.image = images["smooth"]
        elif name == "tiles":
            node.image = images["tiled"]
        else:
            setattr(node, name, value)
    for identifier, value in case["inputs"].items():
        socket = socket_of(node.inputs, identifier)
        if isinstance(value, list) and isinstance(value[0], str):
            source = tree.nodes.new("ShaderNode" + BLENDER_TYPES[value[0]])
            tree.links.new(socket_of(source.outputs, value[1]), socket)
        else:
            socket.default_value = [*value, 1.0] if isinstance(value, list) else value
    return node


def add_aov(tree, output, name: str, layer) -> None:
    aov = layer.aovs.add()
    aov.name, aov.type = name, "COLOR"
    sink = tree.nodes.new("ShaderNodeOutputAOV")
    sink.aov_name = name
    tree.links.new(output, sink.inputs["Color"])


def start_tree(bpy, layer):
    tree = bpy.data.materials["paint"].node_tree
    tree.nodes.clear()
    # Cycles evaluates the AOVs of a material that has a surface.
    surface = tree.nodes.new("ShaderNodeEmission").outputs["Emission"]
    sink = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(surface, sink.inputs["Surface"])
    while layer.aovs:
        layer.aovs.remove(layer.aovs[0])
    return tree, sink


def render_all(folder: Path) -> None:
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    facts = make_stage(bpy)
    images = make_images(bpy, folder)
    layer = bpy.context.view_layer
    material = bpy.data.materials.new("paint")
    material.use_nodes, material.pass_index = True, 7
    material.displacement_method = "BUMP"
    for body in ("smooth", "flat"):
        bpy.data.meshes[body].materials.append(material)

    def render(name: str) -> None:
        bpy.context.scene.render.filepath = str(folder / f"{name}.exr")
        bpy.ops.render.render(write_still=True)

    plain = cases()
    for first in range(0, len(plain), BATCH):
        tree, _ = start_tree(bpy, layer)
        for number in range(first, min(first + BATCH, len(plain))):
            node = add_node(tree, plain[number], images)
            for output in plain[number]["outputs"]:
                name = AOV.format(number, output.replace(" ", "_"))
                add_aov(tree, socket_of(node.outputs, output), name, layer)
        render(f"plain{first:03}")
    tree, _ = start_tree(bpy, layer)
    for number, case in enumerate(height_cases()):
        node = add_node(tree, case, images)
        place = tree.nodes.new("ShaderNodeTexCoord").outputs["Object"]
        tree.links.new(place, node.inputs["Height"])
        add_aov(tree, node.outputs["Normal"], AOV.format(number, "bump"), layer)
    render("bump")
    for number, case in enumerate(displacement_cases()):
        tree, sink = start_tree(bpy, layer)
        node = add_node(tree, case, images)
        place = tree.nodes.new("ShaderNodeTexCoord").outputs["Object"]
        tree.links.new(place, node.inputs[0])
        tree.links.new(node.outputs[0], sink.inputs["Displacement"])
        normal = tree.nodes.new("ShaderNodeNewGeometry").outputs["Normal"]
        add_aov(tree, normal, AOV.format(number, "displaced"), layer)
        render(f"displaced{number}")
    (folder / "facts.json").write_text(json.dumps(facts), encoding="utf-8")


def shortest(value) -> float:
    """Six digits are enough to compare by."""
    return float(f"{float(value):.6g}")


def write_table(folder: Path, table: Path) -> None:
    import OpenImageIO as oiio

    columns = {}
    for path in sorted(folder.glob("*.exr")):
        if path.name.startswith("tile"):
            continue
        picture = oiio.ImageInput.open(str(path))
        names = picture.spec().channelnames
        pixels = picture.read_image(oiio.FLOAT).reshape(COLUMNS * LINES, len(names))
        for i, name in enumerate(names):
            columns[name.split(".", 1)[1]] = pixels[:, i]

    def values(name: str) -> list:
        parts = [columns[f"{name}.{c}"] for c in "RGB"]
        return [[shortest(v) for v in row] for row in zip(*parts, strict=True)]

    rows = cases()
    for number, row in enumerate(rows):
        row["outputs"] = {
            output: values(AOV.format(number, output.replace(" ", "_")))
            for output in row["outputs"]
        }
    bumps = height_cases()
    for number, row in enumerate(bumps):
        row["outputs"] = {"Normal": values(AOV.format(number, "bump"))}
    displaced = displacement_cases()
    for number, row in enumerate(displaced):
        row["normal"] = values(AOV.format(number, "displaced"))
    half = 0.5 * SENSOR_MM / LENS_MM
    head = {
        **json.loads((folder / "facts.json").read_text(encoding="utf-8")),
        "columns": COLUMNS,
        "lines": LINES,
        "half_slope": [half, half * LINES / COLUMNS],
        "picture": [shortest(v) for v in picture_pixels()],
        "tiles": [[0.2, 0.4, 0.6], [0.7, 0.1, 0.3], [0.9, 0.8, 0.5]],
        "material_index": 7,
    }
    compact = {"separators": (",", ":")}
    text = json.dumps(head, **compact).removesuffix("}")
    for name, lines in (("cases", rows), ("bumps", bumps), ("displacements", displaced)):
        body = ",\n".join(json.dumps(line, **compact) for line in lines)
        text += f',\n"{name}":[\n{body}\n]'
    table.write_text(text + "}\n", encoding="utf-8")


if __name__ == "__main__":
    if "--" in sys.argv:
        render_all(Path(sys.argv[sys.argv.index("--") + 1]))
    else:
        write_table(Path(sys.argv[1]), Path(sys.argv[2]))
