"""Renders the open scene by one engine. Inside Blender, after the file is loaded:

blender -b --factory-startup --addons eye_render FILE.blend --python render_file.py -- JOB.json

JOB: {"engine", "samples", "bounces", "size", "seeds", "folder"}. The folder receives a float32
array of linear RGBA for each seed, and found.json: seconds of one render, warnings.
"""

import json
import sys
from pathlib import Path

import bpy
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent), str(HERE.parent / "models")]
import framing  # noqa: E402
from rendering import choose_exr, render, warnings_of_eye_render  # noqa: E402
from tools.engines import SET_UP, keep_all_light  # noqa: E402


def main(job: dict) -> None:
    scene = bpy.context.scene
    folder = Path(job["folder"])
    if scene.camera is None:
        _, corners = framing.geometry()
        framing.choose_camera(scene, corners)
    keep_all_light(scene)
    # The eye's pinhole has no depth of field, and what moves is told apart by scenes of its own.
    scene.camera.data.dof.use_dof = False
    scene.render.use_motion_blur = False
    settings = scene.render
    longer = max(settings.resolution_x, settings.resolution_y)
    settings.resolution_x = round(settings.resolution_x * job["size"] / longer)
    settings.resolution_y = round(settings.resolution_y * job["size"] / longer)
    settings.resolution_percentage = 100
    settings.use_compositing = settings.use_sequencer = settings.use_multiview = False
    choose_exr(scene)
    seconds = []
    with warnings_of_eye_render() as warnings:
        for seed in job["seeds"]:
            SET_UP[job["engine"]](scene, job["samples"], job["bounces"], seed)
            picture = render(scene, folder / "picture.exr")
            seconds.append(picture.seconds)
            np.save(folder / f"{job['engine']}.{seed}.npy", picture.rgba)
    found = {"seconds": sum(seconds) / len(seconds), "warnings": warnings}
    (folder / "found.json").write_text(json.dumps(found))


main(json.loads(Path(sys.argv[-1]).read_text()))
