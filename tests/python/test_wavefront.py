"""Wavefronts in plain Python, and the eyes that have them."""

import eyecore
import numpy as np
import pytest

POINTS_M = [[0.001, 0.0], [-0.0005, 0.0019]]


def test_population_is_published_and_mirrored() -> None:
    right = eyecore.Wavefront.population(6.0)
    left = eyecore.Wavefront.population(6.0, eye="OS")
    assert right.pupil_mm == 6.0
    assert right.wavelength_nm == 633.0
    assert right.coefficients_um[12] == pytest.approx(0.0942)
    assert left.coefficients_um[8] == -right.coefficients_um[8] != 0
    assert left.coefficients_um[12] == right.coefficients_um[12]


def test_rescaling_keeps_the_eye_and_lowers_the_rms() -> None:
    wide = eyecore.Wavefront.population(6.0)
    narrow = wide.rescaled(4.0)
    assert narrow.pupil_mm == 4.0
    assert narrow.rms_um < wide.rms_um == pytest.approx(0.104, abs=0.001)
    slopes = [
        eyecore.Eye(model="wavefront", wavefront=wavefront).rays(np.zeros((2, 2)), POINTS_M)[1]
        for wavefront in (wide, narrow)
    ]
    assert slopes[0] == pytest.approx(slopes[1], abs=1e-15)


def test_an_eye_needs_its_wavefront_and_no_wider_pupil() -> None:
    with pytest.raises(ValueError, match="wavefront is missing; expected one for"):
        eyecore.Eye(model="wavefront")
    with pytest.raises(
        ValueError, match="pupil_mm is 4 mm; expected at most the wavefront's 3 mm"
    ):
        eyecore.Eye(model="wavefront", wavefront=eyecore.Wavefront.population(3.0), pupil_mm=4.0)
    with pytest.raises(
        ValueError, match="pupil_mm is 4 mm; expected at most the wavefront's 3 mm"
    ):
        eyecore.Wavefront([], 3.0).rescaled(4.0)


def test_a_measured_myope_is_corrected_by_its_own_prescription() -> None:
    # 4 sqrt(3) c / r^2: 3.6084 um over 5 mm are -4 D.
    wavefront = eyecore.Wavefront([0, 0, 0, 0, 3.6084391824351614], 5.0)
    rx = wavefront.rx()
    assert rx.sphere_d == pytest.approx(-4.0)
    eye = eyecore.Eye(model="wavefront", rx=rx, rx_plane="entrance_pupil", wavefront=wavefront)
    assert eye.far_point_m == pytest.approx(0.25)


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: eyecore.Wavefront([0.0] * 29, 6.0), "has 29 coefficients; expected up to 28"),
        (lambda: eyecore.Wavefront([float("nan")], 6.0), "coefficient 0 is nan um; expected"),
        (lambda: eyecore.Wavefront([], 11.0), "pupil_mm is 11 mm; expected 1 to 10 mm"),
        (
            lambda: eyecore.Wavefront([], 6.0, 1200.0),
            "wavelength_nm is 1200 nm; expected 380 to 1100 nm",
        ),
        (lambda: eyecore.Wavefront.population(8.0), "wavefront is 8 mm; expected 1 to 7.5 mm"),
        (lambda: eyecore.Wavefront.population(6.0, eye="L"), "eye is 'L'; expected one of OD, OS"),
    ],
)
def test_refusals_name_value_and_what_is_allowed(call, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        call()


def test_repr_is_what_makes_it() -> None:
    wavefront = eyecore.Wavefront([0, 0.5, -0.25], 6.0, 633.0)
    assert repr(wavefront) == "Wavefront([0, 0.5, -0.25], pupil_mm=6, wavelength_nm=633)"
    assert "wavefront=Wavefront(" in repr(
        eyecore.Observer(model="wavefront", wavefront=wavefront, pupil=4)
    )


def test_spherical_aberration_blurs_a_point_that_the_prescription_has_in_focus() -> None:
    scene = eyecore.Scene()
    # A dark square edge to edge with a bright world behind it, far away, under a pupil of 6 mm.
    dark = scene.add_material("dark")
    quad = np.array([[-1, -1, 0], [0, -1, 0], [0, 1, 0], [-1, 1, 0]], np.float32) * 1e4
    at = np.eye(4)
    at[2, 3] = -1e3
    triangles = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)
    scene.add_instances(scene.add_mesh("edge", quad, triangles), at[None], [dark])
    scene.set_world((1.0, 1.0, 1.0))
    # 16 pixels of half an arc minute across.
    half = 8 * 0.5 / 3437.75
    scene.set_camera(np.eye(4), (-half, half, -half / 8, half / 8), (16, 2), clip=(0.01, 1e9))

    def rows(model: str) -> np.ndarray:
        observer = eyecore.Observer(
            model=model, pupil=6, wavefront=eyecore.Wavefront.population(6.0)
        )
        settings = eyecore.Settings(samples=256, filter_width_px=0.1)
        return eyecore.render(scene, observer, settings)["Combined"][:, :, 0].mean(axis=0)

    sharp = rows("paraxial")
    blurred = rows("wavefront")
    assert sharp == pytest.approx(np.repeat([0.0, 1.0], 8), abs=0.15)
    assert blurred[6] > 0.05
    assert blurred[9] < 0.95
