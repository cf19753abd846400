"""Nodes that read a property of the object, of what instances it, of the view layer or of the
particle that places it, and no layer of the mesh."""

from .flat import Node

# To the core they are all attributes, under names that no layer has.
PARTICLE_PREFIX = ".eye_render.particle."
# By the Attribute node's attribute_type.
OWNER_PREFIXES = {
    "OBJECT": ".eye_render.object.",
    "INSTANCER": ".eye_render.instancer.",
    "VIEW_LAYER": ".eye_render.view_layer.",
}
# Which output of the Attribute node has what the Particle Info node gives.
_NUMBER, _VECTOR = ("Fac", "VALUE"), ("Vector", "VECTOR")
_PARTICLE_OUTPUTS = {
    **dict.fromkeys(("Index", "Random", "Age", "Lifetime", "Size"), _NUMBER),
    **dict.fromkeys(("Location", "Velocity", "Angular Velocity"), _VECTOR),
}


def name_owner(node: Node) -> None:
    prefix = OWNER_PREFIXES[node.options.pop("attribute_type")]
    node.options["attribute_name"] = prefix + node.options["attribute_name"]


def name_particle(node: Node) -> None:
    for name, output in _PARTICLE_OUTPUTS.items():
        attribute = Node("ATTRIBUTE", node.label, {"attribute_name": PARTICLE_PREFIX + name})
        node.redirected_outputs[name] = attribute.output(*output)
