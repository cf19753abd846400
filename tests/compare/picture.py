"""How a rendered picture is looked at: as three channels of which 0 to 1 can be seen."""

import numpy as np

MAGENTA = np.array([1.0, 0.0, 1.0], np.float32)

# What becomes of linear RGBA, (height, width, 4).
VIEWS = {
    "COLOR": lambda rgba: rgba[..., :3],
    # So that alpha counts.
    "OVER_MAGENTA": lambda rgba: rgba[..., :3] + (1 - rgba[..., 3:]) * MAGENTA,
    "SIGNED": lambda rgba: rgba[..., :3] * 0.5 + 0.5,
    "GREEN": lambda rgba: rgba[..., 1:2].repeat(3, axis=-1),
    # Of pixels, ten to either side.
    "MOTION": lambda rgba: rgba[..., :3] * 0.05 + 0.5,
    "TENTH": lambda rgba: rgba[..., :3] * 0.1,
}


def as_seen(rgba: np.ndarray, view: str) -> np.ndarray:
    """Linear RGB, (height, width, 3)."""
    return VIEWS[view](np.nan_to_num(rgba, nan=0.0, posinf=1e4, neginf=-1e4))
