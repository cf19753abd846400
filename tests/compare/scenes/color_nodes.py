"""Nodes that change a colour or a vector, on a wall that shines with what they make."""

import bpy
from features import feature
from scenes.converters import ramp_colors, u_and_v, uv
from stage import tiles, wall
from tree import Tree, out


@feature()
def mapping():
    """Mapping of points, textures, vectors and normals"""

    def paint(kind: str):
        def turn(tree: Tree):
            inputs = {"Vector": ramp_colors(tree), "Rotation": (0.3, -0.5, 0.8)}
            inputs["Scale"] = (1.5, 0.7, 1.2)
            if kind in ("POINT", "TEXTURE"):
                inputs["Location"] = (0.1, 0.3, -0.2)
            return tree.scaled(tree.node("Mapping", inputs, vector_type=kind), 0.3, 0.4)

        return turn

    tiles([paint(kind) for kind in ("POINT", "TEXTURE", "VECTOR", "NORMAL")])


@feature()
def vector_rotate():
    """Every kind of Vector Rotate, one of them inverted"""

    def paint(kind: str, invert: bool = False):
        def turn(tree: Tree):
            node = tree.node("VectorRotate", {"Vector": ramp_colors(tree)}, rotation_type=kind)
            node.invert = invert
            tree.set(node, "Center", (0.5, 0.4, 0.3))
            tree.set(node, "Axis", (0.3, 0.4, 1.0))
            tree.set(node, "Angle", 1.1)
            tree.set(node, "Rotation", (0.4, -0.3, 0.9))
            return tree.scaled(node, 0.4, 0.3)

        return turn

    kinds = ("AXIS_ANGLE", "X_AXIS", "Y_AXIS", "Z_AXIS", "EULER_XYZ")
    tiles([*(paint(kind) for kind in kinds), paint("EULER_XYZ", True)])


@feature()
def vector_transform():
    """Vector Transform between world, object and camera"""

    def paint(kind: str, source: str, target: str):
        def turn(tree: Tree):
            node = tree.node("VectorTransform", {"Vector": ramp_colors(tree)}, vector_type=kind)
            node.convert_from, node.convert_to = source, target
            return tree.scaled(node, 0.25, 0.5)

        return turn

    ways = """VECTOR WORLD OBJECT, POINT OBJECT WORLD, NORMAL WORLD OBJECT, VECTOR WORLD CAMERA,
        POINT WORLD CAMERA, POINT CAMERA OBJECT"""
    shown = tiles([paint(*way.split()) for way in ways.split(",")])
    shown.rotation_euler = (0.2, 0.1, 0.4)
    shown.scale = (1.6, 1.3, 2.0)


@feature()
def hue_saturation():
    """Hue, Saturation and Value"""

    def paint(tree: Tree):
        inputs = {"Hue": 0.65, "Saturation": 1.4, "Value": 0.8, "Fac": 0.9}
        return tree.node("HueSaturation", {**inputs, "Color": ramp_colors(tree)})

    wall(paint)


@feature()
def bright_contrast():
    """Bright/Contrast"""
    wall(lambda tree: tree.node("BrightContrast", {"Color": ramp_colors(tree), "Bright": 0.1,
                                                   "Contrast": 0.6}))  # fmt: skip


@feature()
def gamma():
    """Gamma"""
    wall(lambda tree: tree.node("Gamma", {"Color": ramp_colors(tree), "Gamma": 2.4}))


@feature()
def invert():
    """Invert by eight tenths"""
    wall(lambda tree: tree.node("Invert", {"Color": ramp_colors(tree), "Fac": 0.8}))


@feature()
def blackbody():
    """Blackbody from 800 to 12,000 K"""

    def paint(tree: Tree):
        kelvin = tree.math("MULTIPLY_ADD", u_and_v(tree)[0], 11200.0, 800.0)
        return tree.scaled(tree.node("Blackbody", {"Temperature": kelvin}), 0.4, 0.0)

    wall(paint)


@feature()
def wavelength():
    """Wavelength from 380 to 780 nm"""

    def paint(tree: Tree):
        nanometres = tree.math("MULTIPLY_ADD", u_and_v(tree)[0], 400.0, 380.0)
        return tree.node("Wavelength", {"Wavelength": nanometres})

    wall(paint)


@feature()
def rgb_to_bw():
    """RGB to BW"""
    wall(lambda tree: tree.node("RGBToBW", {"Color": ramp_colors(tree)}))


@feature()
def conversions():
    """A colour read as a number, a vector as a number, a number as a colour"""

    def color(tree: Tree):
        gamma_of = tree.node("Gamma", {"Color": ramp_colors(tree), "Gamma": 1.0})
        return tree.math("MULTIPLY", out(gamma_of, "Color"), 1.0)

    def vector(tree: Tree):
        return tree.math("MULTIPLY", uv(tree), 1.0)

    def number(tree: Tree):
        return tree.node("Invert", {"Color": u_and_v(tree)[1], "Fac": 0.5})

    tiles([color, vector, number])


@feature()
def node_group():
    """A group within a group"""

    def socket(group, name: str, kind: str, direction: str) -> None:
        if hasattr(group, "interface"):
            group.interface.new_socket(name, in_out=direction, socket_type=kind)
        else:
            (group.inputs if direction == "INPUT" else group.outputs).new(kind, name)

    inner = bpy.data.node_groups.new("Inner", "ShaderNodeTree")
    socket(inner, "Value", "NodeSocketFloat", "INPUT")
    socket(inner, "Result", "NodeSocketFloat", "OUTPUT")
    enter, leave = inner.nodes.new("NodeGroupInput"), inner.nodes.new("NodeGroupOutput")
    square = inner.nodes.new("ShaderNodeMath")
    square.operation = "POWER"
    inner.links.new(enter.outputs[0], square.inputs[0])
    square.inputs[1].default_value = 2.0
    inner.links.new(square.outputs[0], leave.inputs[0])

    outer = bpy.data.node_groups.new("Outer", "ShaderNodeTree")
    socket(outer, "Color", "NodeSocketColor", "INPUT")
    socket(outer, "Amount", "NodeSocketFloat", "INPUT")
    socket(outer, "Color", "NodeSocketColor", "OUTPUT")
    enter, leave = outer.nodes.new("NodeGroupInput"), outer.nodes.new("NodeGroupOutput")
    nested = outer.nodes.new("ShaderNodeGroup")
    nested.node_tree = inner
    mixed = outer.nodes.new("ShaderNodeMixRGB")
    outer.links.new(enter.outputs[1], nested.inputs[0])
    outer.links.new(nested.outputs[0], mixed.inputs[0])
    outer.links.new(enter.outputs[0], mixed.inputs[1])
    outer.links.new(mixed.outputs[0], leave.inputs[0])

    def paint(tree: Tree):
        group = tree.nodes.new("ShaderNodeGroup")
        group.node_tree = outer
        group.inputs[0].default_value = (0.8, 0.2, 0.1, 1.0)
        tree.links.new(u_and_v(tree)[0], group.inputs[1])
        return group.outputs[0]

    wall(paint)


@feature()
def muted_and_rerouted():
    """A muted node, a reroute and a muted link"""

    def paint(tree: Tree):
        muted = tree.node("Gamma", {"Color": ramp_colors(tree), "Gamma": 3.0})
        muted.mute = True
        reroute = tree.nodes.new("NodeReroute")
        tree.links.new(muted.outputs[0], reroute.inputs[0])
        return reroute.outputs[0]

    def muted_link(tree: Tree):
        node = tree.node("Invert", {"Color": (0.9, 0.4, 0.1, 1.0)})
        link = tree.links.new(ramp_colors(tree), node.inputs[1])
        link.is_muted = True
        return node

    tiles([paint, muted_link])


@feature()
def rgb_and_value():
    """The RGB and Value nodes"""

    def rgb(tree: Tree):
        node = tree.node("RGB")
        node.outputs[0].default_value = (0.7, 0.3, 0.1, 1.0)
        return node

    def value(tree: Tree):
        node = tree.node("Value")
        node.outputs[0].default_value = 0.35
        return node

    tiles([rgb, value])
