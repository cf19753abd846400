"""Renders a million triangles, and a hundred thousand instances, by Cycles and by Eye Render in
turn, and prints how long each takes until its picture is there, and in how much memory. The
pictures are small and of one sample, so that what is measured is export and build. `run large`
calls this."""

import argparse
import json
import os
import statistics
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from tools.blender import BLENDER, BUILD, is_newer, run_blender  # noqa: E402

ENGINES = ("CYCLES", "EYE_RENDER")
SCENES = {
    "triangles": "1,002,528 triangles in one smooth mesh with a UV map",
    "instances": "100,489 instances of a mesh of 4,968 triangles",
}
MAKE, RENDER = HERE / "make_large_scene.py", HERE / "render_large_scene.py"


def render(scene: Path, engine: str, folder: Path) -> dict[str, float]:
    found = folder / f"{engine.lower()}.json"
    found.unlink(missing_ok=True)
    command = [*BLENDER, "--python-exit-code", "1", "--addons", "eye_render", str(scene)]
    command += ["--python", str(RENDER), "--", engine, str(found)]
    ran = subprocess.run(command, capture_output=True, text=True, errors="replace")
    if ran.returncode:
        sys.exit(f"Blender failed on {scene}:\n{ran.stdout[-2000:]}{ran.stderr[-2000:]}")
    return json.loads(found.read_text())


def measure(name: str, repeats: int, folder: Path) -> dict[str, dict[str, float]]:
    """Medians for each engine."""
    scene = folder / f"{name}.blend"
    if not is_newer(scene, [MAKE]):
        run_blender("--python", str(MAKE), "--", name, str(scene))
    runs = {engine: [] for engine in ENGINES}
    for number in range(repeats):
        # Turn about, so that what else the machine does hits both.
        for engine in ENGINES if number % 2 else ENGINES[::-1]:
            runs[engine].append(render(scene, engine, folder))
    return {
        engine: {key: statistics.median(run[key] for run in all_runs) for key in all_runs[0]}
        for engine, all_runs in runs.items()
    }


def show(name: str, medians: dict[str, dict[str, float]]) -> None:
    print(f"\n{name}: {SCENES[name]}")
    for engine, run in medians.items():
        parts = "".join(f"  {key} {run[key]:.2f} s" for key in ("export", "build") if key in run)
        print(
            f"  {engine:10}  {run['seconds']:6.2f} s  {run['cpu_seconds']:6.2f} CPU s"
            f"  {run['memory_mb']:6.0f} MB{parts}"
        )
    ours, theirs = medians["EYE_RENDER"], medians["CYCLES"]
    ratio = {key: ours[key] / theirs[key] for key in theirs}
    print(
        f"  of Cycles': time {ratio['seconds']:.2f}, processor {ratio['cpu_seconds']:.2f},"
        f" memory {ratio['memory_mb']:.2f}",
        flush=True,
    )


def main() -> None:
    parser = argparse.ArgumentParser(prog="run large")
    parser.add_argument("--repeats", type=int, default=5, help="medians are of these (default 5)")
    arguments = parser.parse_args()
    folder = BUILD / "large"
    folder.mkdir(parents=True, exist_ok=True)
    print(f"{os.cpu_count()} threads, medians of {arguments.repeats} interleaved repeats")
    for name in SCENES:
        show(name, measure(name, arguments.repeats, folder))


if __name__ == "__main__":
    main()
