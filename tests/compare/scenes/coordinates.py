"""Texture coordinates, UV maps and attributes."""

import numpy as np
from features import feature
from stage import add, painted_ball
from tree import out


def reads(kind: str, output: str, factor: float = 0.5, offset: float = 0.5, **properties):
    """Paints with one output of an input node, brought between 0 and 1."""
    return lambda tree: tree.scaled(out(tree.node(kind, **properties), output), factor, offset)


@feature()
def generated():
    """Generated coordinates of a ball that is turned and stretched"""
    shown = painted_ball(reads("TexCoord", "Generated", 1.0, 0.0))
    shown.rotation_euler, shown.scale = (0.3, 0.4, 0.5), (1, 0.7, 1.2)


@feature()
def own_object():
    """Coordinates of the object"""
    painted_ball(reads("TexCoord", "Object")).rotation_euler = (0.3, 0.4, 0.5)


@feature()
def other_object():
    """Coordinates of another object"""
    empty = add(None, (0.5, -0.5, 1.2))
    empty.rotation_euler, empty.scale = (0.3, 0.4, 0.5), (2, 1, 1)
    painted_ball(reads("TexCoord", "Object", object=empty))


@feature()
def normal():
    """Normals of the object"""
    painted_ball(reads("TexCoord", "Normal")).rotation_euler = (0.3, 0.4, 0.5)


@feature()
def uv():
    """UVs of the active layer"""
    painted_ball(reads("TexCoord", "UV", 1.0, 0.0))


@feature()
def camera():
    """Coordinates of the camera"""
    painted_ball(reads("TexCoord", "Camera", 0.2, 0.0))


@feature()
def window():
    """Place in the picture"""
    painted_ball(reads("TexCoord", "Window", 1.0, 0.0))


@feature()
def reflection():
    """The direction of reflection"""
    painted_ball(reads("TexCoord", "Reflection"))


@feature()
def uv_map():
    """A second UV layer by its name"""
    shown = painted_ball(reads("UVMap", "UV", 1.0, 0.0, uv_map="Second"))
    mesh = shown.data
    first = np.empty(2 * len(mesh.loops), np.float32)
    mesh.uv_layers[0].data.foreach_get("uv", first)
    mesh.uv_layers.new(name="Second").data.foreach_set("uv", 1.0 - first)


@feature()
def attribute_of_points():
    """A vector attribute of the vertices"""
    shown = painted_ball(reads("Attribute", "Vector", attribute_name="flow"))
    places = np.empty(3 * len(shown.data.vertices), np.float32)
    shown.data.vertices.foreach_get("co", places)
    flow = shown.data.attributes.new("flow", "FLOAT_VECTOR", "POINT")
    flow.data.foreach_set("vector", np.sin(4.0 * places))


@feature()
def attribute_of_faces():
    """A number attribute of the faces"""
    shown = painted_ball(reads("Attribute", "Fac", 1.0, 0.0, attribute_name="level"))
    level = shown.data.attributes.new("level", "FLOAT", "FACE")
    count = len(shown.data.polygons)
    level.data.foreach_set("value", np.random.default_rng(1).random(count).astype(np.float32))


@feature()
def attribute_of_object():
    """A property of the object"""
    names = {"attribute_type": "OBJECT", "attribute_name": "tone"}
    painted_ball(reads("Attribute", "Fac", 1.0, 0.0, **names))["tone"] = 0.4


@feature()
def color_attribute():
    """A colour attribute of the corners"""
    shown = painted_ball(reads("VertexColor", "Color", 1.0, 0.0, layer_name="Paint"))
    mesh = shown.data
    uvs = np.empty(2 * len(mesh.loops), np.float32)
    mesh.uv_layers[0].data.foreach_get("uv", uvs)
    colors = np.ones((len(mesh.loops), 4), np.float32)
    colors[:, :2] = uvs.reshape(-1, 2)
    paint = mesh.color_attributes.new("Paint", "FLOAT_COLOR", "CORNER")
    paint.data.foreach_set("color", colors.ravel())
