"""The chart of error against time: above RMSE, below FLIP; at the left the pupil patterns, at the
right the eye models."""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter  # noqa: E402
from points import Point, line_of, pareto_front  # noqa: E402
from reading import Setting  # noqa: E402

# Okabe & Ito's colours, which the colour blind tell apart; each with its own marker.
STYLES = [
    ("#0072B2", "o"),
    ("#D55E00", "s"),
    ("#009E73", "^"),
    ("#CC79A7", "D"),
    ("#E69F00", "v"),
    ("#56B4E9", "P"),
    ("#000000", "X"),
]
ERRORS = {"rmse": "RMSE", "flip": "mean FLIP"}


def draw_chart(points: list[Point], setting: Setting, path: Path) -> None:
    plt.rcParams.update({"font.size": 15, "axes.grid": True, "grid.alpha": 0.3})
    figure, axes = plt.subplots(2, 2, figsize=(16, 12), sharex=True, sharey="row")
    for row, (error, error_name) in zip(axes, ERRORS.items(), strict=True):
        _draw_patterns(row[0], points, error)
        _draw_models(row[1], points, error)
        same_truth = [p for p in points if p.reference == "paraxial"]
        _mark_front(row[0], [p for p in same_truth if p.model != "pinhole"], error)
        _mark_front(row[1], [p for p in same_truth if p.pattern == "SOBOL"], error)
        for axis in row:
            axis.set_xscale("log")
            axis.set_yscale("log")
            axis.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axis.yaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
            axis.yaxis.set_minor_formatter(NullFormatter())
            axis.legend(fontsize=12, loc="upper right")
        row[0].set_ylabel(f"{error_name} against the converged picture")
    axes[0, 0].set_title("Pupil patterns: solid the exact eye, dashed the paper's")
    axes[0, 1].set_title("Eye models, each with the Sobol pattern")
    for axis in axes[1]:
        axis.set_xlabel("processor seconds per million pixels")
    figure.suptitle(
        f"{setting.scene}, {setting.rx}, pupil {setting.pupil_mm:g} mm; labels are samples a pixel"
    )
    figure.tight_layout()
    figure.savefig(path, dpi=100)
    plt.close(figure)


def _draw_patterns(axis, points: list[Point], error: str) -> None:
    patterns = list(dict.fromkeys(p.pattern for p in points))
    for pattern, (colour, marker) in zip(patterns, STYLES, strict=False):
        for model, dashes in (("paraxial", "-"), ("paper", "--")):
            line = line_of(points, model, pattern)
            label = pattern.replace("_", " ").lower() if model == "paraxial" else None
            _draw(axis, line, error, color=colour, marker=marker, linestyle=dashes, label=label)
    _label_samples(axis, line_of(points, "paraxial", "SOBOL"), error)


def _draw_models(axis, points: list[Point], error: str) -> None:
    models = list(dict.fromkeys(p.model for p in points))
    for model, (colour, marker) in zip(models, STYLES, strict=False):
        line = line_of(points, model, "SOBOL")
        of_its_own = line[0].reference == model
        label = model if of_its_own else f"{model} (against {line[0].reference})"
        _draw(axis, line, error, color=colour, marker=marker, linestyle="-", label=label)


def _draw(axis, line: list[Point], error: str, **style) -> None:
    x = [p.cpu_s_per_mpx for p in line]
    axis.plot(x, [getattr(p, error) for p in line], markersize=9, linewidth=2, **style)


def _label_samples(axis, line: list[Point], error: str) -> None:
    for point in line:
        axis.annotate(
            str(point.samples),
            (point.cpu_s_per_mpx, getattr(point, error)),
            textcoords="offset points",
            xytext=(8, 8),
        )


def _mark_front(axis, points: list[Point], error: str) -> None:
    front = pareto_front(points, error)
    axis.scatter(
        [p.cpu_s_per_mpx for p in front],
        [getattr(p, error) for p in front],
        s=260,
        facecolors="none",
        edgecolors="black",
        linewidths=1.5,
        zorder=5,
        label="Pareto front",
    )
