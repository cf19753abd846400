"""Writes node trees in few words, the same in Blender 3.4 to 5.2."""

import bpy

# What a node was called before; the first that Blender knows is taken.
FORMER_NODES = {"BsdfSheen": "BsdfVelvet"}

# What Blender 4 starts nodes with, and a Blender before otherwise.
STARTING_INPUTS = {"BsdfAnisotropic": {"Anisotropy": 0.0}}
_MULTIPLE = {"distribution": "MULTI_GGX"}
STARTING_PROPERTIES = {
    "BsdfPrincipled": _MULTIPLE,
    "BsdfAnisotropic": _MULTIPLE,
    "BsdfGlass": _MULTIPLE,
}

# What a socket was called before Blender 4.0 (by identifier).
FORMER_SOCKETS = {
    "Subsurface Weight": "Subsurface",
    "Specular IOR Level": "Specular",
    "Transmission Weight": "Transmission",
    "Coat Weight": "Clearcoat",
    "Coat Roughness": "Clearcoat Roughness",
    "Coat Normal": "Clearcoat Normal",
    "Sheen Weight": "Sheen",
    "Emission Color": "Emission",
}

# Methods of subsurface scattering as Blender 4 has them, under the names of before and since.
WALK = ("RANDOM_WALK_FIXED_RADIUS", "RANDOM_WALK_LEGACY", "RANDOM_WALK")
SKIN = ("RANDOM_WALK_SKIN", "RANDOM_WALK")


class Tree:
    """The nodes of a material, world or light, emptied when wrapped."""

    def __init__(self, datablock: bpy.types.ID):
        if not datablock.node_tree:  # from Blender 5.0 there always is one
            datablock.use_nodes = True
        self.datablock = datablock
        self.nodes = datablock.node_tree.nodes
        self.links = datablock.node_tree.links
        self.nodes.clear()
        kind = {bpy.types.World: "World", bpy.types.Material: "Material"}.get(type(datablock))
        self.output = self.nodes.new(f"ShaderNodeOutput{kind or 'Light'}")

    def node(self, kind: str, inputs: dict | None = None, **properties) -> bpy.types.Node:
        """A node of `ShaderNode<kind>`. An input is a value, or a socket or node to link from; a
        property given as a tuple of names takes the first that Blender knows."""
        try:
            node = self.nodes.new(f"ShaderNode{kind}")
        except RuntimeError:
            node = self.nodes.new(f"ShaderNode{FORMER_NODES[kind]}")
        for name, value in (STARTING_PROPERTIES.get(kind, {}) | properties).items():
            set_property(node, name, value)
        for identifier, value in (STARTING_INPUTS.get(kind, {}) | (inputs or {})).items():
            self.set(node, identifier, value)
        return node

    def set(self, node: bpy.types.Node, identifier: str, value) -> None:
        socket = socket_of(node.inputs, identifier)
        if isinstance(value, bpy.types.Node):
            value = value.outputs[0]
        if isinstance(value, bpy.types.NodeSocket):
            self.links.new(value, socket)
        elif socket.type == "RGBA" and len(value) == 3:
            socket.default_value = (*value, 1.0)
        else:
            socket.default_value = value

    def surface(self, kind: str, inputs: dict | None = None, **properties) -> bpy.types.Node:
        """A shader node, linked to the output."""
        node = self.node(kind, inputs, **properties)
        self.set(self.output, "Surface", node)
        return node

    def math(self, operation: str, *values) -> bpy.types.NodeSocket:
        names = ("Value", "Value_001", "Value_002")
        return self.node("Math", dict(zip(names, values)), operation=operation).outputs[0]  # noqa: B905

    def vector_math(self, operation: str, *values) -> bpy.types.NodeSocket:
        names = ("Vector", "Vector_001", "Vector_002")
        node = self.node("VectorMath", dict(zip(names, values)), operation=operation)  # noqa: B905
        return next(socket for socket in node.outputs if socket.enabled)

    def scaled(self, vector, factor: float, offset: float) -> bpy.types.NodeSocket:
        """vector * factor + offset, as a colour of signed numbers needs it."""
        return self.vector_math("MULTIPLY_ADD", vector, (factor,) * 3, (offset,) * 3)


def out(node: bpy.types.Node, identifier: str) -> bpy.types.NodeSocket:
    return socket_of(node.outputs, identifier)


def socket_of(sockets, identifier: str) -> bpy.types.NodeSocket:
    for name in (identifier, FORMER_SOCKETS.get(identifier)):
        for socket in sockets:
            if socket.identifier == name:
                return socket
    known = ", ".join(socket.identifier for socket in sockets)
    raise KeyError(f"no socket {identifier!r}; there are {known}")


def set_property(node: bpy.types.Node, name: str, value) -> None:
    if isinstance(value, tuple) and isinstance(value[0], str):
        choices = node.bl_rna.properties[name].enum_items.keys()
        value = next(choice for choice in value if choice in choices)
    setattr(node, name, value)
