"""What a ray of each eye model costs, and how far it is from the ray it stands for: in plain
Python. Run by eye_models.py, and small by tests/python/test_eye_rays.py.

Nanoseconds are of one thread. What the pinhole takes is the copy of a ray from and to NumPy; it is
taken off the others'. Errors are angles between a model's rays and those of its reference, over
the pupil and directions within 20 degrees of the axis: the exact trace for the schematic eyes, and
for the others the exact eye of first order, with the wavefront's polynomials where there is one,
written down once more below.
"""

import time
from dataclasses import dataclass

import eyecore
import numpy as np

RX = "-2.00DS -0.75DC 160A"
PUPIL_MM = 4.0
FIELD_DEG = 20.0
WAVELENGTHS_NM = (450.0, 555.0, 650.0)
SCHEMATIC = ("navarro", "arizona", "le_grand")
COPY = "pinhole"


@dataclass
class RayError:
    median_arcmin: float
    largest_arcmin: float
    other_fates: int  # rays of which one is lost and the other is not, or otherwise


def make_eye(model: str, **more) -> eyecore.Eye:
    if model == "wavefront":
        more["wavefront"] = wavefront()
    return eyecore.Eye(model=model, rx=RX, rx_plane="entrance_pupil", pupil_mm=PUPIL_MM, **more)


def wavefront() -> eyecore.Wavefront:
    return eyecore.Wavefront.population(6.0)


def rays_to_ask(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Directions even over the field and points even over the pupil, (count, 2) each."""
    random = np.random.default_rng(1)

    def disk(radius: float) -> np.ndarray:
        r = radius * np.sqrt(random.random(count))
        angle = 2.0 * np.pi * random.random(count)
        return np.stack([r * np.cos(angle), r * np.sin(angle)], axis=1)

    return disk(np.tan(np.radians(FIELD_DEG))), disk(PUPIL_MM * 0.5e-3)


def ray_ns(eye: eyecore.Eye, wavelength_nm: float, count: int) -> float:
    """The copy included."""
    slopes, points = rays_to_ask(count)
    if eye.pupil_mm == 0.0:
        points = np.zeros_like(points)
    start = time.thread_time_ns()
    eye.rays(slopes, points, wavelength_nm)
    return (time.thread_time_ns() - start) / count


def higher_order_slope(measured: eyecore.Wavefront, points_m: np.ndarray) -> np.ndarray:
    """Gradient of the terms of third and fourth degree of OSA indices 6 to 14, camera frame."""
    radius_m = measured.pupil_mm * 0.5e-3
    c = dict(enumerate(np.pad(measured.coefficients_um, (0, 15))[:15]))
    # The clinician faces the patient, so x is mirrored.
    x, y = (points_m / radius_m * [-1.0, 1.0]).T
    third, fourth, spherical = np.sqrt(8.0), np.sqrt(10.0), np.sqrt(5.0)
    along_x = third * (
        c[6] * 6 * x * y
        + c[7] * 6 * x * y
        + c[8] * (9 * x**2 + 3 * y**2)
        + c[9] * 3 * (x**2 - y**2)
    )
    along_y = third * (
        c[6] * 3 * (x**2 - y**2)
        + c[7] * (3 * x**2 + 9 * y**2)
        + c[8] * 6 * x * y
        - c[9] * 6 * x * y
    )
    along_x += fourth * (
        c[10] * (12 * x**2 * y - 4 * y**3)
        + c[11] * (24 * x**2 * y + 8 * y**3)
        + c[13] * 16 * x**3
        + c[14] * (4 * x**3 - 12 * x * y**2)
    )
    along_y += fourth * (
        c[10] * (4 * x**3 - 12 * x * y**2)
        + c[11] * (8 * x**3 + 24 * x * y**2)
        - c[13] * 16 * y**3
        + c[14] * (4 * y**3 - 12 * x**2 * y)
    )
    along_x += spherical * c[12] * 24 * x * (x**2 + y**2)
    along_y += spherical * c[12] * 24 * y * (x**2 + y**2)
    return np.stack([-along_x, along_y], axis=1) * 1e-6 / radius_m


def thin_slopes(model: str, slopes: np.ndarray, points_m: np.ndarray, nm: float) -> np.ndarray:
    """u - (K - dRx(nm)) p - grad W: K against the prescription, dRx by Thibos et al. 1992."""
    longitudinal_d = 633.46 / (555.0 - 214.102) - 633.46 / (nm - 214.102)
    power = np.array(eyecore.Prescription.parse(RX).power_matrix())
    focus_d = -power - longitudinal_d * np.eye(2)
    result = slopes - points_m @ focus_d
    if model == "wavefront":
        result = result - higher_order_slope(wavefront(), points_m)
    return result


def ray_error(model: str, wavelength_nm: float, count: int) -> RayError:
    slopes, points_m = rays_to_ask(count)
    eye = make_eye(model)
    # The pinhole has no other point.
    asked_m = points_m if eye.pupil_mm > 0.0 else np.zeros_like(points_m)
    _, found, weight, fate = eye.rays(slopes, asked_m, wavelength_nm)
    other_fates = 0
    if model in SCHEMATIC:
        exact = make_eye(model, exact_trace=True)
        _, expected, exact_weight, exact_fate = exact.rays(slopes, points_m, wavelength_nm)
        other_fates = int(np.count_nonzero(fate != exact_fate))
        weight = weight * exact_weight
    else:
        expected = thin_slopes(model, slopes, points_m, wavelength_nm)

    def directions(of: np.ndarray) -> np.ndarray:
        forward = np.concatenate([of, np.ones((len(of), 1))], axis=1)[weight > 0.0]
        return forward / np.linalg.norm(forward, axis=1, keepdims=True)

    sine = np.linalg.norm(np.cross(directions(found), directions(expected)), axis=1)
    arcmin = np.degrees(np.arcsin(sine)) * 60.0
    return RayError(float(np.median(arcmin)), float(arcmin.max()), other_fates)
