"""What of a geometry may differ from time to time while the shutter is open."""

from typing import NamedTuple

import numpy as np

_ROUNDING = 1e-6  # a few float steps of the largest coordinate: hair comes through matrices


class Pose(NamedTuple):
    positions: np.ndarray
    normals: np.ndarray | None = None  # of a mesh that is not flat

    def is_like(self, other: "Pose") -> bool:
        """The same vertices, so that one may turn into the other."""
        mine, others = self.normals, other.normals
        if (mine is None) != (others is None) or mine is not None and mine.shape != others.shape:
            return False
        return self.positions.shape == other.positions.shape

    def differs(self, other: "Pose") -> bool:
        difference = np.abs(self.positions - other.positions)
        largest = np.abs(other.positions).max(initial=0.0)
        return not difference.max(initial=0.0) <= _ROUNDING * largest


def motion_arguments(poses: list[Pose]) -> dict[str, list[np.ndarray]]:
    """How the core is told of them."""
    told = {"motion_positions": [pose.positions for pose in poses]}
    if poses and poses[0].normals is not None:
        told["motion_normals"] = [pose.normals for pose in poses]
    return told
