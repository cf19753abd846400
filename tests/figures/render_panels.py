"""Renders the open file through Eye Render once for each panel: FOLDER/NAME.exr with the observer
in its metadata, and NAME.png as the file's view transform shows it. Runs inside Blender:

blender -b --factory-startup --addons eye_render FILE.blend --python render_panels.py -- \
    FOLDER SIZE SAMPLES VIEWS

VIEWS: a list in JSON of dictionaries as `dataclasses.asdict(figures.View)` gives them, with the
panel's `name` and `model`.
"""

import json
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tools.picture import render_picture  # noqa: E402

BOUNCES = 2  # enough for the glass ball; more would only add noise that takes samples to go


def set_observer(camera: bpy.types.Camera, view: dict) -> None:
    observer = camera.eye_render
    observer.model = view["model"].upper()
    observer.right.text = view["rx"]
    # The paper's eye takes it as written at the pupil; this is as near as the other comes to that.
    observer.vertex_mm = 0.0
    observer.pupil_mode = "AUTO" if view["pupil_mm"] is None else "MANUAL"
    if view["pupil_mm"] is None:
        observer.pupil_formula = view["pupil_formula"]
    else:
        observer.pupil_mm = view["pupil_mm"]
    observer.focus_mode = "RELAXED" if view["looks_at_m"] is None else "DISTANCE"
    if view["looks_at_m"] is not None:
        camera.dof.focus_distance = view["looks_at_m"]


def set_light(scene: bpy.types.Scene, view: dict, sun: bpy.types.Light | None) -> None:
    """By night neither sun nor sky shines."""
    shines = 1.0 if view["daylight"] else 0.0
    for node in scene.world.node_tree.nodes if scene.world.node_tree else ():
        if node.bl_idname == "ShaderNodeBackground":
            node.inputs["Strength"].default_value = shines
    if sun is not None:
        sun.energy = shines * sun.get("energy by day", sun.energy)
    scene.eye_render.cd_m2_per_unit = view["cd_m2_per_unit"]


def main(folder: str, size_px: str, samples: str, views: str) -> None:
    scene = bpy.context.scene
    scene.render.engine = "EYE_RENDER"
    scene.render.resolution_x = scene.render.resolution_y = int(size_px)
    settings = scene.eye_render
    settings.quality, settings.samples, settings.max_bounces = "CUSTOM", int(samples), BOUNCES
    sun = next((lamp for lamp in bpy.data.lights if lamp.type == "SUN"), None)
    if sun is not None:
        sun["energy by day"] = sun.energy
    for view in json.loads(views):
        set_observer(scene.camera.data, view)
        set_light(scene, view, sun)
        settings.pupil_pattern = view["pattern"]
        print(f"Panel {view['name']}", flush=True)
        render_picture(Path(folder) / f"{view['name']}.exr")


main(*sys.argv[sys.argv.index("--") + 1 :])
