"""A small bright disk on black, rendered through each eye model: the second moments of its picture
are those of the closed form, ellipse axes and angle included."""

import math

import eyecore
import numpy as np
import pytest
from point_source import DISTANCE_M, disk_picture

PUPIL_MM = 5.0
PAPER_EYE_M = 0.017

# The variance of the Blackman-Harris window that spreads every sample, 1.5 px to each side, in
# square pixels.
FILTER_VARIANCE_PX2 = 0.173


def rendered_moments(
    model: str, rx: str, extent: float, disk_share: float = 0.15
) -> tuple[np.ndarray, float]:
    """Covariance of the picture in slopes, the disk's own and the filter's taken off; and the
    disk's radius."""
    observer = eyecore.Observer(model=model, rx=rx, rx_plane="entrance_pupil", pupil=PUPIL_MM)
    picture, slopes = disk_picture(observer, extent, disk_share)
    disk_slope = disk_share * extent
    pixel = slopes[0, 1] - slopes[0, 0]
    covariance = np.cov(slopes, aweights=picture.ravel(), ddof=0)
    own = disk_slope**2 / 4.0 + FILTER_VARIANCE_PX2 * pixel**2
    return covariance - own * np.eye(2), disk_slope


def error_matrix(rx: str) -> np.ndarray:
    """E = K - X I of the relaxed eye, K = minus the prescription in the camera frame."""
    return -np.array(eyecore.Prescription.parse(rx).power_matrix()) - np.eye(2) / DISTANCE_M


def paper_moments(rx: str) -> np.ndarray:
    """The paper bends a ray at angle phi from the axis radially, by the power of a focal length
    that goes linearly from the one meridian's to the other's."""
    prescription = eyecore.Prescription.parse(rx)
    radius = PUPIL_MM * 0.5e-3
    phi = np.linspace(0.0, 2.0 * np.pi, 200001)[:-1]
    axis = math.radians(180.0 - prescription.axis_deg)
    turned = np.abs((phi - axis + np.pi / 2) % np.pi - np.pi / 2)  # acute angle from the axis
    along_m = 1.0 / (1.0 / PAPER_EYE_M - prescription.sphere_d)
    across_m = 1.0 / (1.0 / PAPER_EYE_M - prescription.sphere_d - prescription.cylinder_d)
    power = 1.0 / PAPER_EYE_M - 1.0 / (along_m + (across_m - along_m) * turned / (np.pi / 2))
    spread = radius * (-power - 1.0 / DISTANCE_M)
    direction = np.stack([np.cos(phi), np.sin(phi)])
    # Second moments over the disk: a quarter of the squared rim, averaged over the angle.
    moments = (direction * spread**2 / 2.0) @ direction.T / phi.size
    centre = (direction * spread * 2.0 / 3.0).mean(axis=1)
    return moments - np.outer(centre, centre)


PRESCRIPTIONS = [
    "-3.00DS",
    "+4.00DS",
    "-1.00DS -4.00DC 30A",
    "+5.00DS -4.00DC 30A",
    "-1.00DS -4.00DC 160A",
    "+5.00DS -4.00DC 160A",
]


def check(found: np.ndarray, expected: np.ndarray) -> None:
    """Within 1 % of the largest moment, and the principal axes within 1 % and their angle."""
    scale = np.linalg.norm(expected, 2)
    assert np.allclose(
        found, expected, rtol=0.0, atol=0.01 * scale
    ), f"{found / scale} {expected / scale}"
    found_axes, found_frame = np.linalg.eigh(found)
    axes, frame = np.linalg.eigh(expected)
    assert np.allclose(np.sqrt(found_axes), np.sqrt(axes), rtol=0.01)
    if axes[1] > 1.1 * axes[0]:
        # 1 % of a moment turns an ellipse by at most 0.01 / (1 - axes ratio) radians.
        assert abs(np.dot(found_frame[:, 1], frame[:, 1])) > math.cos(
            0.01 / (1.0 - axes[0] / axes[1])
        )


@pytest.mark.parametrize("rx", PRESCRIPTIONS)
def test_paraxial_blur_is_the_ellipse_of_the_power_matrix(rx: str) -> None:
    e = error_matrix(rx)
    radius = PUPIL_MM * 0.5e-3
    found, _ = rendered_moments("paraxial", rx, radius * np.linalg.norm(e, 2))
    check(found, radius**2 / 4.0 * e @ e)


@pytest.mark.parametrize("rx", PRESCRIPTIONS)
def test_paper_blur_is_its_own_star(rx: str) -> None:
    radius = PUPIL_MM * 0.5e-3
    found, _ = rendered_moments("paper", rx, radius * np.linalg.norm(error_matrix(rx), 2))
    check(found, paper_moments(rx))


@pytest.mark.parametrize("rx", ["-3.00DS", "+4.00DS"])
def test_paper_and_paraxial_agree_on_spheres(rx: str) -> None:
    assert np.allclose(
        paper_moments(rx), (PUPIL_MM * 0.5e-3) ** 2 / 4.0 * error_matrix(rx) @ error_matrix(rx)
    )


def test_pinhole_has_no_blur() -> None:
    found, disk_slope = rendered_moments("pinhole", "-3.00DS", 0.01, disk_share=2.0)
    assert np.abs(found).max() < 0.01 * disk_slope**2 / 4.0


def test_streak_of_axis_30_leans_to_60_degrees_as_the_patient_sees() -> None:
    """The mirror: the blur of a plano cylinder runs across its axis, (180 - 30) + 90 = 60."""
    rx = "plano -6.00 x 30"
    radius = PUPIL_MM * 0.5e-3
    found, _ = rendered_moments("paraxial", rx, radius * np.linalg.norm(error_matrix(rx), 2))
    _, frame = np.linalg.eigh(found)
    angle = math.degrees(math.atan2(frame[1, 1], frame[0, 1])) % 180.0
    assert angle == pytest.approx(60.0, abs=0.5)
