"""What Cycles makes of the Sky Texture: the reference of tests/shading.

Run inside Blender 4.3, then turned into tests/data/nodes/skies.json:

    blender -b --factory-startup --python tests/tools/sky_references.py -- OUT_FOLDER
    python3 tests/tools/sky_references.py OUT_FOLDER tests/data/nodes/skies.json

Each sky is seen all around and, if it has a sun, close to it. Which way each pixel looks is told
by pictures of a world whose colour is its direction.
"""

import json
import math
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

AROUND = (24, 16)
CLOSE = (8, 8)

SKIES = [
    {"sky_type": "NISHITA", "sun_disc": False},
    {
        "sky_type": "NISHITA",
        "sun_disc": False,
        "sun_elevation": -0.06,
        "sun_rotation": 2.0,
        "altitude": 3000.0,
        "air_density": 2.0,
        "dust_density": 3.0,
        "ozone_density": 4.0,
    },
    {"sky_type": "NISHITA", "sun_elevation": 0.5, "sun_rotation": 0.8, "sun_intensity": 0.3},
    {"sky_type": "NISHITA", "sun_elevation": 0.01, "sun_rotation": -0.8, "sun_size": 0.05},
    {"sky_type": "NISHITA", "sun_elevation": 2.5, "sun_rotation": 7.0, "sun_size": 0.0},
    {
        "sky_type": "NISHITA",
        "sun_elevation": 1.2,
        "altitude": 20000.0,
        "dust_density": 0.0,
        "ozone_density": 0.0,
    },
    {"sky_type": "PREETHAM", "sun_direction": [0.0, 0.6, 0.8], "turbidity": 2.2},
    {"sky_type": "PREETHAM", "sun_direction": [0.6, -0.7, 0.1], "turbidity": 6.0},
    {"sky_type": "HOSEK_WILKIE", "sun_direction": [0.0, 0.6, 0.8], "turbidity": 2.2},
    {
        "sky_type": "HOSEK_WILKIE",
        "sun_direction": [0.6, -0.7, 0.1],
        "turbidity": 6.7,
        "ground_albedo": 0.8,
    },
    {"sky_type": "HOSEK_WILKIE", "sun_direction": [-0.6, 0.8, 0.0], "turbidity": 10.0},
]


@dataclass(frozen=True)
class View:
    name: str
    size: tuple[int, int]
    sky: int
    is_close: bool


def views() -> Iterator[View]:
    for i, sky in enumerate(SKIES):
        yield View(f"around{i}", AROUND, i, is_close=False)
        if sky["sky_type"] == "NISHITA" and sky.get("sun_disc", True):
            yield View(f"close{i}", CLOSE, i, is_close=True)


def set_up(bpy):
    from engines import look_at_middles, set_up_cycles

    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    set_up_cycles(scene, samples=1)
    look_at_middles(scene)
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(scene.camera)
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    return scene


def aim(camera, view: View) -> None:
    from mathutils import Euler

    sky = SKIES[view.sky]
    camera.data.type = "PERSP" if view.is_close else "PANO"
    camera.data.panorama_type = "EQUIRECTANGULAR"
    # Wide enough for all of the disc and some sky around it.
    camera.data.angle = 1.4 * max(sky.get("sun_size", 0.0095), 0.0005)
    elevation = sky.get("sun_elevation", math.radians(15)) if view.is_close else 0.0
    rotation = sky.get("sun_rotation", 0.0) if view.is_close else 0.0
    camera.rotation_euler = Euler((math.pi / 2 + elevation, 0.0, -rotation))


def render_all(folder: Path) -> None:
    import bpy

    scene = set_up(bpy)
    tree = scene.world.node_tree
    tree.nodes.clear()
    sky = tree.nodes.new("ShaderNodeTexSky")
    usual = {
        name: getattr(sky, name)
        for name in (
            "sun_disc sun_size sun_intensity sun_elevation sun_rotation altitude air_density "
            "dust_density ozone_density turbidity ground_albedo"
        ).split()
    }
    place = tree.nodes.new("ShaderNodeTexCoord").outputs["Generated"]
    shown = tree.nodes.new("ShaderNodeVectorMath")  # colours are not negative
    shown.operation = "MULTIPLY_ADD"
    shown.inputs[1].default_value = shown.inputs[2].default_value = (0.5, 0.5, 0.5)
    tree.links.new(place, shown.inputs[0])
    background = tree.nodes.new("ShaderNodeBackground")
    output = tree.nodes.new("ShaderNodeOutputWorld")
    tree.links.new(background.outputs["Background"], output.inputs["Surface"])

    options = []
    for view in views():
        for name, value in {**usual, **SKIES[view.sky]}.items():
            setattr(sky, name, value)
        options.append({name: getattr(sky, name) for name in (*usual, "sky_type")})
        options[-1]["sun_direction"] = list(sky.sun_direction)
        aim(scene.camera, view)
        scene.render.resolution_x, scene.render.resolution_y = view.size
        for what, socket in (("sky", sky.outputs["Color"]), ("way", shown.outputs["Vector"])):
            tree.links.new(socket, background.inputs["Color"])
            scene.render.filepath = str(folder / f"{view.name}_{what}.exr")
            bpy.ops.render.render(write_still=True)
    (folder / "options.json").write_text(json.dumps(options), encoding="utf-8")


def pixels(path: Path):
    import OpenImageIO as oiio

    return oiio.ImageInput.open(str(path)).read_image(oiio.FLOAT).reshape(-1, 4)[:, :3]


def write_table(folder: Path, table: Path) -> None:
    options = json.loads((folder / "options.json").read_text(encoding="utf-8"))
    lines = []
    for view, said in zip(views(), options, strict=True):
        ways = 2.0 * pixels(folder / f"{view.name}_way.exr") - 1.0
        colors = pixels(folder / f"{view.name}_sky.exr")
        case = {
            "options": said,
            "is_close": view.is_close,
            "directions": [[float(f"{v:.8g}") for v in way] for way in ways],
            "colors": [[float(f"{v:.6g}") for v in color] for color in colors],
        }
        lines.append(json.dumps(case, separators=(",", ":")))
    text = ",\n".join(lines)
    table.write_text(f"[\n{text}\n]\n", encoding="utf-8")


if __name__ == "__main__":
    if "--" in sys.argv:
        render_all(Path(sys.argv[sys.argv.index("--") + 1]))
    else:
        write_table(Path(sys.argv[1]), Path(sys.argv[2]))
