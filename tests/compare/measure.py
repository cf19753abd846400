"""How far a picture is from its reference."""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tools.display import LUMINANCE, to_display  # noqa: E402

try:
    from tools.flip import mean_flip
except ImportError:  # pip could not install it: RMSE decides
    mean_flip = None

BLOCK_PX = 4


@dataclass
class Difference:
    flip: float  # mean FLIP, 0 to 1; NaN where FLIP is not installed
    rmse: float  # of what sRGB shows, 0 to 1
    block_rmse: float  # the same of blocks' means, in which noise hardly counts
    brightness_ratio: float  # mean of the picture over mean of the reference
    excess_rmse: float = math.nan  # block_rmse less noise, where the reference's is known

    def figure(self) -> float:
        """What is held against a threshold of mean FLIP."""
        return self.flip if math.isfinite(self.flip) else FLIP_OF_BLOCK_RMSE * self.block_rmse


# Where light or colour is a little off, FLIP is about this many times the blocks' RMSE.
FLIP_OF_BLOCK_RMSE = 6.0


def measure(reference: np.ndarray, picture: np.ndarray) -> Difference:
    """Both linear RGB (height, width, 3)."""
    if reference.shape != picture.shape:
        raise ValueError(f"the picture is {picture.shape}, the reference {reference.shape}")
    shown_reference, shown = to_display(reference), to_display(picture)
    mean_reference = float((np.clip(reference, 0, 1) @ LUMINANCE).mean())
    mean = float((np.clip(picture, 0, 1) @ LUMINANCE).mean())
    return Difference(
        flip=mean_flip(reference, picture) if mean_flip else math.nan,
        rmse=_rms(shown - shown_reference),
        block_rmse=_rms(_blocks(shown) - _blocks(shown_reference)),
        brightness_ratio=mean / mean_reference if mean_reference else math.nan,
    )


def excess_rmse(
    reference: np.ndarray,
    sigma: np.ndarray,
    reference_samples: int,
    picture: np.ndarray,
    samples: int,
) -> float:
    """The blocks' RMSE of what sRGB shows, less the part that noise alone would give: a sample of
    ours is taken to be as noisy as one of the reference, whose mean luminance has the standard
    error `sigma`."""
    difference = _blocks(to_display(picture) - to_display(reference))
    variance = sigma[..., None] ** 2 * (1.0 + reference_samples / samples)
    # Where a small change of light changes the shown picture by less.
    step = 1e-3
    slope = (to_display(reference + step) - to_display(reference - step)) / (2 * step)
    noise = _blocks(variance * slope**2) / BLOCK_PX**2
    return float(np.sqrt(max(np.mean(difference**2 - noise), 0.0)))


def _rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _blocks(image: np.ndarray) -> np.ndarray:
    """Means of the blocks; what does not fill one at the right or below is left out."""
    rows, columns = (n // BLOCK_PX for n in image.shape[:2])
    image = image[: rows * BLOCK_PX, : columns * BLOCK_PX]
    return image.reshape(rows, BLOCK_PX, columns, BLOCK_PX, -1).mean(axis=(1, 3))
