"""FLIP (Andersson et al. 2020): how much of a difference between two pictures people see when they
flip between them. Only in the venv of the package flip-evaluator."""

import flip_evaluator
import numpy as np
from tools.display import to_display


def mean_flip(reference: np.ndarray, test: np.ndarray) -> float:
    """Mean LDR FLIP, 0 to 1, of two linear RGB images (h, w, 3) as a display clips them."""
    pair = [np.ascontiguousarray(to_display(image), np.float32) for image in (reference, test)]
    return float(flip_evaluator.evaluate(*pair, "LDR")[1])
