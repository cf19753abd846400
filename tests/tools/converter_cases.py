"""The cases of converter_references.py: which nodes, with which options, on which inputs."""

import random
import struct
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

INF, NAN = float("inf"), float("nan")
EDGES = [0.0, 1.0, -1.0, 0.5, -0.5, 2.0, -2.0, 3.0, 1e-8, 1e20, -1e20, 3e38, INF, -INF, NAN]

Options = dict[str, float | str | list[float]]


def shuffled(seed: int, rows: int, edges: list[float], low: float, high: float) -> list[float]:
    """The edges, filled up with numbers between, in an order of their own."""
    source = random.Random(seed)
    values = [*edges, *(round(source.uniform(low, high), 4) for _ in range(rows - len(edges)))]
    source.shuffle(values)
    return values


def channels(rows: int) -> dict[str, list]:
    def vectors(seed: int, edges: list[float], low: float, high: float) -> list:
        parts = [shuffled(seed + i, rows, edges, low, high) for i in range(3)]
        return [list(row) for row in zip(*parts, strict=True)]

    tame = [0.0, 1.0, -1.0, 0.5]
    colors = [0.0, 0.0, 1.0, 1.0, 0.5, 0.5, -0.25, 4.0, 1e20, INF, NAN]
    return {
        "a": shuffled(1, rows, EDGES, -3.0, 3.0),
        "b": shuffled(2, rows, EDGES, -3.0, 3.0),
        "c": shuffled(3, rows, EDGES, -3.0, 3.0),
        "d": shuffled(4, rows, tame, -2.0, 2.0),
        "e": shuffled(5, rows, tame, -2.0, 2.0),
        "steps": shuffled(6, rows, [0.0, -1.0, 1.0, 2.0, 0.5], 0.0, 8.0),
        "factor": shuffled(7, rows, [0.0, 1.0, 0.5, -0.5, 1.5, INF, NAN], 0.0, 1.0),
        "angle": shuffled(8, rows, [0.0, 1.0, -1.0], -4.0, 4.0),
        "kelvin": shuffled(9, rows, [0.0, -5.0, 799.0, 800.0, 1e9, INF, NAN], 800.0, 14000.0),
        "nanometres": shuffled(
            10, rows, [0.0, -5.0, 379.9, 380.0, 779.9, 780.0, 1e20, INF, NAN], 375.0, 785.0
        ),
        "u": vectors(20, EDGES, -3.0, 3.0),
        "v": vectors(30, EDGES, -3.0, 3.0),
        "w": vectors(40, EDGES, -3.0, 3.0),
        "p": vectors(50, tame, -2.0, 2.0),
        "q": vectors(60, tame, -2.0, 2.0),
        "r": vectors(70, tame, -4.0, 4.0),
        "rgb": vectors(80, colors, 0.0, 1.0),
        "other_rgb": vectors(90, colors, 0.0, 1.0),
    }


@dataclass(frozen=True)
class Case:
    node_type: str  # node.type
    blender_type: str  # its bl_idname
    inputs: dict[str, str]  # channel of each socket's identifier
    outputs: tuple[str, ...]
    options: Options = field(default_factory=dict)
    prepare: Callable = lambda node: None  # sets what is no plain property
    measure: Callable | None = None  # the options that say what `prepare` set

    def apply(self, node) -> None:
        for name, value in self.options.items():
            setattr(node, name, value)
        self.prepare(node)

    def options_of_blender(self, bpy) -> Options:
        """With what only Blender knows, as the curve that points make."""
        if not self.measure:
            return self.options
        material = bpy.data.materials.new("measure")
        material.use_nodes = True
        node = material.node_tree.nodes.new(self.blender_type)
        self.apply(node)
        return {**self.options, **self.measure(node)}


def numbers() -> Iterator[Case]:
    def math(**options) -> Case:
        inputs = {"Value": "a", "Value_001": "b", "Value_002": "c"}
        return Case("MATH", "ShaderNodeMath", inputs, ("Value",), options)

    for operation in (
        "ADD SUBTRACT MULTIPLY DIVIDE MULTIPLY_ADD POWER LOGARITHM SQRT INVERSE_SQRT ABSOLUTE "
        "EXPONENT MINIMUM MAXIMUM LESS_THAN GREATER_THAN SIGN COMPARE SMOOTH_MIN SMOOTH_MAX ROUND "
        "FLOOR CEIL TRUNC FRACT MODULO FLOORED_MODULO WRAP SNAP PINGPONG SINE COSINE TANGENT "
        "ARCSINE ARCCOSINE ARCTANGENT ARCTAN2 SINH COSH TANH RADIANS DEGREES"
    ).split():
        yield math(operation=operation)
    yield math(operation="MULTIPLY", use_clamp=True)

    scalar = {"Value": "a", "From Min": "d", "From Max": "e", "To Min": "b", "To Max": "c"}
    vector = {
        "Vector": "u",
        "From_Min_FLOAT3": "p",
        "From_Max_FLOAT3": "q",
        "To_Min_FLOAT3": "v",
        "To_Max_FLOAT3": "w",
        "Steps_FLOAT3": "r",
    }
    for kind in ("LINEAR", "STEPPED", "SMOOTHSTEP", "SMOOTHERSTEP"):
        for clamp in (False, True):
            options = {"interpolation_type": kind, "clamp": clamp}
            inputs = {**scalar, "Steps": "steps"}
            yield Case("MAP_RANGE", "ShaderNodeMapRange", inputs, ("Result",), options)
            options = {"data_type": "FLOAT_VECTOR", **options}
            yield Case("MAP_RANGE", "ShaderNodeMapRange", vector, ("Vector",), options)
    for kind in ("MINMAX", "RANGE"):
        inputs = {"Value": "a", "Min": "d", "Max": "e"}
        yield Case("CLAMP", "ShaderNodeClamp", inputs, ("Result",), {"clamp_type": kind})


def vectors() -> Iterator[Case]:
    for operation in (
        "ADD SUBTRACT MULTIPLY DIVIDE MULTIPLY_ADD CROSS_PRODUCT PROJECT REFLECT REFRACT "
        "FACEFORWARD DOT_PRODUCT DISTANCE LENGTH SCALE NORMALIZE ABSOLUTE MINIMUM MAXIMUM FLOOR "
        "CEIL FRACTION MODULO WRAP SNAP SINE COSINE TANGENT"
    ).split():
        inputs = {"Vector": "u", "Vector_001": "v", "Vector_002": "w", "Scale": "d"}
        output = "Value" if operation in ("DOT_PRODUCT", "DISTANCE", "LENGTH") else "Vector"
        options = {"operation": operation}
        yield Case("VECT_MATH", "ShaderNodeVectorMath", inputs, (output,), options)
    for kind in ("POINT", "TEXTURE", "VECTOR", "NORMAL"):
        inputs = {"Vector": "u", "Location": "p", "Rotation": "r", "Scale": "q"}
        if kind in ("VECTOR", "NORMAL"):
            del inputs["Location"]
        options = {"vector_type": kind}
        yield Case("MAPPING", "ShaderNodeMapping", inputs, ("Vector",), options)
    for kind in ("AXIS_ANGLE", "X_AXIS", "Y_AXIS", "Z_AXIS", "EULER_XYZ"):
        for invert in (False, True):
            inputs = {"Vector": "p", "Center": "q"}
            if kind == "EULER_XYZ":
                inputs["Rotation"] = "r"
            else:
                inputs["Angle"] = "angle"
            if kind == "AXIS_ANGLE":
                inputs["Axis"] = "v"
            options = {"rotation_type": kind, "invert": invert}
            yield Case("VECTOR_ROTATE", "ShaderNodeVectorRotate", inputs, ("Vector",), options)
    yield Case("COMBXYZ", "ShaderNodeCombineXYZ", {"X": "a", "Y": "b", "Z": "c"}, ("Vector",))
    yield Case("SEPXYZ", "ShaderNodeSeparateXYZ", {"Vector": "u"}, ("X", "Y", "Z"))

    def set_normal(node) -> None:
        node.outputs["Normal"].default_value = (0.6, -0.48, 0.64)

    def read_normal(node) -> Options:
        return {"value": list(node.outputs["Normal"].default_value)}

    yield Case(
        "NORMAL",
        "ShaderNodeNormal",
        {"Normal": "u"},
        ("Normal", "Dot"),
        prepare=set_normal,
        measure=read_normal,
    )


def spaces() -> Iterator[Case]:
    for kind in ("POINT", "VECTOR", "NORMAL"):
        for origin in ("WORLD", "OBJECT", "CAMERA"):
            for aim in ("WORLD", "OBJECT", "CAMERA"):
                options = {"vector_type": kind, "convert_from": origin, "convert_to": aim}
                yield Case(
                    "VECT_TRANSFORM",
                    "ShaderNodeVectorTransform",
                    {"Vector": "p"},
                    ("Vector",),
                    options,
                )
    yield Case(
        "LIGHT_FALLOFF",
        "ShaderNodeLightFalloff",
        {"Strength": "d", "Smooth": "steps"},
        ("Quadratic", "Linear", "Constant"),
    )


def models() -> Iterator[Case]:
    channels_of_color = {"Red": "d", "Green": "factor", "Blue": "e"}
    parts = ("Red", "Green", "Blue")
    for mode in ("RGB", "HSV", "HSL"):
        options = {"mode": mode}
        yield Case(
            "COMBINE_COLOR", "ShaderNodeCombineColor", channels_of_color, ("Color",), options
        )
        yield Case("SEPARATE_COLOR", "ShaderNodeSeparateColor", {"Color": "rgb"}, parts, options)
    yield Case("COMBRGB", "ShaderNodeCombineRGB", {"R": "a", "G": "b", "B": "c"}, ("Image",))
    yield Case("SEPRGB", "ShaderNodeSeparateRGB", {"Image": "rgb"}, ("R", "G", "B"))
    yield Case("COMBHSV", "ShaderNodeCombineHSV", {"H": "d", "S": "factor", "V": "e"}, ("Color",))
    yield Case("SEPHSV", "ShaderNodeSeparateHSV", {"Color": "rgb"}, ("H", "S", "V"))
    yield Case("RGBTOBW", "ShaderNodeRGBToBW", {"Color": "rgb"}, ("Val",))
    yield Case("BLACKBODY", "ShaderNodeBlackbody", {"Temperature": "kelvin"}, ("Color",))
    yield Case("WAVELENGTH", "ShaderNodeWavelength", {"Wavelength": "nanometres"}, ("Color",))


BLEND_TYPES = (
    "MIX DARKEN MULTIPLY BURN LIGHTEN SCREEN DODGE ADD OVERLAY SOFT_LIGHT LINEAR_LIGHT DIFFERENCE "
    "EXCLUSION SUBTRACT DIVIDE HUE SATURATION COLOR VALUE"
).split()


def mixes() -> Iterator[Case]:
    def mix(inputs: dict[str, str], output: str, **options) -> Case:
        return Case("MIX", "ShaderNodeMix", inputs, (output,), options)

    for clamp in (False, True):
        inputs = {"Factor_Float": "factor", "A_Float": "a", "B_Float": "b"}
        yield mix(inputs, "Result_Float", data_type="FLOAT", clamp_factor=clamp)
        inputs = {"Factor_Float": "factor", "A_Vector": "u", "B_Vector": "v"}
        options = {"data_type": "VECTOR", "clamp_factor": clamp}
        yield mix(inputs, "Result_Vector", **options)
        inputs = {"Factor_Vector": "rgb", "A_Vector": "u", "B_Vector": "v"}
        yield mix(inputs, "Result_Vector", **options, factor_mode="NON_UNIFORM")
    inputs = {"Factor_Float": "factor", "A_Color": "rgb", "B_Color": "other_rgb"}
    for blend in BLEND_TYPES:
        options = {"data_type": "RGBA", "blend_type": blend}
        yield mix(inputs, "Result_Color", **options, clamp_factor=False, clamp_result=False)
        yield mix(inputs, "Result_Color", **options, clamp_factor=True, clamp_result=True)
    inputs = {"Fac": "factor", "Color1": "rgb", "Color2": "other_rgb"}
    for clamp in (False, True):
        options = {"blend_type": "LINEAR_LIGHT", "use_clamp": clamp}
        yield Case("MIX_RGB", "ShaderNodeMixRGB", inputs, ("Color",), options)


def adjustments() -> Iterator[Case]:
    inputs = {"Hue": "d", "Saturation": "steps", "Value": "e", "Fac": "factor", "Color": "rgb"}
    yield Case("HUE_SAT", "ShaderNodeHueSaturation", inputs, ("Color",))
    inputs = {"Color": "rgb", "Bright": "d", "Contrast": "e"}
    yield Case("BRIGHTCONTRAST", "ShaderNodeBrightContrast", inputs, ("Color",))
    yield Case("GAMMA", "ShaderNodeGamma", {"Color": "rgb", "Gamma": "steps"}, ("Color",))
    yield Case("INVERT", "ShaderNodeInvert", {"Color": "rgb", "Fac": "factor"}, ("Color",))


TABLE = 257  # as many samples as Cycles takes


def float32(value: float) -> float:
    """The shortest decimal that is the same float."""
    return next(x for x in (float(f"{value:.{n}g}") for n in range(1, 18)) if fits(x, value))


def fits(x: float, value: float) -> bool:
    return struct.pack("f", x) == struct.pack("f", value)


def measure_curve(node) -> Options:
    mapping = node.mapping
    mapping.initialize()
    curves = list(mapping.curves)
    first = min(curve.points[0].location.x for curve in curves)
    last = max(curve.points[-1].location.x for curve in curves)
    places = [first + (last - first) * i / (TABLE - 1) for i in range(TABLE)]
    combined = curves.pop() if len(curves) == 4 else None

    def value(curve, place: float) -> float:
        return mapping.evaluate(curve, mapping.evaluate(combined, place) if combined else place)

    return {
        "curve": [float32(value(curve, place)) for curve in curves for place in places],
        "curve_min": first,
        "curve_max": last,
        "extrapolate": mapping.extend == "EXTRAPOLATED",
    }


def bend(extend: str, *, bent_ends: bool) -> Callable:
    def prepare(node) -> None:
        mapping = node.mapping
        mapping.extend = extend
        for i, curve in enumerate(mapping.curves):
            if bent_ends:
                curve.points[0].location = (curve.points[0].location.x + 0.1 * i, 0.1)
            curve.points[-1].location.y = 0.8 - 0.1 * i
            curve.points.new(0.4, 0.7 - 0.2 * i)
        mapping.update()

    return prepare


def measure_ramp(node) -> Options:
    ramp = node.color_ramp
    values = [v for i in range(TABLE) for v in ramp.evaluate(i / (TABLE - 1))]
    return {
        "ramp": [float32(value) for value in values],
        "interpolate": ramp.interpolation != "CONSTANT",
    }


def color_stops(interpolation: str, mode: str) -> Callable:
    def prepare(node) -> None:
        ramp = node.color_ramp
        ramp.color_mode = mode
        if mode == "RGB":
            ramp.interpolation = interpolation
        else:
            ramp.hue_interpolation = interpolation
        ramp.elements[0].color = (0.9, 0.2, 0.1, 0.5)
        ramp.elements[1].position = 0.8
        ramp.elements.new(0.3).color = (0.05, 0.4, 1.0, 1.0)

    return prepare


def tables() -> Iterator[Case]:
    for extend in ("HORIZONTAL", "EXTRAPOLATED"):
        for node, kind, inputs, output in (
            ("CURVE_FLOAT", "ShaderNodeFloatCurve", {"Factor": "factor", "Value": "a"}, "Value"),
            ("CURVE_VEC", "ShaderNodeVectorCurve", {"Fac": "factor", "Vector": "u"}, "Vector"),
            ("CURVE_RGB", "ShaderNodeRGBCurve", {"Fac": "factor", "Color": "rgb"}, "Color"),
        ):
            yield Case(
                node,
                kind,
                inputs,
                (output,),
                prepare=bend(extend, bent_ends=extend == "EXTRAPOLATED"),
                measure=measure_curve,
            )
    for interpolation, mode in (("LINEAR", "RGB"), ("CONSTANT", "RGB"), ("FAR", "HSV")):
        yield Case(
            "VALTORGB",
            "ShaderNodeValToRGB",
            {"Fac": "factor"},
            ("Color", "Alpha"),
            prepare=color_stops(interpolation, mode),
            measure=measure_ramp,
        )


def cases() -> Iterator[Case]:
    for family in (numbers, vectors, spaces, models, mixes, adjustments, tables):
        yield from family()
