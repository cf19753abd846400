"""Coordinates of another object, and the mapping that texture nodes of old files carry."""

import bpy
import numpy as np

from .flat import Input, Node

# What a texture reads where nothing is linked to its Vector; the others read Generated.
_USUAL_COORDINATE = {
    "TEX_IMAGE": ("TEX_COORD", "UV"),
    "TEX_ENVIRONMENT": ("NEW_GEOMETRY", "Position"),
}


def name_object(node: Node) -> None:
    """Option `object_from_world`, a matrix by rows, in place of `object`."""
    shown: bpy.types.Object | None = node.options.pop("object")
    if shown is not None:
        object_from_world = np.array(shown.matrix_world.inverted_safe())
        node.options["object_from_world"] = object_from_world.ravel().tolist()


def map_texture(node: Node) -> None:
    """A Mapping node in place of `texture_mapping`, if that changes anything."""
    mapping: bpy.types.TexMapping = node.options.pop("texture_mapping")
    values = {
        "Location": tuple(mapping.translation),
        "Rotation": tuple(mapping.rotation),
        "Scale": tuple(mapping.scale),
    }
    axes = (mapping.mapping_x, mapping.mapping_y, mapping.mapping_z)
    if mapping.use_min or mapping.use_max or axes != ("X", "Y", "Z"):
        node.notes.append("limits and axes in the texture mapping of")
    if values == {"Location": (0.0,) * 3, "Rotation": (0.0,) * 3, "Scale": (1.0,) * 3}:
        return
    mapped = Node("MAPPING", "Mapping", {"vector_type": mapping.vector_type})
    mapped.inputs = {name: Input("VECTOR", value) for name, value in values.items()}
    mapped.inputs["Vector"] = coordinate_of(node)
    node.inputs["Vector"] = Input("VECTOR", source=mapped.output("Vector", "VECTOR"))


def coordinate_of(texture: Node) -> Input:
    """What is linked to a texture's Vector, or what it reads where nothing is."""
    vector = texture.inputs.get("Vector")
    if vector is not None and vector.source is not None:
        return vector
    kind, identifier = _USUAL_COORDINATE.get(texture.kind, ("TEX_COORD", "Generated"))
    return Input("VECTOR", source=Node(kind, kind).output(identifier, "VECTOR"))
