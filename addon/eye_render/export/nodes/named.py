"""Attribute nodes that read a property of the object, of what instances it or of the view layer,
and no layer of the mesh."""

from .flat import Node

# By the node's attribute_type. To the core they are attributes, under names that no layer has.
OWNER_PREFIXES = {
    "OBJECT": ".eye_render.object.",
    "INSTANCER": ".eye_render.instancer.",
    "VIEW_LAYER": ".eye_render.view_layer.",
}


def name_owner(node: Node) -> None:
    prefix = OWNER_PREFIXES[node.options.pop("attribute_type")]
    node.options["attribute_name"] = prefix + node.options["attribute_name"]
