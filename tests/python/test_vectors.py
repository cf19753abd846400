"""Published and derived numbers of tests/data/optics_vectors.json through the Python module."""

import json
from pathlib import Path

import eyecore
import pytest

_FILE = json.loads((Path(__file__).parents[1] / "data" / "optics_vectors.json").read_text())


def vectors(kind: str) -> list:
    found = [case for case in _FILE["cases"] if case["kind"] == kind]
    assert found
    return [pytest.param(case["input"], case["expect"], id=case["id"]) for case in found]


def near(expected: float) -> object:
    return pytest.approx(expected, rel=_FILE["tolerance_rel"], abs=1e-12)


def rx_of(numbers: dict) -> eyecore.Prescription:
    return eyecore.Prescription(numbers["S"], numbers["C"], numbers["axis"])


@pytest.mark.parametrize(("given", "expected"), vectors("meridional_power"))
def test_power_along_and_across_a_meridian(given: dict, expected: dict) -> None:
    curvital, torsional = rx_of(given).meridional_power(given["meridian"])
    assert curvital == near(expected["curvital"])
    assert torsional == near(expected["torsional"])


@pytest.mark.parametrize(("given", "expected"), vectors("add_crossed_cylinders_minus_form"))
def test_crossed_cylinders_add(given: dict, expected: dict) -> None:
    first, *rest = (eyecore.Prescription(*numbers) for numbers in given["rx"])
    for rx in rest:
        first = first.crossed(rx)
    # In either form of the cylinder.
    sums = [
        (rx.sphere_d, rx.cylinder_d, rx.axis_deg % 180.0) for rx in (first, first.transposed())
    ]
    wanted = tuple(near(number) for number in (expected["S"], expected["C"], expected["axis"]))
    assert any(found == wanted for found in sums)


@pytest.mark.parametrize(("given", "expected"), vectors("rx_to_zernike"))
def test_the_wavefront_that_a_lens_corrects(given: dict, expected: dict) -> None:
    pupil_mm = 2.0 * given["pupil_radius_mm"]
    wavefront = eyecore.Wavefront.corrected_by(rx_of(given), pupil_mm)
    # OSA indices 3 to 5.
    oblique, defocus, straight = wavefront.coefficients_um[3:]
    assert defocus == near(expected["c20_um"])
    assert straight == near(expected["c22_um"])
    assert oblique == near(expected["c2m2_um"])
    assert wavefront.pupil_mm == pytest.approx(pupil_mm)
    assert wavefront.rx().power_vector() == pytest.approx(rx_of(given).power_vector(), abs=1e-12)


@pytest.mark.parametrize(("given", "expected"), vectors("clear_lines_4mm"))
def test_lines_are_as_clear_as_the_clock_dial_says(given: dict, expected: dict) -> None:
    eye = eyecore.Eye(
        rx=rx_of(given),
        rx_plane="entrance_pupil",
        pupil_mm=4.0,
        accommodation_d=given["accommodation_D"],
    )
    distance_m = float("inf") if given["object_m"] is None else given["object_m"]
    for line_deg, name in ((0.0, "horizontal_line"), (90.0, "vertical_line")):
        spread = eye.line_spread_arcmin(line_deg, distance_m)
        assert spread == near(expected[name + "_rms_arcmin"])
