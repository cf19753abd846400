"""The RGB that Blender's colours are in: the file's choice from Blender 5.0, and of OpenColorIO's
configuration in all."""

from collections.abc import Callable

import numpy as np
from mathutils import Color

# The core's spaces by X, Y and Z of red, green and blue; white is D65.
_PRIMARIES = {
    "Linear Rec.709": (
        (0.4124, 0.2126, 0.0193),
        (0.3576, 0.7152, 0.1192),
        (0.1805, 0.0722, 0.9505),
    ),
    "Linear Rec.2020": ((0.6370, 0.2627, 0.0), (0.1446, 0.6780, 0.0281), (0.1689, 0.0593, 1.0610)),
    "ACEScg": ((0.6522, 0.2677, -0.0054), (0.1282, 0.6743, 0.0014), (0.1700, 0.0580, 1.0931)),
}
_DIGITS = 1e-3  # of the table, and of configurations


def _xyz(color: tuple[float, ...]) -> Color:
    return Color(color[:3]).from_scene_linear_to_xyz_d65()


def luminance(color: tuple[float, ...]) -> float:
    """Y of a linear colour of Blender's."""
    return _xyz(color)[1]


def working_space(warn: Callable[[str], None] = lambda _: None) -> str:
    """The core's name of the space, or of the nearest after a warning."""
    primaries = np.array([_xyz(tuple(channel)) for channel in np.eye(3)])
    distances = {
        name: float(np.abs(primaries - known).max()) for name, known in _PRIMARIES.items()
    }
    name = min(distances, key=distances.get)
    if distances[name] > _DIGITS:
        warn(
            f"Blender's working space is none that Eye Render knows ({', '.join(_PRIMARIES)}); "
            f"pictures, skies and hot bodies are shown as in {name}"
        )
    return name
