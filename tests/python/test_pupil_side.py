"""What tells left from right in the pupil, pinned in rendered pictures: where the cones' favourite
point lies, and which way coma flares."""

import eyecore
import numpy as np
import pytest
from point_source import DISTANCE_M, disk_picture

PUPIL_MM = 6.0
RADIUS_M = PUPIL_MM * 0.5e-3


def centroid(picture: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    return slopes @ picture.ravel() / picture.sum()


def pupil_points(count: int = 201) -> np.ndarray:
    """A square grid cut to the pupil, (2, n), metres, camera frame."""
    axis = np.linspace(-RADIUS_M, RADIUS_M, count)
    points = np.stack(np.meshgrid(axis, axis)).reshape(2, -1)
    return points[:, np.hypot(*points) <= RADIUS_M]


@pytest.mark.parametrize(("eye", "nasal"), [("OD", -1.0), ("OS", 1.0)])
@pytest.mark.parametrize("sphere_d", [-3.0, 3.0])
def test_stiles_crawford_favours_the_nasal_side(eye: str, nasal: float, sphere_d: float) -> None:
    """A blur circle is a picture of the pupil, magnified by the error E: upright for a myope who
    looks beyond the far point. Its centre of light is E times that of the weighted pupil."""
    observer = eyecore.Observer(
        rx=eyecore.Prescription(sphere_d, eye=eye), rx_plane="entrance_pupil", pupil=PUPIL_MM
    )
    error_d = -sphere_d - 1.0 / DISTANCE_M
    picture, slopes = disk_picture(observer, RADIUS_M * abs(error_d), stiles_crawford=True)
    points = pupil_points()
    # Applegate & Lakshminarayanan 1993: peak 0.51 mm nasal and 0.20 mm superior.
    from_peak_mm = points * 1e3 - np.array([[nasal * 0.51], [0.20]])
    weight = 10.0 ** -(0.047 * from_peak_mm[0] ** 2 + 0.053 * from_peak_mm[1] ** 2)
    expected = error_d * (points * weight).sum(axis=1) / weight.sum()
    assert np.sign(expected[0]) == np.sign(nasal * error_d)
    # 512 samples a pixel over thousands of pixels: noise of the centroid is below 0.2 % of the
    # blur's radius, a tenth of its distance from the middle.
    assert np.allclose(
        centroid(picture, slopes), expected, rtol=0.0, atol=2e-3 * RADIUS_M * abs(error_d)
    )


@pytest.mark.parametrize("coefficient_um", [1.0, -1.0])
@pytest.mark.parametrize(
    ("index", "direction"), [(8, (-1.0, 0.0)), (7, (0.0, 1.0))], ids=["horizontal", "vertical"]
)
def test_coma_flares_to_one_side(
    index: int, direction: tuple[float, float], coefficient_um: float
) -> None:
    """W = c sqrt(8) 3 rho^2 x over a focused pupil, x to the clinician's right and so to the
    patient's left. A point is seen at its slope plus grad W, whose mean over the pupil is
    c sqrt(8) 3 / R: the flare points there from the sharp chief ray."""
    observer = eyecore.Observer(
        model="wavefront",
        rx=eyecore.Prescription(-1.0 / DISTANCE_M),
        rx_plane="entrance_pupil",
        pupil=PUPIL_MM,
        wavefront=eyecore.Wavefront([0.0] * index + [coefficient_um], PUPIL_MM),
    )
    mean = 3.0 * np.sqrt(8.0) * abs(coefficient_um) * 1e-6 / RADIUS_M
    picture, slopes = disk_picture(observer, 3.0 * mean, 0.05)
    expected = np.sign(coefficient_um) * mean * np.array(direction)
    assert np.allclose(centroid(picture, slopes), expected, rtol=0.0, atol=0.01 * mean)
