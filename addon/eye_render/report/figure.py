"""The picture of a report, for a slide: a point's blur at each distance beside a 20/20 letter, the
contrast that is left of fine detail, and the blur through focus."""

import math
from pathlib import Path

import eyecore
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle

from .measure import CURVE_SAMPLES, NOT_INCLUDED, WAVELENGTH_NM, mtf_meridians_deg, spoken_distance

_SIZE_INCHES = (16.0, 9.0)
_DPI = 100
_LEFT, _RIGHT = 0.05, 0.98  # of the slide, as shares of its width
_LETTER_ARCMIN = 5.0  # a 20/20 letter, whose strokes are 1 arcmin wide
# So much wider than the blur, a tile has room for the letter in its corner.
_TILE_PER_BLUR = 1.9
_SMALLEST_TILE_ARCMIN = 24.0
_TILE_PX = 192
_FINEST_CPD = 60.0
# The lobes of a large blur lie close to each other, below 10.
_FREQUENCIES_CPD = np.concatenate(
    [np.linspace(0.0, 9.9, 100), np.linspace(10.0, _FINEST_CPD, 101)]
)
_ACUITY_CPD = 30.0  # the strokes of a 20/20 letter
_COLORS = ("#1b6ca8", "#d95f02", "#1b9e77", "#c51b7d", "#7a6a1c", "#5b4ba0")
_NO_EYE = "0.88"  # the grey of what diffraction forbids


def draw(eye: eyecore.Eye, report: dict, path: Path) -> None:
    """Write the picture of `report`, which is of `eye`, as a PNG file."""
    figure = Figure(figsize=_SIZE_INCHES, dpi=_DPI)
    FigureCanvasAgg(figure)
    rows = figure.add_gridspec(
        2, 1, height_ratios=(1, 1.1), hspace=0.32, left=_LEFT, right=_RIGHT, top=0.83, bottom=0.09
    )
    distances = report["distances"]
    tiles = rows[0].subgridspec(1, len(distances), wspace=0.12)
    for number, row in enumerate(distances):
        _draw_psf(figure.add_subplot(tiles[number]), eye, report, row, _color(number))
    curves = rows[1].subgridspec(1, 2, width_ratios=(1.6, 1), wspace=0.16)
    _draw_mtf(figure.add_subplot(curves[0]), eye, distances)
    _draw_through_focus(figure.add_subplot(curves[1]), report)
    _write(figure, 0.93, _title(report), fontsize=22, weight="bold")
    _write(figure, 0.895, _subtitle(report), fontsize=14, color="0.3")
    figure.savefig(path, format="png")


def _write(figure: Figure, y: float, text: str, **look: object) -> None:
    """A line of text at the height `y`, smaller if it would run off the slide."""
    line = figure.text(_LEFT, y, text, **look)
    share = line.get_window_extent().width / figure.bbox.width
    line.set_fontsize(line.get_fontsize() * min(1.0, (_RIGHT - _LEFT) / share))


def _color(number: int) -> str:
    return _COLORS[number % len(_COLORS)]


def _title(report: dict) -> str:
    observer = report["observer"]
    title = f"{observer.get('rx', 'Eye')}, pupil {report['pupil_mm']:.3g} mm"
    if "correction" in observer:
        part = ", seen through their near part" if observer.get("worn_part") == "near" else ""
        title += f", {observer['correction']} worn: {observer['worn']}{part}"
    return title


def _subtitle(report: dict) -> str:
    parts = [
        f"accommodation {report['accommodation_d']:.2f} D "
        f"of {report['accommodation_amplitude_d']:.1f} D",
        f"far point {spoken_distance(report['far_point_m'])}",
        f"near point {spoken_distance(report['near_point_m'])}",
        f"dashed: Airy disk, radius {report['airy_radius_arcmin']:.2f}′",
    ]
    if "model" in report["observer"]:
        parts.append(_model(report["observer"]))
    return "   ·   ".join(parts + _left_out(report))


def _left_out(report: dict) -> list[str]:
    """What the render has and these pictures and curves do not."""
    spoken = {"stiles_crawford": "Stiles-Crawford", "chromatic": "chromatic"}
    names = [name for key, name in spoken.items() if report.get(key) == NOT_INCLUDED]
    if not names:
        return []
    return [f"not included: {' and '.join(names)} (all at {report['wavelength_nm']:.0f} nm)"]


def _model(observer: dict) -> str:
    text = f"{observer['model']} model"
    if "refraction_zero" in observer:
        text += f", 0 D: {observer['refraction_zero'].replace('_', ' ')}"
    return text


def _object_distance(row: dict) -> float:
    return math.inf if row["distance_m"] is None else row["distance_m"]


def _draw_psf(axes: Axes, eye: eyecore.Eye, report: dict, row: dict, color: str) -> None:
    widest = max(row["blur_major_arcmin"], 2 * report["airy_radius_arcmin"])
    size = max(_SMALLEST_TILE_ARCMIN, _TILE_PER_BLUR * widest)
    half = size / 2
    image = eye.psf(_object_distance(row), size_arcmin=size, resolution=_TILE_PX)
    axes.imshow(
        np.sqrt(image / image.max()),  # the eye's impression of light, nearly
        extent=(-half, half, -half, half),
        origin="lower",
        cmap="inferno",
        interpolation="nearest",
    )
    axes.add_patch(
        Circle(
            (0, 0), report["airy_radius_arcmin"], fill=False, ec="#7fd7ff", ls=(0, (3, 2)), lw=1.2
        )
    )
    _draw_letter(axes, (-half + 0.06 * size, -half + 0.06 * size))
    axes.set_title(
        f"{spoken_distance(row['distance_m'])}", color=color, weight="bold", fontsize=15
    )
    axes.set_xlabel(_blur_text(row), fontsize=11.5)
    axes.text(-0.47 * size, 0.47 * size, f"{size:.0f}′ wide", color="0.8", fontsize=10, va="top")
    axes.set(xticks=[], yticks=[])
    for spine in axes.spines.values():
        spine.set(color=color, linewidth=2.5)


def _blur_text(row: dict) -> str:
    if row["is_diffraction_limited"]:
        blur = "sharp, but for diffraction"
    elif row["blur_angle_deg"] is None:
        blur = f"blur {row['blur_major_arcmin']:.1f}′"
    else:
        blur = (
            f"blur {row['blur_major_arcmin']:.1f}′ × {row['blur_minor_arcmin']:.1f}′ "
            f"at {row['blur_angle_deg']:.0f}°"
        )
    return f"{blur}\ndefocus {_dioptres(row['defocus_d'])}"


def _dioptres(power_d: float) -> str:
    return f"{round(power_d, 2) + 0.0:+.2f} D"  # + 0.0 so that none is written -0.00


def _draw_letter(axes: Axes, corner: tuple[float, float]) -> None:
    """An E of 20/20 size with its lower left corner there: 5 arcmin high, strokes of 1 arcmin."""
    x, y = corner
    axes.add_patch(Rectangle((x, y), 1, _LETTER_ARCMIN, color="white", lw=0))
    for stroke in (0, 2, 4):
        axes.add_patch(Rectangle((x, y + stroke), _LETTER_ARCMIN, 1, color="white", lw=0))
    axes.text(x + _LETTER_ARCMIN, y, "  20/20", color="white", fontsize=9, va="bottom")


def _draw_mtf(axes: Axes, eye: eyecore.Eye, distances: list[dict]) -> None:
    frequencies = _FREQUENCIES_CPD
    bound = eyecore.diffraction_mtf(frequencies, eye.pupil_mm, WAVELENGTH_NM)
    axes.fill_between(frequencies, bound, 1.0, color=_NO_EYE, lw=0)
    axes.plot(frequencies, bound, color="0.45", lw=1.5)
    axes.text(
        0.985, 0.95, "no eye with this pupil: diffraction", transform=axes.transAxes,
        ha="right", va="top", color="0.35", fontsize=11,
    )  # fmt: skip
    for number, row in enumerate(distances):
        worst, best = (
            eye.mtf(
                frequencies,
                _object_distance(row),
                meridian,
                diffraction=True,
                samples=CURVE_SAMPLES,
            )
            for meridian in mtf_meridians_deg(row["blur_angle_deg"])
        )
        color = _color(number)
        axes.fill_between(frequencies, worst, best, color=color, alpha=0.18, lw=0)
        axes.plot(frequencies, worst, color=color, lw=1.2)
        label = spoken_distance(row["distance_m"])
        axes.plot(frequencies, best, color=color, lw=2.4, label=label)
    axes.axvline(_ACUITY_CPD, color="0.2", lw=1, ls=":")
    axes.text(_ACUITY_CPD, 0.80, " strokes of a 20/20 letter", color="0.2", fontsize=11)
    axes.set(xlim=(0, _FINEST_CPD), ylim=(0, 1))
    axes.set_xlabel("fineness of a grating, cycles per degree", fontsize=12)
    axes.set_ylabel("contrast that is left", fontsize=12)
    axes.set_title(
        "Modulation transfer with diffraction (best and worst direction)", fontsize=13, loc="left"
    )
    axes.legend(fontsize=12, framealpha=0.8, edgecolor="none", loc="center right")
    _clear_frame(axes)


def _draw_through_focus(axes: Axes, report: dict) -> None:
    curve = report["through_focus"]
    vergences = curve["object_vergence_d"]
    axes.plot(vergences, curve["rms_radius_arcmin"], color="0.25")
    for number, row in enumerate(report["distances"]):
        axes.plot(
            row["object_vergence_d"], row["rms_radius_arcmin"], "o", ms=10, color=_color(number)
        )
    airy_rms = report["airy_radius_arcmin"] / math.sqrt(2.0)
    axes.axhspan(0.0, airy_rms, color=_NO_EYE, lw=0)
    # On the side where the curve is high.
    is_best_at_right = report["best_focus_d"] > (vergences[0] + vergences[-1]) / 2
    axes.text(
        0.015 if is_best_at_right else 0.985, airy_rms, "below: diffraction is stronger",
        ha="left" if is_best_at_right else "right", va="bottom", color="0.35", fontsize=11,
        transform=axes.get_yaxis_transform(),
    )  # fmt: skip
    axes.set(xlim=(vergences[0], vergences[-1]))
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel("vergence of the object, D (0: infinity)", fontsize=12)
    axes.set_ylabel("RMS radius of the blur, arcmin", fontsize=12)
    axes.set_title(
        f"Through focus: best at {spoken_distance(report['best_focus_m'])} "
        f"({_dioptres(report['best_focus_d'])})",
        fontsize=13,
        loc="left",
    )
    _clear_frame(axes)


def _clear_frame(axes: Axes) -> None:
    axes.tick_params(labelsize=11)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
