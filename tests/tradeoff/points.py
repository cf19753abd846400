"""Measured points of error against time, and what can be said of them."""

import math
from dataclasses import dataclass

import numpy as np

# Whose converged picture is the truth for a model. An approximation of another eye is measured
# against that eye, so that its error is bias and noise; an eye of its own has noise alone.
APPROXIMATES = {"pinhole": "paraxial", "paper": "paraxial"}
TIMING_NOISE = 0.05  # by which repeats on a busy machine differ


@dataclass(frozen=True)
class Point:
    model: str
    pattern: str
    samples: int
    cpu_s_per_mpx: float  # processor seconds per million pixels, all threads; median of repeats
    wall_s_per_mpx: float
    rmse: float  # of radiance clipped to 1, without the reference's own noise
    rmse_bias: float  # the part that other seeds share, so that averaging does not remove it
    flip: float  # mean over the repeats

    @property
    def reference(self) -> str:
        return APPROXIMATES.get(self.model, self.model)


def mean_square(a: np.ndarray, b: np.ndarray) -> float:
    return float(np.mean((np.clip(a, 0, 1) - np.clip(b, 0, 1)) ** 2))


def error_of(pictures: list[np.ndarray], halves: list[np.ndarray]) -> float:
    """Root mean square error of one such picture. The reference is the mean of two halves of
    different seeds; its noise, a quarter of the square of their difference, is taken off. Where
    nothing is left, 1e-6, which has a logarithm."""
    truth = np.mean(np.clip(halves, 0, 1), axis=0)
    error = float(np.mean([mean_square(picture, truth) for picture in pictures]))
    return math.sqrt(max(1e-12, error - mean_square(*halves) / 4))


def bias_of(pictures: list[np.ndarray], reference: list[np.ndarray]) -> float:
    """Root mean square difference between the expectations of two sets of pictures, each set of
    different seeds and two or more of them. Unbiased before the root; 0 where noise hides it."""
    difference = mean_square(np.mean(np.clip(pictures, 0, 1), axis=0),
                             np.mean(np.clip(reference, 0, 1), axis=0))  # fmt: skip
    noise = sum(
        float(np.mean(np.var(np.clip(seeds, 0, 1), axis=0, ddof=1))) / len(seeds)
        for seeds in (pictures, reference)
    )
    return math.sqrt(max(0.0, difference - noise))


def pareto_front(points: list[Point], error: str = "rmse") -> list[Point]:
    """Those that no other beats in both time and error, cheapest first. Of points that take the
    same time but for TIMING_NOISE, the one with the least error stands for all."""
    front: list[Point] = []
    for point in sorted(points, key=lambda p: (p.cpu_s_per_mpx, getattr(p, error))):
        if front and getattr(point, error) >= getattr(front[-1], error):
            continue
        if front and point.cpu_s_per_mpx < front[-1].cpu_s_per_mpx * (1 + TIMING_NOISE):
            front.pop()
        front.append(point)
    return front


def time_to_reach(points: list[Point], target: float, error: str = "rmse") -> float | None:
    """Processor seconds per million pixels at which the points' error falls to `target`, straight
    between them on logarithmic axes; None if it does not. The points go from few samples to many.
    """
    points = sorted(points, key=lambda p: p.samples)
    if getattr(points[0], error) <= target:
        return points[0].cpu_s_per_mpx
    for before, after in zip(points, points[1:], strict=False):
        high, low = getattr(before, error), getattr(after, error)
        if low <= target < high:
            share = math.log(high / target) / math.log(high / low)
            return before.cpu_s_per_mpx * (after.cpu_s_per_mpx / before.cpu_s_per_mpx) ** share
    return None


def slope(points: list[Point], error: str = "rmse") -> float:
    """Of log error against log samples: -1/2 for plain Monte Carlo."""
    x = [math.log(p.samples) for p in points]
    y = [math.log(getattr(p, error)) for p in points]
    return float(np.polyfit(x, y, 1)[0])


def line_of(points: list[Point], model: str, pattern: str) -> list[Point]:
    """One curve of the chart, from few samples to many."""
    chosen = [p for p in points if (p.model, p.pattern) == (model, pattern)]
    return sorted(chosen, key=lambda p: p.samples)
