"""Converters, as tiles of all their operations on a wall that shines with what they make."""

from itertools import product

from features import feature
from stage import tiles, wall
from tree import Tree, out

COLOR_B = (0.15, 0.5, 0.7)


def uv(tree: Tree):
    return out(tree.node("TexCoord"), "UV")


def u_and_v(tree: Tree):
    parts = tree.node("SeparateXYZ", {"Vector": uv(tree)})
    return out(parts, "X"), out(parts, "Y")


def ramp_colors(tree: Tree):
    """(u, v, 1 - u) as a colour."""
    u, v = u_and_v(tree)
    return out(tree.node("CombineXYZ", {"X": u, "Y": v, "Z": tree.math("SUBTRACT", 1.0, u)}),
               "Vector")  # fmt: skip


MATH = """ADD SUBTRACT MULTIPLY DIVIDE MULTIPLY_ADD POWER LOGARITHM SQRT INVERSE_SQRT ABSOLUTE
EXPONENT MINIMUM MAXIMUM LESS_THAN GREATER_THAN SIGN COMPARE SMOOTH_MIN SMOOTH_MAX ROUND FLOOR
CEIL TRUNC FRACT MODULO WRAP SNAP PINGPONG SINE COSINE TANGENT ARCSINE ARCCOSINE ARCTANGENT
ARCTAN2 SINH COSH TANH RADIANS DEGREES""".split()


@feature()
def math():
    """Every operation of Math"""

    def paint(operation: str):
        def operate(tree: Tree):
            u, v = u_and_v(tree)
            a = tree.math("MULTIPLY_ADD", u, 3.0, -1.0)
            b = tree.math("MULTIPLY_ADD", v, 1.5, 0.1)
            result = tree.math(operation, a, b, 0.4)
            inputs = {"Value": result, "Value_001": 0.25, "Value_002": 0.4}
            shown = tree.node("Math", inputs, operation="MULTIPLY_ADD", use_clamp=True)
            return out(shown, "Value")

        return operate

    tiles([paint(operation) for operation in MATH])


@feature()
def math_clamped():
    """Math, clamped"""

    def paint(tree: Tree):
        u, v = u_and_v(tree)
        inputs = {"Value": tree.math("MULTIPLY", u, 2.0), "Value_001": v}
        node = tree.node("Math", inputs, operation="SUBTRACT", use_clamp=True)
        return out(node, "Value")

    wall(paint)


VECTOR_MATH = """ADD SUBTRACT MULTIPLY DIVIDE MULTIPLY_ADD CROSS_PRODUCT PROJECT REFLECT REFRACT
FACEFORWARD DOT_PRODUCT DISTANCE LENGTH SCALE NORMALIZE ABSOLUTE MINIMUM MAXIMUM FLOOR CEIL
FRACTION MODULO WRAP SNAP SINE COSINE TANGENT""".split()


@feature()
def vector_math():
    """Every operation of Vector Math"""

    def paint(operation: str):
        def operate(tree: Tree):
            a = tree.scaled(ramp_colors(tree), 2.0, -0.6)
            node = tree.node("VectorMath", {"Vector": a}, operation=operation)
            tree.set(node, "Vector_001", (0.6, -0.5, 0.7))
            tree.set(node, "Vector_002", (0.3, 0.2, 0.4))
            tree.set(node, "Scale", 0.7)
            result = next(socket for socket in node.outputs if socket.enabled)
            return tree.scaled(result, 0.25, 0.4)

        return operate

    tiles([paint(operation) for operation in VECTOR_MATH])


BLENDS = """MIX DARKEN MULTIPLY BURN LIGHTEN SCREEN DODGE ADD OVERLAY SOFT_LIGHT LINEAR_LIGHT
DIFFERENCE SUBTRACT DIVIDE HUE SATURATION COLOR VALUE""".split()


@feature()
def mix_color():
    """Every way to mix two colours"""

    def paint(blend: str):
        def mix(tree: Tree):
            inputs = {"Factor_Float": 0.7, "A_Color": ramp_colors(tree), "B_Color": COLOR_B}
            node = tree.node("Mix", inputs, data_type="RGBA", blend_type=blend)
            return out(node, "Result_Color")

        return mix

    tiles([paint(blend) for blend in BLENDS])


@feature(since=(4, 0))
def mix_exclusion():
    """Exclusion, the youngest way to mix two colours"""

    def paint(tree: Tree):
        inputs = {"Factor_Float": 0.7, "A_Color": ramp_colors(tree), "B_Color": COLOR_B}
        node = tree.node("Mix", inputs, data_type="RGBA", blend_type="EXCLUSION")
        return out(node, "Result_Color")

    wall(paint)


@feature()
def mix_rgb():
    """The former MixRGB, clamped"""

    def paint(blend: str):
        def mix(tree: Tree):
            inputs = {"Fac": 0.8, "Color1": ramp_colors(tree), "Color2": COLOR_B}
            node = tree.node("MixRGB", inputs, blend_type=blend, use_clamp=True)
            return out(node, "Color")

        return mix

    tiles([paint(blend) for blend in ("MIX", "ADD", "LINEAR_LIGHT", "OVERLAY")])


@feature()
def mix_values():
    """Mix of numbers and of vectors, with one factor and with three, clamped and not"""

    def numbers(tree: Tree):
        u, v = u_and_v(tree)
        inputs = {"Factor_Float": tree.math("MULTIPLY_ADD", u, 2.0, -0.5), "A_Float": v}
        node = tree.node("Mix", {**inputs, "B_Float": 0.8}, data_type="FLOAT", clamp_factor=True)
        return out(node, "Result_Float")

    def unclamped(tree: Tree):
        u, _ = u_and_v(tree)
        inputs = {"Factor_Float": tree.math("MULTIPLY_ADD", u, 2.0, -0.5), "A_Float": 0.3}
        node = tree.node("Mix", {**inputs, "B_Float": 0.6}, data_type="FLOAT", clamp_factor=False)
        return out(node, "Result_Float")

    def vectors(mode: str):
        def mix(tree: Tree):
            node = tree.node("Mix", data_type="VECTOR", factor_mode=mode)
            tree.set(node, "Factor_Float", 0.3)
            tree.set(node, "Factor_Vector", (0.1, 0.5, 0.9))
            tree.set(node, "A_Vector", ramp_colors(tree))
            tree.set(node, "B_Vector", (0.2, 0.9, 0.4))
            return out(node, "Result_Vector")

        return mix

    tiles([numbers, unclamped, vectors("UNIFORM"), vectors("NON_UNIFORM")])


@feature()
def map_range():
    """Every interpolation of Map Range, of numbers and of vectors"""

    def number(interpolation: str):
        def paint(tree: Tree):
            inputs = {"Value": u_and_v(tree)[0], "From Min": 0.2, "From Max": 0.7}
            inputs |= {"To Min": 0.9, "To Max": 0.1, "Steps": 3.0}
            node = tree.node("MapRange", interpolation_type=interpolation, clamp=True)
            for name, value in inputs.items():
                tree.set(node, name, value)
            return out(node, "Result")

        return paint

    def vector(interpolation: str):
        def paint(tree: Tree):
            node = tree.node("MapRange", data_type="FLOAT_VECTOR",
                             interpolation_type=interpolation, clamp=False)  # fmt: skip
            inputs = {"From_Min_FLOAT3": (0.1, 0.2, 0.3), "From_Max_FLOAT3": (0.9, 0.7, 0.8)}
            inputs |= {"To_Min_FLOAT3": (0.1, 0.5, 0.2), "To_Max_FLOAT3": (0.7, 0.2, 0.9)}
            for name, value in {"Vector": ramp_colors(tree), **inputs}.items():
                tree.set(node, name, value)
            tree.set(node, "Steps_FLOAT3", (4.0, 3.0, 5.0))
            return out(node, "Vector")

        return paint

    kinds = ("LINEAR", "STEPPED", "SMOOTHSTEP", "SMOOTHERSTEP")
    tiles([make(kind) for make, kind in product((number, vector), kinds)], 4)


@feature()
def clamp():
    """Clamp between two numbers, in order or not"""

    def paint(kind: str):
        def limit(tree: Tree):
            inputs = {"Value": u_and_v(tree)[0], "Min": 0.7, "Max": 0.3}
            return out(tree.node("Clamp", inputs, clamp_type=kind), "Result")

        return limit

    tiles([paint("MINMAX"), paint("RANGE")])


STOPS = ((0.1, (0.05, 0.1, 0.4)), (0.35, (0.9, 0.2, 0.1)), (0.6, (0.9, 0.9, 0.3)),
         (0.85, (0.1, 0.6, 0.3)))  # fmt: skip


def color_ramp(interpolation: str, mode: str = "RGB", hue: str = "NEAR"):
    def paint(tree: Tree):
        node = tree.node("ValToRGB", {"Fac": u_and_v(tree)[0]})
        ramp = node.color_ramp
        ramp.color_mode, ramp.interpolation, ramp.hue_interpolation = mode, interpolation, hue
        for _ in STOPS[2:]:
            ramp.elements.new(0.5)
        for element, (position, color) in zip(ramp.elements, STOPS, strict=True):
            element.position, element.color = position, (*color, 1.0)
        return out(node, "Color")

    return paint


@feature()
def color_ramp_interpolations():
    """Colour Ramp: every interpolation"""
    tiles([color_ramp(kind) for kind in ("CONSTANT", "LINEAR", "EASE", "CARDINAL", "B_SPLINE")], 1)


@feature()
def color_ramp_hues():
    """Colour Ramp by hue: near, far, clockwise, counter-clockwise, and HSL"""
    tiles([*(color_ramp("LINEAR", "HSV", hue) for hue in ("NEAR", "FAR", "CW", "CCW")),
           color_ramp("LINEAR", "HSL")], 1)  # fmt: skip


def _bend(curve, *points) -> None:
    for _ in points[2:]:
        curve.points.new(0.5, 0.5)
    for point, place in zip(curve.points, points, strict=True):
        point.location = place


@feature()
def rgb_curves():
    """RGB Curves, one of each colour and the common one"""

    def paint(tree: Tree):
        node = tree.node("RGBCurve", {"Color": ramp_colors(tree), "Fac": 0.9})
        _bend(node.mapping.curves[0], (0, 0.1), (0.5, 0.9), (1, 0.6))
        _bend(node.mapping.curves[2], (0, 0), (0.3, 0.5), (1, 1))
        _bend(node.mapping.curves[3], (0, 0), (0.4, 0.2), (1, 0.95))
        node.mapping.update()
        return out(node, "Color")

    wall(paint)


@feature()
def vector_curves():
    """Vector Curves"""

    def paint(tree: Tree):
        node = tree.node("VectorCurve", {"Vector": tree.scaled(ramp_colors(tree), 2.4, -1.2)})
        _bend(node.mapping.curves[0], (-1, -0.5), (0, 0.8), (1, 0.2))
        _bend(node.mapping.curves[1], (-1, -1), (0.3, -0.2), (1, 1))
        node.mapping.update()
        return tree.scaled(node, 0.4, 0.5)

    wall(paint)


@feature()
def float_curve():
    """Float Curve"""

    def paint(tree: Tree):
        node = tree.node("FloatCurve", {"Factor": 0.8, "Value": u_and_v(tree)[0]})
        _bend(node.mapping.curves[0], (0, 0.2), (0.4, 0.9), (0.7, 0.1), (1, 0.8))
        node.mapping.update()
        return out(node, "Value")

    wall(paint)


@feature()
def separate_combine_color():
    """Separate and Combine Color by RGB, HSV and HSL, one part changed"""

    def paint(mode: str):
        def turn(tree: Tree):
            parts = tree.node("SeparateColor", {"Color": ramp_colors(tree)}, mode=mode)
            red = tree.math("FRACT", tree.math("ADD", out(parts, "Red"), 0.3))
            inputs = {"Red": red, "Green": out(parts, "Green"), "Blue": out(parts, "Blue")}
            return out(tree.node("CombineColor", inputs, mode=mode), "Color")

        return turn

    tiles([paint(mode) for mode in ("RGB", "HSV", "HSL")])


@feature()
def separate_combine_former():
    """The former Separate and Combine RGB and HSV, where Blender has them"""
    sockets = {"RGB": ("Image", "RGB"), "HSV": ("Color", "HSV")}

    def paint(mode: str):
        def turn(tree: Tree):
            try:
                parts = tree.node(f"Separate{mode}")
            except KeyError:  # gone from Blender 5.2
                return paint_now(mode)(tree)
            whole, names = sockets[mode]
            tree.set(parts, whole, ramp_colors(tree))
            again = tree.node(f"Combine{mode}")
            for name, other in zip(names, names[1:] + names[:1], strict=True):
                tree.set(again, name, out(parts, other))
            return out(again, whole)

        return turn

    def paint_now(mode: str):
        def turn(tree: Tree):
            parts = tree.node("SeparateColor", {"Color": ramp_colors(tree)}, mode=mode)
            inputs = {"Red": out(parts, "Green"), "Green": out(parts, "Blue")}
            inputs["Blue"] = out(parts, "Red")
            return out(tree.node("CombineColor", inputs, mode=mode), "Color")

        return turn

    tiles([paint("RGB"), paint("HSV")])


@feature()
def separate_combine_xyz():
    """Separate and Combine XYZ, the parts exchanged"""

    def paint(tree: Tree):
        parts = tree.node("SeparateXYZ", {"Vector": ramp_colors(tree)})
        inputs = {"X": out(parts, "Y"), "Y": out(parts, "Z"), "Z": out(parts, "X")}
        return out(tree.node("CombineXYZ", inputs), "Vector")

    wall(paint)
