"""What state an observer's eye is rendered in: where it focuses, how its rays are found, and what
is told of both."""

import math

import eyecore
import numpy as np
import pytest
from test_extremes import wall

ABERRATED = ("wavefront", "navarro", "arizona", "le_grand")
PUPIL_MM = 6.0


def session(distance_m: float | str, model: str, pupil_mm: float = PUPIL_MM, **more):
    settings = more.pop("settings", eyecore.Settings(samples=1))
    observer = eyecore.Observer(
        model=model, pupil=pupil_mm, focus=distance_m, rx_plane="entrance_pupil", **more
    )
    return observer, eyecore.Session(wall(1.0), observer, settings)


@pytest.mark.parametrize("more", [{}, {"correction": "glasses", "worn": "-2.00DS"}])
@pytest.mark.parametrize("model", ABERRATED)
def test_an_eye_with_aberrations_accommodates_to_the_least_spot(model: str, more: dict) -> None:
    observer, looking = session(0.4, model, exact_trace=True, **more)
    chosen_d = looking.accommodation_d

    def rms_arcmin(accommodation_d: float) -> float:
        eye = eyecore.observer_eye(observer, PUPIL_MM, accommodation_d)
        return eye.spot_ellipse(0.4, samples=2048).rms_radius_arcmin

    for other_d in (chosen_d - 0.1, chosen_d + 0.1):
        if other_d >= 0.0:
            assert rms_arcmin(chosen_d) <= rms_arcmin(other_d)


@pytest.mark.parametrize("model", ["paraxial", "paper"])
def test_an_eye_without_aberrations_accommodates_to_its_mean_error(model: str) -> None:
    _, looking = session(0.4, model, rx="-1.00DS -1.00DC 30A")
    assert looking.accommodation_d == pytest.approx(2.5 - 1.5, abs=1e-12)
    assert looking.warnings == []


def test_what_aberrations_leave_to_be_wanted_is_told() -> None:
    _, near = session(0.1, "wavefront", age_years=50)  # 3.5 D
    assert near.accommodation_d == 3.5
    (told,) = near.warnings
    assert told.startswith("focus: seeing sharply at 0.1 m takes ")
    needed_d = float(told.split("takes ")[1].split(" D")[0])
    eye = eyecore.Eye(
        model="wavefront", pupil_mm=PUPIL_MM, wavefront=eyecore.Wavefront.population(6.0)
    )
    assert needed_d == pytest.approx(10.0 - eye.best_focus_d, abs=0.02)

    _, far = session(math.inf, "wavefront", rx="-2.00DS")
    assert far.accommodation_d == 0.0
    (told,) = far.warnings
    assert told.startswith("focus: what lies far away is beyond the far point; the relaxed eye is")


@pytest.mark.parametrize("model", eyecore.EYE_MODELS)
def test_far_point_is_that_of_the_clear_range(model: str) -> None:
    more = {"wavefront": eyecore.Wavefront.population(PUPIL_MM)} if model == "wavefront" else {}
    eye = eyecore.Eye(
        model=model, rx="-2.00DS -1.00DC 30A", rx_plane="entrance_pupil", pupil_mm=PUPIL_MM, **more
    )
    far_d = eyecore.clear_ranges(eye, eye)[0].far_d
    assert 1.0 / eye.far_point_m == pytest.approx(far_d, abs=1e-12)
    paraxial_d = np.trace(eye.retinal_conjugate_d) / 2.0
    if model in ABERRATED:
        assert abs(far_d - paraxial_d) > 0.1
    elif model != "paper":
        assert far_d == pytest.approx(paraxial_d, abs=1e-9)


def test_a_closed_pupils_far_point_is_its_paraxial_one() -> None:
    eye = eyecore.Eye(rx="-2.00DS", rx_plane="entrance_pupil", pupil_mm=0.0)
    assert eye.far_point_m == pytest.approx(0.5)


def test_an_eye_that_no_fit_does_right_is_told_to_be_traced_exactly() -> None:
    # Its focus at 0.15 m takes the conics of its lens to where the fit gives up.
    _, exact = session(0.15, "arizona", 8.0, age_years=10)
    assert exact.facts["exact_trace"] == "yes"
    assert exact.facts["trace"] == exact.metadata["trace"] == "exact: no fit within 0.02 arcmin"
    assert "fit_residual_arcmin" not in exact.facts
    assert any("no fit within 0.02 arcmin was found" in told for told in exact.warnings)

    _, asked = session(0.15, "arizona", 8.0, age_years=10, exact_trace=True)
    assert asked.facts["trace"] == "exact" and asked.facts["exact_trace"] == "yes"
    assert "fit_residual_arcmin" not in asked.facts
    assert not any("no fit" in told for told in asked.warnings)

    _, fitted = session(math.inf, "arizona", 4.0)
    assert fitted.facts["trace"] == "fitted over 40 degrees"
    assert fitted.facts["exact_trace"] == "no"
    assert 0.0 < fitted.facts["fit_residual_arcmin"] <= 0.02


def test_stiles_crawford_beyond_what_was_measured_is_told() -> None:
    on = eyecore.Settings(samples=1, stiles_crawford="BRIGHTNESS")
    for pupil_mm, mode, is_told in ((6.0, on, False), (6.5, on, True), (6.5, None, False)):
        settings = mode or eyecore.Settings(samples=1)
        _, looking = session("relaxed", "paraxial", pupil_mm, settings=settings)
        assert any("Stiles-Crawford" in told for told in looking.warnings) == is_told


def test_a_wavefront_is_told_as_python_writes_it() -> None:
    wavefront = eyecore.Wavefront([0.0] * 6 + [0.1], PUPIL_MM)
    _, looking = session("relaxed", "wavefront", wavefront=wavefront)
    assert looking.facts["wavefront"] == repr(wavefront)


@pytest.mark.parametrize(
    ("slope", "point_m", "nm", "sentence"),
    [
        ([np.nan, 0.0], [0.0, 0.0], 555.0, "chief_slope is nan; expected a finite number"),
        ([0.0, np.inf], [0.0, 0.0], 555.0, "chief_slope is inf; expected a finite number"),
        ([0.0, 0.0], [0.0, np.nan], 555.0, "pupil_point_m is nan; expected a finite number"),
        ([0.0, 0.0], [0.0, 2.1e-3], 555.0, "pupil_point_m is 0.0021 m from the centre; expected"),
        ([0.0, 0.0], [0.0, 0.0], np.nan, "wavelength_nm is nan nm; expected 380 to 780 nm"),
        ([0.0, 0.0], [0.0, 0.0], 379.0, "wavelength_nm is 379 nm; expected 380 to 780 nm"),
        ([0.0, 0.0], [0.0, 0.0], 781.0, "wavelength_nm is 781 nm; expected 380 to 780 nm"),
    ],
)
def test_rays_that_cannot_be_are_refused(slope, point_m, nm: float, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        eyecore.Eye(pupil_mm=4.0).rays([slope], [point_m], nm)


def test_rays_on_the_pupils_edge_are_not_refused() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 1000)
    edge_m = 2e-3 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    weight = eyecore.Eye(pupil_mm=4.0).rays(np.zeros((1000, 2)), edge_m)[2]
    assert (weight == 1.0).all()


def test_a_lost_ray_says_what_became_of_it() -> None:
    assert eyecore.RAY_FATES == ["transmitted", "vignetted", "missed", "total_reflection"]
    eye = eyecore.Eye(model="navarro", pupil_mm=8.0, exact_trace=True)
    slope = math.tan(math.radians(75.0))
    points_m = np.stack([np.linspace(-4e-3, 4e-3, 101), np.zeros(101)], axis=1)
    _, _, weight, fate = eye.rays([[slope, 0.0]] * 101, points_m)
    assert fate.dtype == np.uint8
    assert ((fate == 0) == (weight == 1.0)).all()
    assert 0 < np.count_nonzero(fate) < 101
