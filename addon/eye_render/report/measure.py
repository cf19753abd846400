"""The numbers of a report. Every key names its unit; a distance of null is infinity, and one below
0 lies behind the eye. The blur is the evenly filled ellipse with the spot's second moments."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, partial

import eyecore
import numpy as np

WAVELENGTH_NM = 555.0
NOT_INCLUDED = "not included"
# Large blur leaves contrast below 5 alone; 30 is the finest detail of a 20/20 letter.
FREQUENCIES_CPD = (1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 30.0)
USUAL_DISTANCES_M = (0.4, 1.0, 6.0, math.inf)

# What a session tells of the observer: enough to build the same eye again.
_DESCRIBING = (
    *("eye", "rx", "rx_plane", "vertex_mm", "correction", "worn", "worn_part", "model"),
    *("wavefront", "refraction_zero", "exact_trace", "fit_residual_arcmin"),
    *("age_years", "amplitude_formula", "focus", "focus_m"),
    *("pupil_formula", "luminance_cd_m2", "cd_m2_per_unit", "luminance_sigma"),
    *("field_area_deg2", "eyes", "pupil_clamps", "pupil_found_in"),
)

# What a session tells of effects that the report knows nothing of, where they are off.
_NEVER_INCLUDED = {"stiles_crawford": "OFF", "chromatic": "no"}

# Of the curve through focus: over all distances, and close to its sharpest point.
_CURVE_MARGIN_D = 0.5
_CURVE_POINTS = 101
_SHARPEST_D = 1.0
_SHARPEST_POINTS = 41
CURVE_SAMPLES = 16384

# A panel asks at every step of a slider. So few are within 1e-3 of what 65536 find.
LINE_SAMPLES = 1024

_NO_BLUR_ARCMIN = 1e-6  # has no direction: what is left of it is the noise of sums


@dataclass(frozen=True)
class Subject:
    """One eye, as it looks and at rest."""

    eye_at: Callable[[float], eyecore.Eye]  # the eye when it accommodates so much, in dioptres
    accommodation_d: float
    amplitude_d: float
    description: Mapping[str, str | float | None] = field(default_factory=dict)
    # What a render of it does and the report does not: one wavelength, an even pupil.
    not_included: tuple[str, ...] = ()

    @property
    def eye(self) -> eyecore.Eye:
        return self.eye_at(self.accommodation_d)


def subject_of(observer: eyecore.Observer, facts: Mapping[str, str | float]) -> Subject:
    """The observer in the state that a session's facts tell of."""
    return Subject(
        # Building a schematic eye means fitting a map of its rays.
        eye_at=cache(partial(eyecore.observer_eye, observer, facts["pupil_mm"])),
        accommodation_d=facts["accommodation_d"],
        amplitude_d=facts["accommodation_amplitude_d"],
        description={
            key: None if facts[key] == math.inf else facts[key]
            for key in _DESCRIBING
            if key in facts
        },
        not_included=tuple(
            key for key, off in _NEVER_INCLUDED.items() if facts.get(key, off) != off
        ),
    )


def distances_of(subject: Subject) -> list[float]:
    """What the eye is focused at, if at anything near, and the usual distances."""
    focus_m = subject.description.get("focus_m")
    return sorted({*USUAL_DISTANCES_M, focus_m or math.inf})


def distance_m(vergence_d: float) -> float | None:
    """None for infinity: sampling tells no smaller vergence from it."""
    return None if abs(vergence_d) < 1e-6 else 1.0 / vergence_d


def measure(subject: Subject, distances_m: Sequence[float]) -> dict:
    """The report; ValueError for an eye without a pupil's width."""
    eye = subject.eye
    if eye.pupil_mm == 0.0:
        raise ValueError("the eye has no blur to report: its pupil_mm is 0; expected above 0")
    mean, *meridians = eyecore.clear_ranges(
        subject.eye_at(0.0), subject.eye_at(subject.amplitude_d)
    )
    return {
        "observer": dict(subject.description),
        "wavelength_nm": WAVELENGTH_NM,
        **dict.fromkeys(subject.not_included, NOT_INCLUDED),
        "pupil_mm": eye.pupil_mm,
        "accommodation_d": subject.accommodation_d,
        "accommodation_amplitude_d": subject.amplitude_d,
        **_clear_range(mean),
        "meridians": [
            {"meridian_deg": each.meridian_deg, **_clear_range(each)} for each in meridians
        ],
        "best_focus_d": eye.best_focus_d,
        "best_focus_m": distance_m(eye.best_focus_d),
        "airy_radius_arcmin": eyecore.airy_radius_arcmin(eye.pupil_mm, WAVELENGTH_NM),
        "quarter_wave_defocus_d": eyecore.quarter_wave_d(eye.pupil_mm, WAVELENGTH_NM),
        "distances": [_at_distance(eye, distance) for distance in distances_m],
        "through_focus": _through_focus(eye, distances_m),
    }


def _through_focus(eye: eyecore.Eye, distances_m: Sequence[float]) -> dict:
    """The curve of the blur over the vergence of the object."""
    best_d = eye.best_focus_d
    shown_d = [best_d, *(1.0 / distance for distance in distances_m)]
    lowest_d, highest_d = min(shown_d) - _CURVE_MARGIN_D, max(shown_d) + _CURVE_MARGIN_D
    everywhere = np.linspace(lowest_d, highest_d, _CURVE_POINTS)
    sharpest = np.linspace(best_d - _SHARPEST_D, best_d + _SHARPEST_D, _SHARPEST_POINTS)
    vergences = np.union1d(everywhere, sharpest.clip(lowest_d, highest_d))
    blur = eye.through_focus(vergences, WAVELENGTH_NM, samples=CURVE_SAMPLES)
    return {"object_vergence_d": vergences.tolist(), "rms_radius_arcmin": blur.tolist()}


def _clear_range(clear: eyecore.ClearRange) -> dict:
    return {
        "far_point_m": distance_m(clear.far_d),
        "far_point_d": clear.far_d,
        "near_point_m": distance_m(clear.near_d),
        "near_point_d": clear.near_d,
    }


def _at_distance(eye: eyecore.Eye, distance: float) -> dict:
    blur = eye.spot_ellipse(distance)
    angle_deg = blur.angle_deg if blur.major_arcmin > _NO_BLUR_ARCMIN else None
    vergence_d = 1.0 / distance
    return {
        "distance_m": distance_m(vergence_d),
        "object_vergence_d": vergence_d,
        "defocus_d": eye.best_focus_d - vergence_d,
        "blur_major_arcmin": blur.major_arcmin,
        "blur_minor_arcmin": blur.minor_arcmin,
        "blur_angle_deg": angle_deg,
        "rms_radius_arcmin": blur.rms_radius_arcmin,
        "is_diffraction_limited": eye.is_diffraction_limited(distance),
        "mtf": [_mtf(eye, distance, meridian) for meridian in mtf_meridians_deg(angle_deg)],
    }


def mtf_meridians_deg(blur_angle_deg: float | None) -> tuple[float, float]:
    """Across the bars that a blur of that direction shows worst, and best."""
    worst = blur_angle_deg or 0.0
    return worst, (worst + 90.0) % 180.0


def _mtf(eye: eyecore.Eye, distance: float, meridian_deg: float) -> dict:
    transfer = partial(eye.mtf, FREQUENCIES_CPD, distance, meridian_deg)
    return {
        "meridian_deg": meridian_deg,
        "frequencies_cpd": list(FREQUENCIES_CPD),
        "of_rays": transfer().tolist(),
        "with_diffraction": transfer(diffraction=True).tolist(),
    }


def spoken_distance(distance: float | None) -> str:
    if distance is None or math.isinf(distance):
        return "infinity"
    return f"{abs(distance):.2f} m" + (" behind the eye" if distance < 0.0 else "")


def summary_line(subject: Subject, focus_m: float) -> str:
    """Blur at the focus and far away, far and near point, and the pupil, in one line."""
    eye = subject.eye
    if eye.pupil_mm == 0.0:
        return "No blur: a pupil without width"
    clear = eyecore.clear_ranges(subject.eye_at(0.0), subject.eye_at(subject.amplitude_d))[0]
    blurs = [
        f"{eye.spot_ellipse(at, samples=LINE_SAMPLES).major_arcmin:.1f}′ at {spoken_distance(at)}"
        for at in sorted({focus_m, math.inf})
    ]
    return (
        f"Blur {', '.join(blurs)}; far point {spoken_distance(distance_m(clear.far_d))}, "
        f"near point {spoken_distance(distance_m(clear.near_d))}; pupil {eye.pupil_mm:.1f} mm"
    )
