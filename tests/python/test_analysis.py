"""What eyecore.Eye says of a point: arrays and units; the optics itself is tested in C++."""

import eyecore
import numpy as np
import pytest

INFINITY = float("inf")


def eye(rx: str = "-2.00DS -0.75DC 160A", **rest) -> eyecore.Eye:
    return eyecore.Eye(rx=rx, **{"pupil_mm": 4.0, **rest})


def second_moments(image: np.ndarray, size_arcmin: float) -> np.ndarray:
    """((xx, xy), (xy, yy)) in arcmin^2 about the centre, +Y up."""
    axis = (np.arange(len(image)) + 0.5 - len(image) / 2) * size_arcmin / len(image)
    x, y = np.meshgrid(axis, axis)
    xy = (image * x * y).sum()
    return np.array([[(image * x * x).sum(), xy], [xy, (image * y * y).sum()]])


def test_spot_psf_and_ellipse_are_one_blur() -> None:
    """Axis 160 is seen at 20 degrees, and the streak lies across it, at 110."""
    ellipse = eye().blur_ellipse()
    angle = np.radians(ellipse.angle_deg)
    assert ellipse.angle_deg == pytest.approx(110.0)
    across = np.array([np.cos(angle), np.sin(angle)])
    variances = np.array([ellipse.major_arcmin, ellipse.minor_arcmin]) ** 2 / 16

    points, weights = eye().spot(samples=1 << 14)
    assert points.shape == (1 << 14, 2) and weights.shape == (1 << 14,)
    spot = np.cov(points.T, aweights=weights)
    assert across @ spot @ across == pytest.approx(variances[0], rel=0.01)
    assert np.linalg.eigvalsh(spot)[::-1] == pytest.approx(variances, rel=0.01)

    # Spreading each ray over a pixel adds a sixth of its square.
    psf = eye().psf(size_arcmin=50.0, resolution=100)
    image = second_moments(psf, 50.0) - np.eye(2) * 0.5**2 / 6
    assert image == pytest.approx(spot, abs=0.02 * variances[0])

    sampled = eye().spot_ellipse()
    assert sampled.major_arcmin == pytest.approx(ellipse.major_arcmin, rel=1e-3)
    assert sampled.angle_deg == pytest.approx(ellipse.angle_deg, abs=0.1)


def test_psf_is_a_square_of_light() -> None:
    image = eye().psf()
    assert image.shape == (128, 128) and image.dtype == np.float64
    assert image.sum() == pytest.approx(1.0)
    assert eye("-20.00DS").psf(size_arcmin=10.0).sum() < 0.2


def test_mtf_is_that_of_the_rays_and_diffraction_is_asked_for() -> None:
    frequencies = np.array([[0.0, 2.0], [5.0, 10.0]])
    rays = eye().mtf(frequencies, distance_m=2.0)
    assert rays.shape == frequencies.shape
    assert rays[0, 0] == pytest.approx(1.0)
    both = eye().mtf(frequencies, distance_m=2.0, diffraction=True)
    assert (both < eyecore.diffraction_mtf(frequencies, 4.0) + 1e-3).all()
    # Bars along the blur's streak keep more contrast than bars across it.
    along, across = (eye().mtf([2.0], meridian_deg=angle)[0] for angle in (20.0, 110.0))
    assert along > across


def wave_mtf(defocus_d: float, frequency_cpd: float, pupil_mm: float, nm: float = 555.0) -> float:
    """By wave optics: the pupil's autocorrelation with the wavefront E r^2 / 2 (Hopkins 1955)."""
    radius_m = pupil_mm / 2e3
    shift_m = np.degrees(frequency_cpd) * nm * 1e-9
    axis = np.linspace(-radius_m, radius_m, 801)
    x, y = np.meshgrid(axis, axis)
    inside = (np.hypot(x - shift_m / 2, y) < radius_m) & (np.hypot(x + shift_m / 2, y) < radius_m)
    phase = 2 * np.pi / (nm * 1e-9) * defocus_d * x * shift_m
    return abs((inside * np.exp(1j * phase)).sum()) / (np.hypot(x, y) < radius_m).sum()


@pytest.mark.parametrize("pupil_mm", [2.0, 4.0])
@pytest.mark.parametrize("defocus_d", [0.0, 0.1, 0.25, 0.5, 1.0])
def test_mtf_with_diffraction_is_that_of_the_waves(pupil_mm: float, defocus_d: float) -> None:
    frequencies = [3.0, 10.0, 20.0, 30.0]
    waves = np.array([wave_mtf(defocus_d, f, pupil_mm) for f in frequencies])
    blurred = eyecore.Eye(rx=f"{-defocus_d}", rx_plane="entrance_pupil", pupil_mm=pupil_mm)
    # The grid of 801 points and the rays each integrate to about 0.001.
    assert blurred.mtf(frequencies, diffraction=True) == pytest.approx(waves, abs=3e-3)


@pytest.mark.parametrize(
    ("wavelength_nm", "published"),
    [
        (550.0, (0.8695, 0.5949, 0.3920, 0.3265, 0.2209)),
        (650.0, (0.9801, 0.9218, 0.8310, 0.5860, 0.0549)),
    ],
)
def test_navarros_eye_has_its_published_mtf(wavelength_nm: float, published) -> None:
    """Escudero-Sanz & Navarro's eye with a 4 mm iris, by a commercial lens-design program, among
    the validation data of ISET3d; no diffraction, 0.2877 cycles/degree for a cycle/mm."""
    # The entrance pupil of that iris, and the published vitreous: emmetropic at 543 nm.
    rx = eyecore.Prescription(0.0729)
    navarro = eyecore.Eye(model="navarro", rx=rx, rx_plane="entrance_pupil", pupil_mm=4.4916)
    frequencies = 0.2877 * np.array([10.0, 20.0, 30.0, 50.0, 100.0])
    # 0.002 D of focus change the second number by 0.0025.
    mtf = navarro.mtf(frequencies, wavelength_nm=wavelength_nm)
    assert mtf == pytest.approx(published, abs=0.003)


def test_focus_is_where_the_through_focus_curve_is_lowest() -> None:
    near_sighted = eye("-2.00DS", rx_plane="entrance_pupil", accommodation_d=0.5)
    vergences = np.linspace(0.0, 5.0, 51)
    curve = near_sighted.through_focus(vergences)
    assert near_sighted.best_focus_d == pytest.approx(2.5, abs=1e-6)
    assert vergences[curve.argmin()] == pytest.approx(2.5)
    # 4 mm x 1 D over 2 sqrt 2.
    assert curve[vergences == 1.5] == pytest.approx(4.8617, rel=1e-3)
    assert eyecore.Eye(model="pinhole").best_focus_d is None


def test_an_eye_sees_sharply_from_far_to_near_point() -> None:
    relaxed, near = (eye(rx_plane="entrance_pupil", accommodation_d=a) for a in (0.0, 6.0))
    mean, first, second = eyecore.clear_ranges(relaxed, near)
    assert (mean.meridian_deg, mean.far_d, mean.near_d) == (
        None,
        pytest.approx(2.375),
        pytest.approx(8.375),
    )
    assert (first.meridian_deg, first.far_d) == (pytest.approx(20.0), pytest.approx(2.0))
    assert (second.meridian_deg, second.near_d) == (pytest.approx(110.0), pytest.approx(8.75))


def test_diffraction_is_stronger_than_little_blur() -> None:
    """Blur and Airy disk are equally wide at 0.338 D through 2 mm."""
    for defocus_d, is_limited in ((0.33, True), (0.35, False)):
        blurred = eyecore.Eye(rx=f"{-defocus_d}", rx_plane="entrance_pupil", pupil_mm=2.0)
        assert blurred.is_diffraction_limited() is is_limited
    assert eyecore.airy_radius_arcmin(2.0) == pytest.approx(1.16353, abs=1e-5)
    assert eyecore.quarter_wave_d(2.0) == pytest.approx(0.2775)


def test_the_observers_eye_wears_what_the_observer_wears() -> None:
    observer = eyecore.Observer(rx="-4.00DS", correction="glasses")
    seen = eyecore.observer_eye(observer, pupil_mm=3.0, accommodation_d=2.0)
    assert seen.pupil_mm == 3.0
    assert seen.best_focus_d == pytest.approx(2.0, abs=0.25)  # less by the lens's distance
    assert eyecore.observer_eye(observer, 3.0).blur_ellipse().major_arcmin < 1e-9


def test_rays_are_counted_by_what_became_of_them() -> None:
    counts = eye().ray_counts(samples=100)
    assert counts == {"transmitted": 100, "vignetted": 0, "missed": 0, "total_reflection": 0}


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: eye().spot(0.0), "distance_m is 0 m; expected at least 0.01 m"),
        (lambda: eye().spot(float("nan")), "distance_m is nan m"),
        (lambda: eye().psf(resolution=0), "resolution is 0 pixels; expected 1 to 4096"),
        (lambda: eye().psf(size_arcmin=-1.0), "size_arcmin is -1 arcmin; expected"),
        (lambda: eye().mtf([-1.0]), "frequencies_cpd is -1 cycles/degree; expected 0 to"),
        (lambda: eye().spot(field_deg=(0.0, 90.0)), "field_deg is 90 degrees; expected -80 to 80"),
        (lambda: eye().spot(wavelength_nm=200.0), "wavelength_nm is 200 nm; expected 380 to 780"),
        (lambda: eye().spot(samples=0), "samples is 0 rays; expected 1 to"),
        (lambda: eye().through_focus([1e3]), "vergences_d is 1000 D; expected -100 to 100"),
        (lambda: eyecore.diffraction_mtf([1.0], 0.0), "pupil_mm is 0 mm; expected 0.01 to 9"),
        (lambda: eyecore.Eye(model="pinhole").is_diffraction_limited(), "pupil_mm is 0 mm"),
    ],
)
def test_refusals_name_value_and_what_is_allowed(call, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        call()
