"""The chart in words. Every number and every judgement comes from the measured points."""

import statistics
from dataclasses import dataclass
from pathlib import Path

from points import Point, line_of, pareto_front, slope, time_to_reach

EXACT = "paraxial"
CHANCE = 0.1  # by how much points differ that two seeds cannot tell apart
FEW_SAMPLES = 16  # from here on, a render's fixed costs no longer count in its time


@dataclass(frozen=True)
class Setting:
    """What was measured, and how well the converged picture is known."""

    scene: str
    rx: str
    pupil_mm: float
    window_px: tuple[int, int]
    frame_px: int
    processors: int
    repeats: int
    reference_samples: int
    reference_cpu_s_per_mpx: float
    reference_rmse: float  # its noise
    reference_flip: float


def write_reading(points: list[Point], setting: Setting, path: Path) -> str:
    sections = [
        _heading(setting),
        _presets(points, setting),
        _patterns(points),
        _circinate(points),
        _models(points),
        _front(points),
    ]
    text = "\n\n".join(sections) + "\n"
    path.write_text(text, encoding="utf-8")
    return text


def _heading(setting: Setting) -> str:
    width, height = setting.window_px
    return f"""# Error against time: {setting.scene}

The middle {width} x {height} pixels of a frame {setting.frame_px} wide, seen by {setting.rx}, \
which all models take at the pupil, through {setting.pupil_mm:g} mm, relaxed. Times are of all of \
{setting.processors} \
processors together, in processor seconds per million pixels, without export and preparation; \
medians of {setting.repeats} interleaved repeats.

RMSE is of radiance clipped to 1, FLIP of the picture as a display clips it. Both are against the \
converged picture ({setting.reference_samples} samples, other seeds; its own noise is RMSE \
{setting.reference_rmse:.4f}, FLIP {setting.reference_flip:.4f}) of the exact eye: of `paraxial` \
an error is noise; of `paper` and `pinhole` it is noise and bias, since they approximate that \
eye. The other models are eyes of their own, and their error is the noise against their own \
converged pictures. Differences below {CHANCE:.0%} may be chance."""


def _seconds(seconds: float) -> str:
    return f"{seconds:.0f}" if seconds >= 100 else f"{seconds:.3g}"


def _table(head: list[str], rows: list[list[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


def _presets(points: list[Point], setting: Setting) -> str:
    rows = [
        [str(p.samples), _seconds(p.cpu_s_per_mpx), f"{p.rmse:.4f}", f"{p.flip:.4f}"]
        for p in line_of(points, EXACT, "SOBOL")
    ]
    rows.append(
        [
            str(setting.reference_samples),
            _seconds(setting.reference_cpu_s_per_mpx),
            f"{setting.reference_rmse:.4f}",
            f"{setting.reference_flip:.4f}",
        ]
    )
    return (
        "## Samples (exact eye, Sobol pattern)\n\n"
        + _table(["samples", "processor s / Mpx", "RMSE", "FLIP"], rows)
        + "\n\nThe last row is the converged picture itself, from the difference of its halves."
    )


def _patterns(points: list[Point]) -> str:
    patterns = list(dict.fromkeys(p.pattern for p in points if p.model == EXACT))
    lines = {pattern: line_of(points, EXACT, pattern) for pattern in patterns}
    samples = [p.samples for p in lines["SOBOL"]]
    table = _table(
        ["samples", *(pattern.lower() for pattern in patterns)],
        [
            [str(count), *(f"{lines[pattern][k].rmse:.4f}" for pattern in patterns)]
            for k, count in enumerate(samples)
        ],
    )
    slopes = ", ".join(f"{pattern.lower()} {slope(lines[pattern]):.2f}" for pattern in patterns)
    return (
        "## Pupil patterns (exact eye)\n\nRMSE:\n\n"
        + table
        + f"\n\nSlope of log RMSE over log samples (plain Monte Carlo: -0.50): {slopes}.\n\n"
        + "\n".join(_first_to_reach(lines, target) for target in _targets(lines["SOBOL"]))
    )


def _targets(line: list[Point]) -> list[float]:
    """Errors that Sobol reaches between its measured points."""
    return [(a.rmse * b.rmse) ** 0.5 for a, b in zip(line[1:], line[2:], strict=False)]


def _first_to_reach(lines: dict[str, list[Point]], target: float) -> str:
    times = {pattern: time_to_reach(line, target) for pattern, line in lines.items()}
    reached = sorted(
        (time, pattern.lower()) for pattern, time in times.items() if time is not None
    )
    never = [pattern.lower() for pattern, time in times.items() if time is None]
    first_time = reached[0][0]
    first = [pattern for time, pattern in reached if time < first_time * (1 + CHANCE)]
    later = [
        f"; {pattern} takes {time / first_time:.2f} times as long"
        for time, pattern in reached[len(first) :]
    ]
    return (
        f"* RMSE {target:.3f} is reached first by {', '.join(first)} ({_seconds(first_time)} s)"
        + "".join(later)
        + (f"; {', '.join(never)} does not reach it." if never else ".")
    )


def _circinate(points: list[Point]) -> str:
    circinate = line_of(points, EXACT, "CIRCINATE")
    sobol = line_of(points, EXACT, "SOBOL")
    last = circinate[-1]
    like = time_to_reach(sobol, last.rmse)
    worth = ""
    if like is not None:
        worth = f" Sobol is as good after {like / last.cpu_s_per_mpx:.2f} of the time."
    return f"""## What the circinate pattern costs

With {last.samples} samples its RMSE is {last.rmse:.4f}, {last.rmse / sobol[-1].rmse:.1f} times \
Sobol's. {last.rmse_bias:.4f} of it is bias, which no more samples of these rings remove \
(squares add: the rest is noise). For Sobol, which has none, the same estimate gives \
{sobol[-1].rmse_bias:.4f}: so far is it to be trusted.{worth}

The pattern crowds towards the pupil's centre, so it shows less blur than the eye has: with N \
rings the RMS radius of its points is sqrt((N - 1)(2N - 1) / 6) / N of the pupil's, 0.52 for \
N = 8, where an evenly filled pupil has 0.71."""


def _models(points: list[Point]) -> str:
    rows = []
    for model in dict.fromkeys(p.model for p in points):
        line = line_of(points, model, "SOBOL")
        exact = line_of(points, EXACT, "SOBOL")
        cost = statistics.median(
            p.cpu_s_per_mpx / q.cpu_s_per_mpx
            for p, q in zip(line, exact, strict=True)
            if p.samples >= min(FEW_SAMPLES, line[-1].samples)
        )
        last = line[-1]
        rows.append([model, last.reference, f"{cost:.2f}", f"{last.rmse:.4f}",
                     f"{last.rmse_bias:.4f}", f"{last.flip:.4f}"])  # fmt: skip
    head = ["model", "truth", "time of paraxial's", "RMSE", "bias in it", "FLIP"]
    return (
        f"## Eye models (Sobol pattern; errors at {last.samples} samples)\n\n"
        + _table(head, rows)
        + "\n\n"
        + _paper(points)
    )


def _paper(points: list[Point]) -> str:
    exact = line_of(points, EXACT, "SOBOL")[-1]
    paper = line_of(points, "paper", "SOBOL")[-1]
    if paper.rmse_bias <= 2 * exact.rmse_bias:
        return "No bias of the paper's astigmatism is found: noise hides it at all these samples."
    # Noise falls with the square root of the samples.
    equal = exact.samples * (exact.rmse / paper.rmse_bias) ** 2
    return (
        "Both eyes take the prescription at the pupil, so that they differ by their astigmatism "
        f"alone: the paper's is a bias of RMSE {paper.rmse_bias:.4f}. The exact eye's noise "
        f"is less than that from about {equal:.0f} samples on; with fewer, noise hides it."
    )


def _front(points: list[Point]) -> str:
    front = pareto_front([p for p in points if p.reference == EXACT])
    rows = [
        [p.model, p.pattern.lower(), str(p.samples), _seconds(p.cpu_s_per_mpx), f"{p.rmse:.4f}"]
        for p in front
    ]
    return "## Pareto front (of what approximates the exact eye, by RMSE)\n\n" + _table(
        ["model", "pattern", "samples", "processor s / Mpx", "RMSE"], rows
    )
