"""What is said of error and time follows from the measured points, and the quality presets keep
what their descriptions promise."""

import importlib.util
import json
import math
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[1]
BUILD = Path(os.environ.get("EYE_BUILD_DIR", ROOT / "build"))
BLENDER = os.environ.get("BLENDER", "blender")
PYTHON_WITH_FLIP = BUILD / "flip/bin/python"
sys.path[:0] = [str(ROOT / "tests/tradeoff"), str(ROOT / "tests")]
from points import Point, bias_of, error_of, pareto_front, slope, time_to_reach  # noqa: E402

MODULE = {"PYTHONPATH": str(BUILD / "release/bindings")}

# The test's picture is a quarter of that of `run tradeoff` and has one seed.
MARGIN = 1.5


def point(samples: int, cpu_s: float, rmse: float) -> Point:
    return Point("paraxial", "SOBOL", samples, cpu_s, cpu_s, rmse, 0.0, rmse)


MONTE_CARLO = [point(n, 7.0 * n, 0.3 / math.sqrt(n)) for n in (1, 4, 16, 64)]


def test_pareto_front_leaves_out_what_another_beats():
    dear, cheap, beaten = point(16, 90, 0.1), point(4, 30, 0.2), point(8, 60, 0.25)
    assert pareto_front([dear, beaten, cheap]) == [cheap, dear]


def test_pareto_front_takes_the_best_of_those_that_take_equally_long():
    assert pareto_front([point(4, 30.0, 0.2), point(4, 30.9, 0.1)]) == [point(4, 30.9, 0.1)]


def test_monte_carlo_has_slope_minus_one_half():
    assert slope(MONTE_CARLO) == pytest.approx(-0.5)


def test_half_the_error_takes_four_times_as_long():
    assert time_to_reach(MONTE_CARLO, 0.3) == pytest.approx(7.0)
    assert time_to_reach(MONTE_CARLO, 0.3 / math.sqrt(2)) == pytest.approx(14.0)
    assert time_to_reach(MONTE_CARLO, 0.3 / math.sqrt(50)) == pytest.approx(350.0)


def test_an_error_below_all_points_is_not_reached():
    assert time_to_reach(MONTE_CARLO, 0.01) is None


def noisy(mean: float, seed: int) -> np.ndarray:
    return np.random.default_rng(seed).normal(mean, 0.1, (64, 64, 3))


def test_bias_is_found_below_the_noise():
    """0.02 under noise of 0.1. 12288 values give the squared bias a standard deviation of
    0.01 sqrt(2 / 12288) = 1.3e-4, which is a third of its value."""
    pictures, reference = [noisy(0.52, 1), noisy(0.52, 2)], [noisy(0.5, 3), noisy(0.5, 4)]
    assert bias_of(pictures, reference) == pytest.approx(0.02, rel=0.5)


def test_noise_alone_is_no_bias():
    assert bias_of([noisy(0.5, 1), noisy(0.5, 2)], [noisy(0.5, 3), noisy(0.5, 4)]) < 0.015


def test_the_noise_of_the_reference_is_not_counted():
    """Noise of 0.1 against a reference that is just as noisy, for each of its halves."""
    pictures, halves = [noisy(0.5, 1), noisy(0.5, 2)], [noisy(0.5, 3), noisy(0.5, 4)]
    assert error_of(pictures, halves) == pytest.approx(0.1, rel=0.03)


def choices():
    """The add-on's choices. Its package wants Blender, this file of it does not."""
    spec = importlib.util.spec_from_file_location("choices", ROOT / "addon/eye_render/choices.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def run_measurement():
    """A function that runs a program of tests/tradeoff and returns what it prints."""
    if "BLENDER_USER_SCRIPTS" not in os.environ:
        pytest.skip("the add-on is not where Blender looks; `run test` sees to that")
    if not PYTHON_WITH_FLIP.exists():
        pytest.skip("FLIP is not installed; `run test` installs it if it can")

    def run(name: str, *arguments: str, **environment: str) -> str:
        command = [PYTHON_WITH_FLIP, ROOT / "tests/tradeoff" / name, *arguments]
        result = subprocess.run(
            command, capture_output=True, text=True, env=os.environ | MODULE | environment
        )
        assert result.returncode == 0, result.stdout + result.stderr
        return result.stdout

    return run


def test_presets_keep_the_errors_that_they_promise(run_measurement):
    samples = choices().QUALITY_SAMPLES
    measured = json.loads(run_measurement("presets.py", json.dumps(samples)).splitlines()[-1])
    promised = {
        quality: [float(number) for number in re.findall(r"0\.\d+", description)]
        for quality, _, description, _ in choices().QUALITIES
        if quality in samples
    }
    assert sorted(promised) == sorted(measured)
    for quality, (rmse, flip) in promised.items():
        assert rmse / 3 < measured[quality]["rmse"] < MARGIN * rmse, (quality, measured)
        assert flip / 3 < measured[quality]["flip"] < MARGIN * flip, (quality, measured)


def test_the_quick_measurement_of_a_file_makes_table_chart_and_reading(run_measurement, tmp_path):
    scene = tmp_path / "cube.blend"
    save = f"import bpy; bpy.ops.wm.save_as_mainfile(filepath={str(scene)!r})"
    subprocess.run([BLENDER, "-b", "--factory-startup", "--python-expr", save], check=True)
    run_measurement("tradeoff.py", "--quick", str(scene), EYE_OUT_DIR=str(tmp_path))
    made = tmp_path / "tradeoff"
    assert {file.name for file in made.iterdir()} == {"points.csv", "chart.png", "reading.md"}
    reading = (made / "reading.md").read_text()
    assert "Pareto front" in reading
    assert "nan" not in reading
