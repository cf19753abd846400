"""Measures error against time for samples, pupil pattern and eye model, on the demo hall or on a
file, and writes out/tradeoff: points.csv, chart.png and reading.md. `run tradeoff` calls this with
the venv that has FLIP."""

import argparse
import csv
import json
import os
import sys
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

import eyecore
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from chart import draw_chart  # noqa: E402
from points import APPROXIMATES, Point, bias_of, error_of, mean_square  # noqa: E402
from reading import Setting, write_reading  # noqa: E402
from tools.blender import OUT, make_hall, run_blender  # noqa: E402
from tools.flip import mean_flip  # noqa: E402

# A myope with astigmatism: most of the window is blurred over several pixels.
RX, PUPIL_MM = "-4.50DS -1.50DC 30A", 4.0
REFERENCE_SEEDS = (1001, 1002)  # two halves, so that the reference's own noise is known
EVERY_PATTERN = {"paper", "paraxial"}  # of the others the pattern's effect is the same


@dataclass
class Effort:
    size_px: int
    samples: tuple[int, ...]
    seeds: tuple[int, ...]
    reference_samples: dict[str, int]  # for each half, by model; "" for what is not named


DEFAULT = Effort(144, (1, 4, 16, 64, 256), (1, 2), {"paraxial": 2048, "": 512})
QUICK = Effort(64, (1, 4, 16), (1, 2), {"": 64})


def pictures_of(effort: Effort, models: list[str]) -> list[dict]:
    """All to be rendered. Repeats of one configuration are far apart, so that what else the
    machine does at one time hits one of them alone."""
    measured = [
        {"model": model, "pattern": pattern, "samples": samples, "seed": seed}
        for seed in effort.seeds
        for samples in effort.samples
        for model in models
        for pattern in (eyecore.PUPIL_PATTERNS if model in EVERY_PATTERN else ["SOBOL"])
    ]
    return measured + [
        picture for model in models if model not in APPROXIMATES
        for picture in reference_of(effort, model)
    ]  # fmt: skip


def reference_of(effort: Effort, model: str) -> list[dict]:
    samples = effort.reference_samples.get(model, effort.reference_samples[""])
    return [
        {"model": model, "pattern": "SOBOL", "samples": samples, "seed": seed}
        for seed in REFERENCE_SEEDS
    ]


class Measured:
    """Pictures and times by what was asked for."""

    def __init__(self, folder: Path):
        self._folder = folder
        self._times = json.loads((folder / "times.json").read_text())

    def picture(self, asked: dict) -> np.ndarray:
        return np.load(self._folder / f"{_name(asked)}.npy")

    def median_s(self, asked: list[dict], clock: str) -> float:
        return float(np.median([self._times[_name(one)][clock] for one in asked]))


def _name(asked: dict) -> str:
    return "{model}_{pattern}_{samples}_{seed}".format(**asked)


def points_of(effort: Effort, models: list[str], measured: Measured) -> list[Point]:
    references = {
        model: [measured.picture(half) for half in reference_of(effort, model)]
        for model in models
        if model not in APPROXIMATES
    }
    repeats: dict[tuple, list[dict]] = {}
    for asked in pictures_of(effort, models):
        if asked["seed"] in effort.seeds:
            key = (asked["model"], asked["pattern"], asked["samples"])
            repeats.setdefault(key, []).append(asked)
    points = []
    for (model, pattern, samples), asked in repeats.items():
        halves = references[APPROXIMATES.get(model, model)]
        truth = np.mean(halves, axis=0)
        pictures = [measured.picture(one) for one in asked]
        per_mpx = 1e6 / truth[..., 0].size
        points.append(
            Point(
                model,
                pattern,
                samples,
                measured.median_s(asked, "cpu_s") * per_mpx,
                measured.median_s(asked, "wall_s") * per_mpx,
                error_of(pictures, halves),
                bias_of(pictures, halves),
                float(np.mean([mean_flip(truth, picture) for picture in pictures])),
            )
        )
    return points


def setting_of(effort: Effort, scene: Path, measured: Measured) -> Setting:
    asked = reference_of(effort, "paraxial")
    halves = [measured.picture(half) for half in asked]
    height, width, _ = halves[0].shape
    return Setting(
        scene=scene.name,
        rx=RX,
        pupil_mm=PUPIL_MM,
        window_px=(width, height),
        frame_px=effort.size_px,
        processors=os.cpu_count() or 1,
        repeats=len(effort.seeds),
        reference_samples=2 * asked[0]["samples"],
        reference_cpu_s_per_mpx=2 * measured.median_s(asked, "cpu_s") * 1e6 / (width * height),
        # Half the difference of two halves is the noise of their mean.
        reference_rmse=float(np.sqrt(mean_square(*halves))) / 2,
        reference_flip=mean_flip(*halves) / 2,
    )


def render(scene: Path, size_px: int, pictures: list[dict], folder: Path) -> Measured:
    def show(line: str) -> None:
        if line.startswith("Picture ") and sys.stdout.isatty():
            print(f"\r{line.rstrip():60}", end="", flush=True)

    job = {"size_px": size_px, "rx": RX, "pupil_mm": PUPIL_MM, "pictures": pictures}
    script = str(HERE / "measure.py")
    run_blender("--addons", "eye_render", str(scene), "--python", script, "--",
                str(folder), json.dumps(job), on_line=show)  # fmt: skip
    return Measured(folder)


def write_csv(points: list[Point], path: Path) -> None:
    with path.open("w", newline="") as file:
        table = csv.DictWriter(file, list(asdict(points[0])) + ["reference"])
        table.writeheader()
        for point in points:
            table.writerow(asdict(point) | {"reference": point.reference})


def main() -> None:
    parser = argparse.ArgumentParser(prog="run tradeoff")
    parser.add_argument("scene", nargs="?", type=Path, metavar="FILE.blend",
                        help="default: the demo hall")  # fmt: skip
    parser.add_argument("--quick", action="store_true", help="small and rough, for tests")
    arguments = parser.parse_args()
    scene = arguments.scene or make_hall("principled")
    effort = QUICK if arguments.quick else DEFAULT
    models = list(eyecore.EYE_MODELS)
    with tempfile.TemporaryDirectory() as folder:
        measured = render(scene, effort.size_px, pictures_of(effort, models), Path(folder))
        points = points_of(effort, models, measured)
        setting = setting_of(effort, scene, measured)
    out = OUT / "tradeoff"
    out.mkdir(parents=True, exist_ok=True)
    write_csv(points, out / "points.csv")
    draw_chart(points, setting, out / "chart.png")
    print(write_reading(points, setting, out / "reading.md"))
    print(*sorted(out.iterdir()), sep="\n")


if __name__ == "__main__":
    main()
