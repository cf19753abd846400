"""Renders one window of the open file in many ways, and times each. Runs inside Blender:

blender -b --factory-startup --addons eye_render FILE.blend --python measure.py -- FOLDER JOB

JOB: {"size_px", "rx", "pupil_mm", "pictures": [{"model", "pattern", "samples", "seed"}]} in JSON.
Each picture becomes FOLDER/NAME.npy, linear RGB; FOLDER/times.json has for each NAME what the
core's session took from start to end. The scene is exported once, and what a session prepares
before its start, the acceleration structure above all, is not counted.
"""

import json
import sys
import time
from pathlib import Path

import bpy
import eyecore
import numpy as np
from eye_render.export import export_scene
from eye_render.export.camera import frame_of, set_camera

WINDOW = (1 / 3, 2 / 3)  # of the frame's width and height


def name_of(picture: dict) -> str:
    return "{model}_{pattern}_{samples}_{seed}".format(**picture)


class TradeoffEngine(bpy.types.RenderEngine):
    """Blender hands its evaluated scene to an engine alone."""

    bl_idname = "EYE_TRADEOFF"
    bl_label = "Trade-off"
    job: dict = {}
    folder = Path()
    times: dict[str, dict] = {}

    def render(self, depsgraph):
        scene = depsgraph.scene_eval
        core_scene, _ = export_scene(depsgraph, print, lambda: None)
        set_camera(core_scene, self, depsgraph, scene.camera, frame_of(scene.render))
        pictures = self.job["pictures"]
        # Fills the texture cache and wakes the threads.
        self._render(core_scene, pictures[0] | {"samples": 1}, scene)
        for number, picture in enumerate(pictures, start=1):
            print(f"Picture {number}/{len(pictures)} {name_of(picture)}", flush=True)
            self.times[name_of(picture)] = self._render(core_scene, picture, scene)

    def _render(self, core_scene, picture: dict, scene) -> dict:
        observer = eyecore.Observer(
            model=picture["model"],
            rx=self.job["rx"],
            # The paper's eye takes a prescription as it is written, so all take it there.
            rx_plane="entrance_pupil",
            pupil=self.job["pupil_mm"],
        )
        settings = eyecore.Settings(
            samples=picture["samples"],
            seed=picture["seed"],
            pattern=picture["pattern"],
            max_bounces=scene.eye_render.max_bounces,
        )
        session = eyecore.Session(core_scene, observer, settings)
        cpu_s, wall_s = time.process_time(), time.monotonic()
        session.start()
        while not session.wait(3600):
            pass
        times = {
            "cpu_s": time.process_time() - cpu_s,  # of all threads
            "wall_s": time.monotonic() - wall_s,
        }
        if session.error:
            raise RuntimeError(session.error)
        np.save(self.folder / name_of(picture), session.snapshot()["Combined"][::-1, :, :3])
        return times


def main(folder: str, job: str) -> None:
    TradeoffEngine.job, TradeoffEngine.folder = json.loads(job), Path(folder)
    bpy.utils.register_class(TradeoffEngine)
    render = bpy.context.scene.render
    render.engine = TradeoffEngine.bl_idname
    scale = TradeoffEngine.job["size_px"] / max(render.resolution_x, render.resolution_y)
    render.resolution_x = round(render.resolution_x * scale)
    render.resolution_y = round(render.resolution_y * scale)
    render.resolution_percentage = 100
    render.use_border = render.use_crop_to_border = True
    render.border_min_x = render.border_min_y = WINDOW[0]
    render.border_max_x = render.border_max_y = WINDOW[1]
    bpy.ops.render.render()
    # Blender reports an engine's exception and goes on.
    if len(TradeoffEngine.times) < len(TradeoffEngine.job["pictures"]):
        sys.exit("Not all pictures were rendered")
    (TradeoffEngine.folder / "times.json").write_text(json.dumps(TradeoffEngine.times))


main(*sys.argv[sys.argv.index("--") + 1 :])
