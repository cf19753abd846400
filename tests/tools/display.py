"""What a display of sRGB (IEC 61966-2-1) makes of linear light."""

import numpy as np

LUMINANCE = np.array([0.2126, 0.7152, 0.0722], np.float32)  # of linear RGB


def to_display(linear: np.ndarray) -> np.ndarray:
    """As sRGB shows it, 0 to 1."""
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
