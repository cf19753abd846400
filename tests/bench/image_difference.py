"""How two engines' pictures of one scene differ, each rendered with two seeds."""

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tools.display import LUMINANCE  # noqa: E402
from tools.flip import mean_flip  # noqa: E402

BLOCK_PX = 8


@dataclass
class Difference:
    flip: float  # mean LDR FLIP of the means over seeds
    flip_of_noise: float  # the larger of the two engines' FLIP between its own seeds
    rmse: float  # of radiance clipped to 1, so that no firefly decides
    brightness_ratio: float  # mean of test over mean of reference
    brightness_ratio_sigma: float  # its standard deviation by the noise
    z_beyond_3: float  # fraction of blocks; 0.0027 if all differences are noise
    z_sigma: float  # 1 if all differences are noise


def compare(reference: list[np.ndarray], test: list[np.ndarray]) -> Difference:
    """`reference` and `test` are two linear RGB images (h, w, 3) each, of different seeds."""
    mean_reference, mean_test = np.mean(reference, axis=0), np.mean(test, axis=0)
    z = _block_z(reference, test)
    noise = max(mean_flip(*reference), mean_flip(*test))
    ratios = [(b @ LUMINANCE).mean() / (a @ LUMINANCE).mean()
              for a in reference for b in test]  # fmt: skip
    clipped = np.clip(mean_test, 0, 1) - np.clip(mean_reference, 0, 1)
    return Difference(
        flip=mean_flip(mean_reference, mean_test),
        flip_of_noise=noise,
        rmse=float(np.sqrt(np.mean(clipped**2))),
        brightness_ratio=float(
            (mean_test @ LUMINANCE).mean() / (mean_reference @ LUMINANCE).mean()
        ),
        brightness_ratio_sigma=float(np.std(ratios, ddof=1)),
        z_beyond_3=float(np.mean(np.abs(z) > 3)),
        z_sigma=float(np.std(z)),
    )


def _block_z(reference, test) -> np.ndarray:
    """Z of each block's mean luminance. Two seeds give a pixel one degree of freedom for its
    variance; a block of them gives enough for a normal distribution."""
    a0, a1, b0, b1 = (_blocks(np.clip(image, 0, 1) @ LUMINANCE) for image in (*reference, *test))
    count = a0.shape[-1]
    difference = (a0 + a1 - b0 - b1).mean(axis=-1) / 2
    variance = (((a0 - a1) ** 2 + (b0 - b1) ** 2) / 4).sum(axis=-1) / count**2
    return difference / np.sqrt(np.maximum(variance, 1e-12))


def _blocks(image: np.ndarray) -> np.ndarray:
    rows, columns = (n // BLOCK_PX for n in image.shape)
    image = image[: rows * BLOCK_PX, : columns * BLOCK_PX]
    blocks = image.reshape(rows, BLOCK_PX, columns, BLOCK_PX).swapaxes(1, 2)
    return blocks.reshape(rows * columns, BLOCK_PX * BLOCK_PX)
