"""Outputs of the Geometry node that are worked out once a mesh, and read as its attributes."""

from .flat import Node

# The output, and the attribute's name: no user's attribute begins so.
ATTRIBUTES = {
    "Pointiness": ".eye_render.pointiness",
    "Random Per Island": ".eye_render.island",
}


def read_derived_attributes(node: Node) -> None:
    for identifier, name in ATTRIBUTES.items():
        attribute = Node("ATTRIBUTE", node.label, {"attribute_name": name})
        node.redirected_outputs[identifier] = attribute.output("Fac", "VALUE")
