"""What Cycles makes of each surface closure, as numbers to test against. Inside Blender 4.3:

blender -b --factory-startup --python closures_in_cycles.py -- CLOSURES.csv

Every closure covers one tile of a plane seen from afar, by a camera without perspective. A sun
without width shows the closure's value for two directions, without noise; a white world shows its
albedo. Directions are angles from the tile's normal (+Z) and turns around it; the camera stands
at azimuth 0. The columns `options` and `inputs` hold the node's properties and socket identifiers,
`name=value` with `|` between them, and `/` between the parts of a colour.
"""

import csv
import sys
import tempfile
from dataclasses import dataclass, field
from math import cos, radians, sin
from pathlib import Path

import bpy
import numpy as np
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).resolve().parent))
from engines import keep_all_light, look_at_middles, set_up_cycles  # noqa: E402

VIEWS_DEG = (15, 60, 75)
SUNS_DEG = ((20, 150), (50, 60), (65, 170), (140, 200))
COLUMNS, PIXELS_A_TILE, SUN_SAMPLES, WORLD_SAMPLES = 8, 32, 16, 1024

ORANGE, BLUE = (0.9, 0.5, 0.2), (0.1, 0.3, 0.9)


@dataclass
class Case:
    name: str
    node: str
    inputs: dict = field(default_factory=dict)
    options: dict = field(default_factory=dict)
    is_back: bool = False


def principled(name: str, is_back: bool = False, **inputs) -> Case:
    named = {key.replace("_", " "): value for key, value in inputs.items()}
    return Case(name, "ShaderNodeBsdfPrincipled", {"Base Color": ORANGE, **named}, {}, is_back)


def glossy(distribution: str, roughness: float, **inputs) -> Case:
    turned = " turned" if inputs else ""
    return Case(
        f"glossy {distribution} {roughness}{turned} {inputs.get('Anisotropy', '')}".strip(),
        "ShaderNodeBsdfAnisotropic",
        {"Color": ORANGE, "Roughness": roughness, **inputs},
        {"distribution": distribution},
    )


def see_through(kind: str, distribution: str, roughness: float, is_back: bool = False) -> Case:
    side = "inside" if is_back else "outside"
    return Case(
        f"{kind} {distribution} {roughness} {side}",
        f"ShaderNodeBsdf{kind}",
        {"Color": ORANGE, "Roughness": roughness, "IOR": 1.45},
        {"distribution": distribution},
        is_back,
    )


def metallic(name: str, fresnel: str, **inputs) -> Case:
    return Case(name, "ShaderNodeBsdfMetallic", inputs, {"fresnel_type": fresnel})


def sheen(distribution: str, roughness: float) -> Case:
    return Case(
        f"sheen {distribution} {roughness}",
        "ShaderNodeBsdfSheen",
        {"Color": ORANGE, "Roughness": roughness},
        {"distribution": distribution},
    )


def toon(component: str, size: float, smooth: float) -> Case:
    return Case(
        f"toon {component}",
        "ShaderNodeBsdfToon",
        {"Color": ORANGE, "Size": size, "Smooth": smooth},
        {"component": component},
    )


TURNED = {"Anisotropy": 0.6, "Rotation": 0.1, "Tangent": (1.0, 0.0, 0.0)}
CASES = [
    *(
        Case(f"diffuse {r}", "ShaderNodeBsdfDiffuse", {"Color": ORANGE, "Roughness": r})
        for r in (0.0, 0.4, 1.0)
    ),
    Case("translucent", "ShaderNodeBsdfTranslucent", {"Color": ORANGE}),
    toon("DIFFUSE", 0.5, 0.2),
    toon("GLOSSY", 0.4, 0.3),
    *(sheen("MICROFIBER", r) for r in (0.2, 0.5, 0.9)),
    *(sheen("ASHIKHMIN", r) for r in (0.3, 0.8)),
    *(
        glossy(d, r)
        for d in ("MULTI_GGX", "GGX", "BECKMANN", "ASHIKHMIN_SHIRLEY")
        for r in (0.4, 0.8)
    ),
    *(glossy(d, 0.5, **TURNED) for d in ("MULTI_GGX", "BECKMANN", "ASHIKHMIN_SHIRLEY")),
    glossy("GGX", 0.5, **{**TURNED, "Anisotropy": -0.4}),
    *(
        see_through("Glass", d, 0.4, is_back)
        for d in ("MULTI_GGX", "GGX", "BECKMANN")
        for is_back in (False, True)
    ),
    *(
        see_through("Refraction", d, 0.4, is_back)
        for d in ("GGX", "BECKMANN")
        for is_back in (False, True)
    ),
    metallic("metal", "F82", Roughness=0.5),
    metallic("conductor", "PHYSICAL_CONDUCTOR", Roughness=0.5),
    metallic("turned metal", "F82", Roughness=0.4, **TURNED),
    principled("principled"),
    principled("rough principled", Roughness=1.0, Diffuse_Roughness=0.7),
    principled("low specular", Specular_IOR_Level=0.2, Roughness=0.3),
    principled("high specular", Specular_IOR_Level=1.0, Roughness=0.3),
    principled("tinted specular", Specular_Tint=BLUE, Roughness=0.4, IOR=1.8),
    principled("principled metal", Metallic=1.0, Roughness=0.4),
    principled("tinted metal", Metallic=1.0, Specular_Tint=BLUE, Roughness=0.4),
    principled("part metal", Metallic=0.4, Roughness=0.6, Specular_Tint=BLUE),
    principled(
        "turned principled",
        Metallic=1.0,
        Anisotropic=0.8,
        Anisotropic_Rotation=0.1,
        Tangent=(1.0, 0.0, 0.0),
        Roughness=0.5,
    ),
    principled("coat", Coat_Weight=1.0, Coat_Roughness=0.3, Roughness=0.8),
    principled("tinted coat", Coat_Weight=0.7, Coat_Roughness=0.4, Coat_Tint=BLUE, Coat_IOR=1.8),
    principled("sheen on top", Sheen_Weight=0.8, Sheen_Tint=BLUE),
    principled(
        "all layers",
        Sheen_Weight=0.5,
        Coat_Weight=0.5,
        Coat_Tint=BLUE,
        Coat_Roughness=0.3,
        Metallic=0.3,
        Transmission_Weight=0.4,
        Alpha=0.7,
        Roughness=0.4,
    ),
    principled(
        "glow below",
        Coat_Weight=1.0,
        Coat_Roughness=0.3,
        Coat_Tint=BLUE,
        Sheen_Weight=0.3,
        Emission_Color=(1.0, 1.0, 1.0),
        Emission_Strength=0.5,
    ),
    *(
        principled(f"principled glass {side}", is_back, Transmission_Weight=1.0, Roughness=0.4)
        for is_back, side in ((False, "outside"), (True, "inside"))
    ),
    *(
        principled(
            f"tinted glass {side}",
            is_back,
            Transmission_Weight=1.0,
            Roughness=0.4,
            Specular_Tint=BLUE,
        )
        for is_back, side in ((False, "outside"), (True, "inside"))
    ),
    *(
        principled(f"film {nm}", Thin_Film_Thickness=nm, Thin_Film_IOR=1.6, Roughness=0.4)
        for nm in (20.0, 250.0, 600.0)
    ),
    *(
        principled(
            f"film on glass {side}",
            is_back,
            Thin_Film_Thickness=400.0,
            Thin_Film_IOR=1.33,
            Transmission_Weight=1.0,
            Roughness=0.4,
        )
        for is_back, side in ((False, "outside"), (True, "inside"))
    ),
]


def direction(polar_deg: float, azimuth_deg: float) -> Vector:
    theta, phi = radians(polar_deg), radians(azimuth_deg)
    return Vector((sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)))


def place_tile(case: Case, number: int) -> bpy.types.Object:
    bpy.ops.mesh.primitive_plane_add(size=0.9, location=(number % COLUMNS, number // COLUMNS, 0.0))
    tile = bpy.context.object
    if case.is_back:
        tile.rotation_euler.x = radians(180)
    material = bpy.data.materials.new(case.name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    closure = tree.nodes.new(case.node)
    for name, value in case.options.items():
        setattr(closure, name, value)
    for socket in closure.inputs:
        if socket.identifier == "Tangent" and "Tangent" in case.inputs:
            constant = tree.nodes.new("ShaderNodeCombineXYZ")
            for axis, value in enumerate(case.inputs["Tangent"]):
                constant.inputs[axis].default_value = value
            tree.links.new(constant.outputs[0], socket)
        elif socket.identifier in case.inputs:
            value = case.inputs[socket.identifier]
            socket.default_value = (*value, 1.0) if socket.type == "RGBA" else value
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(closure.outputs[0], output.inputs["Surface"])
    tile.data.materials.append(material)
    case.type = closure.type
    return tile


def look_along(thing: bpy.types.Object, towards: Vector) -> None:
    thing.rotation_euler = towards.to_track_quat("-Z", "Y").to_euler()


def set_up(scene: bpy.types.Scene) -> None:
    keep_all_light(scene)
    look_at_middles(scene)
    scene.render.resolution_x = (COLUMNS + 1) * PIXELS_A_TILE
    scene.render.resolution_y = (len(CASES) // COLUMNS + 2) * PIXELS_A_TILE
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.film_transparent = False
    scene.world = bpy.data.worlds.new("even")
    scene.world.use_nodes = True


def render(scene: bpy.types.Scene) -> np.ndarray:
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = str(Path(folder) / "picture.exr")
        bpy.ops.render.render(write_still=True)
        picture = bpy.data.images.load(scene.render.filepath)
        width, height = picture.size
        pixels = np.empty(width * height * 4, np.float32)
        picture.pixels.foreach_get(pixels)
        bpy.data.images.remove(picture)
        return pixels.reshape(height, width, 4)


def main() -> None:
    target = Path(sys.argv[sys.argv.index("--") + 1])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    set_up(scene)
    tiles = [place_tile(case, number) for number, case in enumerate(CASES)]

    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", COLUMNS + 1
    scene.collection.objects.link(camera)
    scene.camera = camera
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.angle, sun.data.energy = 0.0, 1.0
    scene.collection.objects.link(sun)
    background = scene.world.node_tree.nodes["Background"]

    def read_tiles(view_deg: float) -> list[np.ndarray]:
        picture = render(scene)
        height, width, _ = picture.shape
        means = []
        for tile in tiles:
            at = world_to_camera_view(scene, camera, tile.location)
            # Well inside the tile, whose half is 0.45, as its middle is rounded to a pixel.
            half_y = int(0.35 * PIXELS_A_TILE)
            half_x = int(0.35 * PIXELS_A_TILE * cos(radians(view_deg)))
            x, y = int(at.x * width), int(at.y * height)
            block = picture[y - half_y : y + half_y, x - half_x : x + half_x, :3]
            means.append(block.mean(axis=(0, 1)))
        return means

    rows = []
    centre = Vector(((COLUMNS - 1) / 2, len(CASES) // COLUMNS / 2, 0.0))
    for view_deg in VIEWS_DEG:
        towards = direction(view_deg, 0)
        camera.location = centre + 20.0 * towards
        camera.rotation_euler = (0.0, radians(view_deg), 0.0)
        for light in (*SUNS_DEG, None):
            sun.hide_render = light is None
            shade = 1.0 if light is None else 0.0
            background.inputs["Color"].default_value = (shade, shade, shade, 1.0)
            set_up_cycles(scene, WORLD_SAMPLES if light is None else SUN_SAMPLES)
            if light:
                look_along(sun, -direction(*light))
            bpy.context.view_layer.update()
            for case, mean in zip(CASES, read_tiles(view_deg), strict=True):
                rows.append((case, view_deg, light, mean))

    def text(value: object) -> str:
        return "/".join(f"{v:g}" for v in value) if isinstance(value, tuple) else str(value)

    with target.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow("name type options inputs is_back view_deg light_deg r g b".split())
        for case, view_deg, light, mean in rows:
            packed = [
                "|".join(f"{k}={text(v)}" for k, v in items.items())
                for items in (case.options, case.inputs)
            ]
            writer.writerow(
                [
                    case.name,
                    case.type,
                    *packed,
                    int(case.is_back),
                    view_deg,
                    text(light) if light else "world",
                    *(f"{v:.6g}" for v in mean),
                ]
            )


main()
