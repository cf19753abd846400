"""The stored pictures of Cycles: a file a scene, with how sure each pixel is.

An .npz holds `mean`, linear RGB as half floats rounded to eight binary digits (so that the file is
small; half a step is 0.2 %), `sigma`, the standard error of each pixel's mean luminance, `samples`
per pixel in all, `noise` (mean FLIP of one half of the batches against the other) and `blender`.
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tools.display import LUMINANCE  # noqa: E402

FOLDER = Path(__file__).resolve().parent / "references"
BRIGHTEST = 16.0  # what is brighter is stored as this
_DROPPED_BITS = 3  # of a half float's ten
_SIGMA_STEPS = 8  # of a byte, for a factor of two
_SIGMA_SMALLEST = 2.0**-24


@dataclass
class Reference:
    mean: np.ndarray  # linear RGB as seen, (height, width, 3)
    sigma: np.ndarray  # standard error of the mean's luminance, (height, width)
    samples: int
    noise: float
    blender: str = ""


def of_batches(pictures: list[np.ndarray], samples: int, noise: float, blender: str) -> Reference:
    """The mean of independent renders of equal samples; `samples` is that of one."""
    pictures = [np.clip(picture, -BRIGHTEST, BRIGHTEST) for picture in pictures]
    luminance = np.array([picture @ LUMINANCE for picture in pictures], np.float64)
    sigma = luminance.std(axis=0, ddof=1) / np.sqrt(len(pictures))
    mean = np.mean(pictures, axis=0, dtype=np.float64)
    return Reference(mean.astype(np.float32), sigma, samples * len(pictures), noise, blender)


def path_of(name: str) -> Path:
    return FOLDER / f"{name.replace('/', '.')}.npz"


def save(path: Path, reference: Reference) -> None:
    bits = reference.mean.astype(np.float16).view(np.uint16).astype(np.uint32)
    step = 1 << _DROPPED_BITS
    bits = ((bits + step // 2) // step).astype(np.uint16)
    steps = np.log2(np.maximum(reference.sigma / _SIGMA_SMALLEST, 1.0)) * _SIGMA_STEPS
    np.savez_compressed(
        path,
        # Neighbours are alike in their high bytes, which deflate sees if they stand together.
        mean_high=(bits >> 8).astype(np.uint8),
        mean_low=(bits & 255).astype(np.uint8),
        sigma=np.clip(np.ceil(steps), 0, 255).astype(np.uint8),
        samples=reference.samples,
        noise=reference.noise,
        blender=reference.blender,
    )


def load(path: Path) -> Reference:
    with np.load(path) as file:
        bits = file["mean_high"].astype(np.uint16) << 8 | file["mean_low"]
        mean = (bits << _DROPPED_BITS).view(np.float16).astype(np.float32)
        sigma = _SIGMA_SMALLEST * 2.0 ** (file["sigma"].astype(np.float64) / _SIGMA_STEPS)
        return Reference(
            mean, sigma, int(file["samples"]), float(file["noise"]), str(file["blender"])
        )
