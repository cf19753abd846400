"""Renders feature scenes one after the other by one engine. Inside Blender:

blender -b --factory-startup [--addons eye_render] --python render_features.py -- JOB.json

JOB: {"engine", "glob", "only" (names, or null), "seeds", "samples" (a number, or null for the
scene's own), "folder"}. The folder receives features.json (what matches the glob), for each scene
and seed a float32 array of linear RGBA, and records.jsonl a line when a scene begins and when it
ends.
"""

import contextlib
import json
import resource
import sys
import traceback
from pathlib import Path

import bpy
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
from compositing import show_pass  # noqa: E402
from features import Feature, matching  # noqa: E402
from rendering import choose_exr, render, warnings_of_eye_render  # noqa: E402
from tools.engines import SET_UP, filter_as_usual, keep_all_light  # noqa: E402

SIZE_PX = 64


class PeakMemory:
    """The most memory that this process has had since this was made."""

    def __init__(self):
        with contextlib.suppress(OSError), open("/proc/self/clear_refs", "w") as clear:
            clear.write("5")  # starts VmHWM anew

    def mb(self) -> float:
        with contextlib.suppress(OSError), open("/proc/self/status") as status:
            for line in status:
                if line.startswith("VmHWM:"):
                    return int(line.split()[1]) / 1024
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def prepare(scene: bpy.types.Scene) -> None:
    scene.render.resolution_x = scene.render.resolution_y = SIZE_PX
    scene.render.resolution_percentage = 100
    keep_all_light(scene)
    filter_as_usual(scene)
    choose_exr(scene)


def show(feature: Feature, job: dict, folder: Path) -> dict:
    """Renders the scene with each seed; gives what to record."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    scene = bpy.context.scene
    prepare(scene)
    feature.build()
    seconds = []
    memory = PeakMemory()
    with warnings_of_eye_render() as warnings:
        for seed in job["seeds"]:
            samples = job["samples"] or feature.samples
            SET_UP[job["engine"]](scene, samples, feature.bounces, seed)
            if feature.shows_pass:
                show_pass(scene, *feature.shows_pass)
            picture = render(scene, folder / "picture.exr")
            seconds.append(picture.seconds)
            np.save(folder / f"{feature.name.replace('/', '.')}.{seed}.npy", picture.rgba)
    return {
        "seconds": sum(seconds) / len(seconds),
        "peak_mb": memory.mb(),
        "warnings": warnings,
    }


def main(job: dict) -> None:
    folder = Path(job["folder"])
    features = matching(job["glob"], bpy.app.version[:2])
    (folder / "features.json").write_text(json.dumps([f.facts() for f in features]))
    with (folder / "records.jsonl").open("a") as records:

        def record(**facts) -> None:
            print(json.dumps(facts), file=records, flush=True)

        for feature in features:
            if job["only"] is not None and feature.name not in job["only"]:
                continue
            record(begin=feature.name)
            try:
                record(end=feature.name, **show(feature, job, folder))
            except Exception as error:
                traceback.print_exc()
                record(end=feature.name, error=f"{type(error).__name__}: {error}".strip())


main(json.loads(Path(sys.argv[sys.argv.index("--") + 1]).read_text()))
