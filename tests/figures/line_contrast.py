"""Which of the target's lines a picture shows the clearer."""

import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from tools.display import LUMINANCE


@dataclass
class LineContrast:
    """Root mean square of the gradient of luminance across lines of either direction. A sharp
    picture has as much of one as of the other."""

    horizontal: float
    vertical: float

    def __str__(self) -> str:
        ratio = self.horizontal / self.vertical
        if 0.9 < ratio < 1 / 0.9:
            return "lines of both directions alike"
        if ratio > 1:
            return f"horizontal lines clearer, {ratio:.1f} : 1"
        return f"vertical lines clearer, {1 / ratio:.1f} : 1"


def line_contrast(luminance: np.ndarray) -> LineContrast:
    """`luminance` is linear, (height, width)."""
    across_horizontal, across_vertical = np.gradient(luminance)
    return LineContrast(
        horizontal=float(np.sqrt(np.mean(across_horizontal**2))),
        vertical=float(np.sqrt(np.mean(across_vertical**2))),
    )


def read_luminance(picture: Path, white: float = 1.0) -> np.ndarray:
    """Of a linear picture, top row first, up to `white` in 255 steps."""
    with tempfile.TemporaryDirectory() as folder:
        gray = Path(folder) / "luminance.pgm"
        command = ["oiiotool", str(picture), "--ch", "R,G,B", "--mulc", str(1 / white)]
        command += [
            f"--chsum:weight={','.join(map(str, LUMINANCE))}",
            "-d",
            "uint8",
            "-o",
            str(gray),
        ]
        subprocess.run(command, check=True)
        kind, size, _, pixels = gray.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    assert kind == b"P5"
    return np.frombuffer(pixels, np.uint8).reshape(height, width) * (white / 255)
