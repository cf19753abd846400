"""Curves and colour ramps as tables of evenly spaced values."""

import bpy

from .flat import Node

_STEPS = 256  # as Cycles


def sample_curves(node: Node) -> None:
    """Options `curve`, `curve_min`, `curve_max` and `extrapolate` in place of `mapping`."""
    mapping: bpy.types.CurveMapping = node.options.pop("mapping")
    mapping.initialize()
    curves = list(mapping.curves)
    if node.kind == "CURVE_FLOAT":
        curves = curves[:1]
    elif node.kind == "CURVE_VEC":
        curves = curves[:3]
    first = min(curve.points[0].location.x for curve in curves)
    last = max(curve.points[-1].location.x for curve in curves)
    places = [first + (last - first) * i / (_STEPS - 1) for i in range(_STEPS)]
    if node.kind == "CURVE_RGB":  # the combined curve comes before those of the channels
        combined = curves.pop()
        places = [mapping.evaluate(combined, place) for place in places]
    node.options |= {
        "curve": [mapping.evaluate(curve, place) for curve in curves for place in places],
        "curve_min": first,
        "curve_max": last,
        "extrapolate": mapping.extend == "EXTRAPOLATED",
    }


def sample_ramp(node: Node) -> None:
    """Options `ramp` and `interpolate` in place of `color_ramp`."""
    ramp: bpy.types.ColorRamp = node.options.pop("color_ramp")
    colors = (ramp.evaluate(i / (_STEPS - 1)) for i in range(_STEPS))
    node.options |= {
        "ramp": [channel for color in colors for channel in color],
        "interpolate": ramp.interpolation != "CONSTANT",
    }
