"""The feature scenes are as near to Cycles as each of them must be, in a quick form; and what
`run compare` says follows from the pictures."""

import math
import os
import struct
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests/compare"), str(ROOT / "tests")]
import deviations  # noqa: E402
import references  # noqa: E402
from blender_batch import Rendered, blender_version, render_features  # noqa: E402
from compare_files import noise_of_means  # noqa: E402
from measure import Difference, excess_rmse, measure  # noqa: E402
from page import EXPECTED, FAILED, PASSED, png  # noqa: E402
from picture import as_seen  # noqa: E402
from tools.display import LUMINANCE  # noqa: E402
from verdict import difference_of, row_of  # noqa: E402

SAMPLES = 48  # per pixel; a quick picture is told from its noise by blocks of pixels
SEED = 7
# Clamped light, and quotients: what few samples give is not what many do, in the mean. And light
# below a surface as Burley spreads it: rare and bright, so that few samples hide their own noise.
# These are rendered with samples of their own.
OWN_SAMPLES = ["film/clamp_direct", "passes/diffuse_direct", "passes/diffuse_indirect",
               "passes/glossy_direct", "passes/glossy_indirect", "passes/shadow_catcher",
               "principled/subsurface_burley"]  # fmt: skip

STORED = sorted(path.stem for path in references.FOLDER.glob("*.npz"))
NOISE = np.random.default_rng(3)


def noisy(value: float, sigma: float) -> np.ndarray:
    return NOISE.normal(value, sigma, (64, 64, 3)).astype(np.float32)


# --- the suite -----------------------------------------------------------------------------


@pytest.fixture(scope="session")
def quick(tmp_path_factory) -> dict[str, Rendered]:
    """Every feature scene in the Blender of the user."""
    if "BLENDER_USER_SCRIPTS" not in os.environ:
        pytest.skip("no scripts folder with the add-on; `run test` makes one")
    folder = tmp_path_factory.mktemp("features")
    few = render_features("EYE_RENDER", "*", [SEED], folder, SAMPLES)
    own = render_features("EYE_RENDER", "*", [SEED], folder / "own", None, OWN_SAMPLES)
    return few | own


@pytest.fixture(scope="session")
def version() -> tuple[int, ...]:
    return blender_version()


@pytest.mark.parametrize("stem", STORED)
def test_scene_is_as_near_to_cycles_as_it_must_be(quick, version, stem):
    name = stem.replace(".", "/", 1)
    if name not in quick:
        pytest.skip("this Blender does not have the feature")
    rendered = quick[name]
    assert rendered.error == ""
    picture = as_seen(rendered.pictures[0], rendered.facts["view"])
    samples = rendered.facts["samples"] if name in OWN_SAMPLES else SAMPLES
    found = difference_of(references.load(references.path_of(name)), picture, samples)
    found.flip = math.nan  # of few samples it is noise
    expected = deviations.expected_of(rendered.facts, version)
    assert expected.is_near(found), f"{found} for {expected}; {rendered.warnings}"


def test_what_an_eye_cannot_see_is_refused(quick):
    refused = {name: found for name, found in quick.items() if found.facts["refused"]}
    assert refused and all(found.facts["refused"] in found.error for found in refused.values())


def test_every_scene_that_is_rendered_has_a_reference(quick):
    shown = {name for name, rendered in quick.items() if not rendered.facts["refused"]}
    assert {name.replace("/", ".") for name in shown} <= set(STORED)


def test_what_is_known_to_be_off_has_a_reason(quick):
    for name, blender in deviations.load():
        if name in quick:
            assert deviations.reason_of(quick[name].facts, blender), name


# --- what is said of pictures ---------------------------------------------------------------


def test_equal_pictures_do_not_differ():
    picture = noisy(0.5, 0.1)
    found = measure(picture, picture)
    assert (found.rmse, found.block_rmse, found.brightness_ratio) == (0.0, 0.0, 1.0)


def test_noise_alone_is_no_excess():
    sigma, samples = np.full((64, 64), 0.01), 1024
    one_sample = 0.01 * np.sqrt(samples)
    reference, picture = noisy(0.5, 0.01), noisy(0.5, one_sample / np.sqrt(256))
    # Three channels are as noisy as their luminance here, so nothing is left but its own error.
    assert excess_rmse(reference, sigma, samples, picture, 256) < 0.003


def test_files_are_allowed_the_noise_of_their_means():
    """So an engine that is much noisier than Cycles fails."""
    cycles, ours, noisier = ([noisy(0.4, sigma) for _ in range(2)] for sigma in (0.1, 0.1, 0.4))
    allowed_noise = noise_of_means(*cycles)
    mean = np.mean(cycles, axis=0)
    assert measure(mean, np.mean(ours, axis=0)).figure() == pytest.approx(allowed_noise, rel=0.15)
    assert measure(mean, np.mean(noisier, axis=0)).figure() > 1.5 * allowed_noise


def test_a_darker_half_is_excess():
    reference = np.full((64, 64, 3), 0.5, np.float32)
    picture = reference.copy()
    picture[:32] *= 0.8
    assert excess_rmse(reference, np.zeros((64, 64)), 1024, picture, 256) > 0.03


def test_references_survive_their_file(tmp_path):
    batches = [noisy(0.3, 0.05) * np.array([1, 4, -0.2], np.float32) for _ in range(4)]
    made = references.of_batches(batches, 64, 0.01, "Blender 4.3")
    references.save(tmp_path / "x.npz", made)
    read = references.load(tmp_path / "x.npz")
    # Eight binary digits, rounded; a byte of eight steps for a factor of two, rounded up.
    np.testing.assert_allclose(read.mean, made.mean, rtol=2**-8 + 2**-11)
    np.testing.assert_array_less(made.sigma, read.sigma * 1.0001)
    np.testing.assert_array_less(read.sigma, made.sigma * 2 ** (1 / 8) * 1.0001)
    assert (read.samples, read.noise, read.blender) == (256, 0.01, "Blender 4.3")


def test_sigma_is_the_standard_error_of_the_mean():
    batches = [noisy(0.5, 0.04) for _ in range(16)]
    sigma = references.of_batches(batches, 64, 0.0, "").sigma
    luminance_sigma = 0.04 * np.linalg.norm(LUMINANCE) / np.sqrt(16)
    assert np.sqrt(np.mean(sigma**2)) == pytest.approx(luminance_sigma, rel=0.05)


FACTS = {"name": "lights/point", "about": "", "view": "COLOR", "samples": 64, "differs": "",
         "before_4": "", "refused": ""}  # fmt: skip


def row_with(monkeypatch, tmp_path, brightness: float, error: str = "", **facts):
    """The row of a grey picture beside a reference that is as bright as it, times `brightness`;
    half as bright is what is recorded."""
    monkeypatch.setattr(references, "FOLDER", tmp_path)
    monkeypatch.setattr(deviations, "FILE", tmp_path / "deviations.csv")
    known = "".join(f"lights/point,{blender},0.384,0.1485\n" for blender in ("any", "before 4.0"))
    deviations.FILE.write_text(f"scene,blender,flip,excess_rmse\n{known}")
    grey = np.full((64, 64, 3), 0.25, np.float32)
    made = references.of_batches([grey, grey], 64, 0.0, "")
    references.save(references.path_of("lights/point"), made)
    rgba = np.dstack([grey * brightness, np.ones((64, 64), np.float32)])
    return row_of(Rendered(FACTS | facts, pictures=[rgba], error=error), (3, 4, 1))


def test_equal_picture_passes(monkeypatch, tmp_path):
    assert row_with(monkeypatch, tmp_path, 1.0).outcome == PASSED


def test_darker_picture_fails(monkeypatch, tmp_path):
    row = row_with(monkeypatch, tmp_path, 0.5)
    assert row.outcome == FAILED
    assert row.difference.brightness_ratio == pytest.approx(0.5, rel=0.01)


@pytest.mark.parametrize("kind", ["differs", "before_4"])
def test_what_is_known_to_differ_is_told_apart(monkeypatch, tmp_path, kind):
    row = row_with(monkeypatch, tmp_path, 0.5, **{kind: "for a reason"})
    assert (row.outcome, row.reason) == (EXPECTED, "for a reason")


@pytest.mark.parametrize("brightness", [0.45, 0.55])
def test_what_is_known_to_differ_fails_further_off_and_nearer(monkeypatch, tmp_path, brightness):
    row = row_with(monkeypatch, tmp_path, brightness, differs="for a reason")
    assert row.outcome == FAILED


def test_what_must_be_refused_must_not_be_rendered(monkeypatch, tmp_path):
    refused = {"refused": "no such lens"}
    assert row_with(monkeypatch, tmp_path, 1.0, **refused).outcome == FAILED
    assert row_with(monkeypatch, tmp_path, 1.0, "it died", **refused).outcome == FAILED
    assert row_with(monkeypatch, tmp_path, 1.0, "no such lens", **refused).outcome == EXPECTED


def test_what_is_off_is_recorded_and_no_longer_off_is_forgotten(monkeypatch, tmp_path):
    row_with(monkeypatch, tmp_path, 1.0)
    off, as_cycles = (Difference(x, x, x, 1.0, x) for x in (0.5, 0.001))
    deviations.record({"lights/point": as_cycles}, {"lights/point": FACTS}, (4, 3, 2))
    assert list(deviations.load()) == [("lights/point", "before 4.0")]
    deviations.record({"lights/point": off}, {"lights/point": FACTS}, (4, 3, 2))
    assert deviations.load()["lights/point", "any"] == (0.5, 0.5)


def test_png_holds_the_picture():
    rgb = NOISE.integers(0, 255, (3, 5, 3)).astype(np.uint8)
    data = png(rgb)
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    assert struct.unpack(">II", data[16:24]) == (5, 3)
    start = data.index(b"IDAT") + 4
    rows = zlib.decompress(data[start : data.index(b"IEND") - 8])
    assert b"".join(rows[i * 16 + 1 : i * 16 + 16] for i in range(3)) == rgb.tobytes()
