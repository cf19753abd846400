"""Nodes that read a property of the object, of what instances it, of the view layer or of the
particle that places it, or where it stands on what instances it, and no layer of the mesh."""

from .flat import Node

# To the core they are all attributes, under names that no layer has.
PARTICLE_PREFIX = ".eye_render.particle."
PLACE_PREFIX = ".eye_render.place."
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
# Of nodes that are told to ask the instancer: their outputs that do.
_PLACES = ("Generated", "UV")


def name_owner(node: Node) -> None:
    prefix = OWNER_PREFIXES[node.options.pop("attribute_type")]
    node.options["attribute_name"] = prefix + node.options["attribute_name"]


def name_particle(node: Node) -> None:
    for name, output in _PARTICLE_OUTPUTS.items():
        attribute = Node("ATTRIBUTE", node.label, {"attribute_name": PARTICLE_PREFIX + name})
        node.redirected_outputs[name] = attribute.output(*output)


def name_place(node: Node) -> None:
    del node.options["from_instancer"]
    for name in _PLACES:
        attribute = Node("ATTRIBUTE", node.label, {"attribute_name": PLACE_PREFIX + name})
        node.redirected_outputs[name] = attribute.output(*_VECTOR)
