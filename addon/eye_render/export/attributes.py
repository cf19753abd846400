"""Attributes of a mesh that materials read by name, as four numbers a triangle corner."""

import bpy
import numpy as np

from .. import compat
from .derived_attributes import island_randoms, pointiness
from .nodes import DERIVED_ATTRIBUTES
from .tangents import tangents_at_corners

# The member of an attribute's items that holds the numbers, how many there are, and their type.
_MEMBERS = {
    "FLOAT": ("value", 1, np.float32),
    "INT": ("value", 1, np.int32),
    "INT8": ("value", 1, np.int32),
    "BOOLEAN": ("value", 1, bool),
    "FLOAT2": ("vector", 2, np.float32),
    "FLOAT_VECTOR": ("vector", 3, np.float32),
    "QUATERNION": ("value", 4, np.float32),
    "FLOAT_COLOR": ("color", 4, np.float32),
    "BYTE_COLOR": ("color", 4, np.float32),
}

# Ends the name of what has the tangents of a UV layer; without the layer's, of the active one.
TANGENT = ".tangent"

_DERIVED = {
    DERIVED_ATTRIBUTES["Pointiness"]: pointiness,
    DERIVED_ATTRIBUTES["Random Per Island"]: island_randoms,
}


def attributes_at_corners(
    mesh: bpy.types.Mesh, corners: np.ndarray, triangles: np.ndarray, names: list[str]
) -> dict[str, np.ndarray]:
    """Those of the names that the mesh has: numbers in all of RGB, vectors and linear colours.

    The name "" is the colour attribute that Blender renders.
    """
    found = {name: _attribute(mesh, corners, triangles, name) for name in names}
    return {name: values for name, values in found.items() if values is not None}


def _attribute(
    mesh: bpy.types.Mesh, corners: np.ndarray, triangles: np.ndarray, name: str
) -> np.ndarray | None:
    if name in _DERIVED:
        return _rgba(_DERIVED[name](mesh)[:, None])[triangles.ravel()]
    if name.endswith(TANGENT):
        return tangents_at_corners(mesh, corners, name.removesuffix(TANGENT))
    if name in mesh.uv_layers:  # attributes only since Blender 3.5
        return _rgba(compat.corner_uvs(mesh.uv_layers[name]))[corners.ravel()]
    attribute = mesh.attributes.get(name) if name else _render_color(mesh)
    domain = attribute.domain if attribute else ""
    return attribute_values(
        attribute, {domain: _items_at_corners(mesh, corners, triangles, domain)}
    )


def attribute_values(
    attribute: bpy.types.Attribute | None, items_by_domain: dict[str, np.ndarray | None]
) -> np.ndarray | None:
    """(n, 4) of the items that its domain's n places have; None for one that is not to be had."""
    if attribute is None or attribute.data_type not in _MEMBERS:
        return None
    items = items_by_domain.get(attribute.domain)
    if items is None:
        return None
    member, width, number_type = _MEMBERS[attribute.data_type]
    values = np.empty((len(attribute.data), width), number_type)
    attribute.data.foreach_get(member, values.ravel())
    return _rgba(values.astype(np.float32))[items]


def _render_color(mesh: bpy.types.Mesh) -> bpy.types.Attribute | None:
    index = mesh.color_attributes.render_color_index
    return mesh.color_attributes[index] if 0 <= index < len(mesh.color_attributes) else None


def _items_at_corners(
    mesh: bpy.types.Mesh, corners: np.ndarray, triangles: np.ndarray, domain: str
) -> np.ndarray | None:
    """Which item of an attribute belongs to each triangle corner; None for one on edges."""
    if domain == "POINT":
        return triangles.ravel()
    if domain == "CORNER":
        return corners.ravel()
    if domain != "FACE":
        return None
    faces = np.empty(len(corners), np.int32)
    mesh.loop_triangles.foreach_get("polygon_index", faces)
    return np.repeat(faces, 3)


def _rgba(values: np.ndarray) -> np.ndarray:
    """(n, 4): one number fills all colours, what is missing of a vector is 0 and of alpha 1."""
    count, width = values.shape
    rgba = np.zeros((count, 4), np.float32)
    rgba[:, 3] = 1.0
    if width == 1:
        rgba[:, :3] = values
    else:
        rgba[:, :width] = values
    return rgba
