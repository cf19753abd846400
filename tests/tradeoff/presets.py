"""Measures the error of quality presets on the demo hall, small. Takes their samples as JSON and
prints their errors: {"DRAFT": 16} gives {"DRAFT": {"rmse", "flip"}}. Runs with the venv that has
FLIP."""

import json
import sys
import tempfile
from pathlib import Path

import numpy as np
from points import error_of, mean_square
from tradeoff import REFERENCE_SEEDS, render

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tools.blender import make_hall  # noqa: E402
from tools.flip import mean_flip  # noqa: E402

SIZE_PX = 96


def errors_of(samples: dict[str, int], folder: Path) -> dict[str, dict[str, float]]:
    """The largest preset is the others' reference, made of two halves."""
    *presets, largest = sorted(samples, key=samples.get)

    def asked(count: int, seed: int) -> dict:
        return {"model": "paraxial", "pattern": "SOBOL", "samples": count, "seed": seed}

    halves = [asked(samples[largest] // 2, seed) for seed in REFERENCE_SEEDS]
    rough = [asked(samples[preset], 1) for preset in presets]
    measured = render(make_hall("principled"), SIZE_PX, rough + halves, folder)
    pair = [measured.picture(half) for half in halves]
    truth = np.mean(pair, axis=0)
    pictures = {preset: measured.picture(one) for preset, one in zip(presets, rough, strict=True)}
    errors = {
        preset: {"rmse": error_of([picture], pair), "flip": mean_flip(truth, picture)}
        for preset, picture in pictures.items()
    }
    # Half the difference of two halves is the noise of their mean.
    errors[largest] = {"rmse": mean_square(*pair) ** 0.5 / 2, "flip": mean_flip(*pair) / 2}
    return errors


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        print(json.dumps(errors_of(json.loads(sys.argv[1]), Path(folder))))


if __name__ == "__main__":
    main()
