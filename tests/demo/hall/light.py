"""Daylight from above by one of the HDR worlds that ship with Blender and a sun; lamps within."""

import math
from pathlib import Path

import bpy

from .charts import CHARTS, EYE_HEIGHT_M
from .patches import place
from .things import LANTERNS

SKY = "sunset.exr"


def build() -> None:
    _world()
    sun = _lamp("sun", "SUN", 5.0, (1.0, 0.90, 0.76))
    sun.angle = math.radians(0.53)
    place("sun", sun, (0, 0, 20), (math.radians(18), math.radians(27), 0))
    for x, y, z in LANTERNS:
        lamp = _lamp("lantern", "POINT", 60.0, (1.0, 0.62, 0.30))
        lamp.shadow_soft_size = 0.12
        place("lantern", lamp, (x, y, z - 0.3))
    _chart_lights()


def _world():
    folder = Path(bpy.utils.system_resource("DATAFILES")) / "studiolights" / "world"
    scene = bpy.context.scene
    scene.world = world = bpy.data.worlds.new("sky")
    if world.node_tree is None:  # before Blender 5
        world.use_nodes = True
    tree = world.node_tree
    tree.nodes.clear()
    sky = tree.nodes.new("ShaderNodeTexEnvironment")
    sky.image = bpy.data.images.load(str(folder / SKY))
    sky.image.pack()
    background = tree.nodes.new("ShaderNodeBackground")
    background.inputs["Strength"].default_value = 1.0
    output = tree.nodes.new("ShaderNodeOutputWorld")
    tree.links.new(sky.outputs["Color"], background.inputs["Color"])
    tree.links.new(background.outputs["Background"], output.inputs["Surface"])


def _lamp(name, kind, energy, color):
    lamp = bpy.data.lights.new(name, kind)
    lamp.energy, lamp.color = energy, color
    return lamp


def _chart_lights():
    """A spot for each far chart, a soft area lamp over the desk for the near ones."""
    for distance_m, right_deg, up_deg in CHARTS:
        if distance_m < 2:
            continue
        x = distance_m * math.tan(math.radians(right_deg))
        z = EYE_HEIGHT_M + distance_m * math.tan(math.radians(up_deg))
        away_m = 0.25 * distance_m
        lamp = _lamp("chart spot", "SPOT", 30.0 * away_m**2, (1.0, 0.95, 0.88))
        lamp.spot_size, lamp.spot_blend = math.radians(50), 0.5
        lamp.shadow_soft_size = 0.05
        tilt = math.radians(60)
        place(
            "chart spot",
            lamp,
            (x, distance_m - away_m * math.sin(tilt), z + away_m * math.cos(tilt)),
            (tilt, 0, 0),
        )
    desk = _lamp("desk light", "AREA", 16.0, (1.0, 0.96, 0.9))
    desk.shape, desk.size, desk.size_y = "RECTANGLE", 0.8, 0.3
    place("desk light", desk, (0, 0.1, 2.5), (math.radians(25), 0, 0))
