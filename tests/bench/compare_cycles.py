"""Renders the demo hall by Cycles and by Eye Render in turn, same samples and bounces, and prints
how time, memory and pictures compare. `run cycles` calls this with the venv that has FLIP."""

import argparse
import json
import os
import statistics
import time
from dataclasses import asdict
from pathlib import Path

import flip_evaluator
from image_difference import compare

HERE = Path(__file__).resolve().parent
BUILD = Path(os.environ.get("EYE_BUILD_DIR", HERE.parents[1] / "build"))
ENGINES = ("CYCLES", "EYE_RENDER")
SEEDS = (1, 2)


def render(scene: Path, job: dict) -> dict:
    """Wall time and peak memory of the whole Blender process."""
    start = time.monotonic()
    command = [os.environ.get("BLENDER", "blender"), "-b", "--factory-startup"]
    command += ["--python-exit-code", "1", "--addons", "eye_render", str(scene)]
    command += ["--python", str(HERE / "render_once.py"), "--", json.dumps(job)]
    log = Path(job["exr"]).with_suffix(".log")
    with log.open("w") as output:
        to_log = [(os.POSIX_SPAWN_DUP2, output.fileno(), fd) for fd in (1, 2)]
        process = os.posix_spawnp(command[0], command, os.environ, file_actions=to_log)
        _, status, usage = os.wait4(process, 0)
    if os.waitstatus_to_exitcode(status):
        raise SystemExit(f"Blender failed; see {log}")
    seconds = time.monotonic() - start
    return {
        "seconds": seconds,
        "cpu_seconds": usage.ru_utime + usage.ru_stime,
        "samples_per_second": job["samples"] * job["size"] ** 2 / seconds,
        "peak_mb": usage.ru_maxrss / 1024,
    }


def compare_engines(scene: Path, blur: bool, arguments: argparse.Namespace) -> dict:
    runs = {engine: [] for engine in ENGINES}
    pictures = {engine: [] for engine in ENGINES}
    for seed in SEEDS:
        # Turn about, so that what else the machine does hits both.
        for engine in ENGINES if seed % 2 else ENGINES[::-1]:
            name = f"{scene.stem}_{'blur' if blur else 'sharp'}_{engine.lower()}_{seed}.exr"
            job = {
                "engine": engine,
                "blur": blur,
                "samples": arguments.samples,
                "bounces": arguments.bounces,
                "size": arguments.size,
                "seed": seed,
                "exr": str(BUILD / "cycles" / name),
            }
            runs[engine].append(render(scene, job))
            pictures[engine].append(flip_evaluator.load(job["exr"])[..., :3])
    medians = {
        engine: {
            key: statistics.median(run[key] for run in runs[engine]) for key in runs[engine][0]
        }
        for engine in ENGINES
    }
    return {"runs": medians, "difference": asdict(compare(*pictures.values()))}


def show(title: str, result: dict) -> None:
    print(f"\n{title}")
    for engine, run in result["runs"].items():
        print(
            f"  {engine:10}  {run['seconds']:8.1f} s  {run['cpu_seconds']:8.1f} CPU s"
            f"  {run['samples_per_second'] / 1e6:6.3f} M samples/s  {run['peak_mb']:6.0f} MB"
        )
    difference = result["difference"]
    print(
        f"  brightness {difference['brightness_ratio']:.4f}"
        f" ± {difference['brightness_ratio_sigma']:.4f}"
        f"  FLIP {difference['flip']:.4f} (noise {difference['flip_of_noise']:.4f})"
        f"  RMSE {difference['rmse']:.4f}"
        f"  |z| > 3: {100 * difference['z_beyond_3']:.2f} %"
        f"  sigma of z {difference['z_sigma']:.2f}",
        flush=True,
    )


def main() -> None:
    parser = argparse.ArgumentParser(prog="run cycles")
    parser.add_argument("--samples", type=int, default=64, help="per pixel (default 64)")
    parser.add_argument("--bounces", type=int, default=4, help="(default 4)")
    parser.add_argument("--size", type=int, default=512, help="pixels a side (default 512)")
    parser.add_argument("--materials", choices=("basic", "principled"), default="basic",
                        help="principled: Blender 4 and later (default basic)")  # fmt: skip
    arguments = parser.parse_args()
    (BUILD / "cycles").mkdir(parents=True, exist_ok=True)
    scene = BUILD / "demo" / f"hall_{arguments.materials}.blend"
    print(f"{scene.stem}, {arguments.size} x {arguments.size}, {arguments.samples} samples, "
          f"{arguments.bounces} bounces, {os.cpu_count()} threads")  # fmt: skip
    results = {}
    for title, blur in (("without blur", False), ("with blur", True)):
        results[title] = compare_engines(scene, blur, arguments)
        show(title, results[title])
    report = BUILD / "cycles" / f"{arguments.materials}_{arguments.samples}.json"
    report.write_text(json.dumps(vars(arguments) | results, indent=1))
    print(f"\n{report}")


if __name__ == "__main__":
    main()
