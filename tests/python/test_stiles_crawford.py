"""What the Stiles-Crawford effect does to a picture's brightness, against the pupil's own mean."""

import eyecore
import numpy as np
import pytest
from point_source import disk_scene

RX = eyecore.Prescription(-4.0, eye="OD")


def pupil_points_m(pupil_mm: float, count: int = 801) -> np.ndarray:
    """A square grid cut to the pupil, (n, 2), camera frame."""
    axis = (np.arange(count) + 0.5) / count - 0.5
    points = np.stack(np.meshgrid(axis, axis), axis=-1).reshape(-1, 2)
    return points[np.hypot(*points.T) <= 0.5] * pupil_mm * 1e-3


def efficiency(points_m: np.ndarray) -> np.ndarray:
    """Applegate & Lakshminarayanan 1993: a right eye, whose nose is on the left."""
    x_mm, y_mm = (points_m * 1e3 - [-0.51, 0.20]).T
    return 10.0 ** -(0.047 * x_mm**2 + 0.053 * y_mm**2)


def flat_picture(
    observer: eyecore.Observer, mode: str | bool, center_slope: float = 0.0, **settings
) -> np.ndarray:
    """A small window on a world of radiance 0.5."""
    scene = eyecore.Scene()
    scene.set_world((0.5, 0.5, 0.5))
    bounds = (center_slope - 0.001, center_slope + 0.001, -0.001, 0.001)
    scene.set_camera(np.eye(4), bounds, (8, 8))
    return eyecore.render(
        scene, observer, eyecore.Settings(samples=64, stiles_crawford=mode, **settings)
    )["Combined"]


@pytest.mark.parametrize("chromatic", [False, True])
@pytest.mark.parametrize("rx", ["plano", RX])
@pytest.mark.parametrize("pupil_mm", [2.0, 4.0, 8.0])
def test_energy_darkens_by_the_mean_efficiency_of_the_pupil(
    pupil_mm: float, rx: eyecore.Prescription | str, chromatic: bool
) -> None:
    """With blur, and without, where one ray serves for the whole pupil."""
    right = eyecore.Prescription(eye="OD") if rx == "plano" else rx
    observer = eyecore.Observer(rx=right, pupil=pupil_mm)
    picture = flat_picture(observer, "ENERGY", chromatic=chromatic)
    # 500,000 points of the pupil: its rim is known to 1e-5.
    expected = 0.5 * efficiency(pupil_points_m(pupil_mm)).mean()
    assert picture[:, :, :3] == pytest.approx(expected, rel=1e-4)
    assert (picture[:, :, 3] == 1.0).all()


def test_a_pinhole_has_the_efficiency_of_the_pupils_middle() -> None:
    observer = eyecore.Observer(model="pinhole", rx=RX)
    expected = 0.5 * efficiency(np.zeros((1, 2)))[0]
    assert flat_picture(observer, "ENERGY")[:, :, :3] == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("mode", ["OFF", "BRIGHTNESS"])
def test_brightness_is_kept(mode: str) -> None:
    observer = eyecore.Observer(rx=RX, pupil=6)
    assert flat_picture(observer, mode)[:, :, :3] == pytest.approx(0.5, rel=1e-6)


@pytest.mark.parametrize("mode", eyecore.STILES_CRAWFORD_MODES)
def test_lost_rays_darken_a_picture_of_energy_and_no_other(mode: str) -> None:
    """75 degrees off the axis, a third of a wide pupil's rays do not get through the eye."""
    slope = np.tan(np.radians(75.0))
    observer = eyecore.Observer(
        model="navarro", rx=eyecore.Prescription(eye="OD"), pupil=8, exact_trace=True
    )
    picture = flat_picture(observer, mode, slope)
    points_m = pupil_points_m(8.0, 201)
    arrives = eyecore.observer_eye(observer, 8.0).rays([[slope, 0.0]] * len(points_m), points_m)[2]
    assert 0.3 < 1.0 - arrives.mean() < 0.4
    expected = 0.5 * (efficiency(points_m) * arrives).mean() if mode == "ENERGY" else 0.5
    # 64 Sobol points tell the share of the pupil behind a curve to 1 % a pixel; 64 pixels.
    assert picture[:, :, :3].mean() == pytest.approx(expected, rel=3e-3)
    assert (picture[:, :, 3] == 1.0).all()


def test_true_is_brightness_and_false_is_off() -> None:
    def picture(mode: str | bool) -> np.ndarray:
        settings = eyecore.Settings(samples=4, stiles_crawford=mode)
        observer = eyecore.Observer(rx=RX, pupil=6)
        return eyecore.render(disk_scene(0.01, 0.03), observer, settings)["Combined"]

    assert (picture(True) == picture("BRIGHTNESS")).all()
    assert (picture(False) == picture("OFF")).all()
    assert (picture(True) != picture(False)).any()


@pytest.mark.parametrize("mode", ["DIM", 1, None])
def test_other_modes_are_refused(mode: object) -> None:
    with pytest.raises(ValueError, match="stiles_crawford is .*; expected one of"):
        eyecore.Settings(stiles_crawford=mode)
