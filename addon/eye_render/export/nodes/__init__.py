"""Reading shader node trees: where a socket's value comes from, and constants."""

import bpy


def source(socket: bpy.types.NodeSocket) -> bpy.types.NodeSocket | None:
    """The output that feeds the socket, past reroutes and muted nodes; None if nothing does."""
    while socket.is_linked:
        link = socket.links[0]
        if link.is_muted or not link.is_valid:
            return None
        output, node = link.from_socket, link.from_node
        if node.bl_idname == "NodeReroute":
            socket = node.inputs[0]
        elif node.mute:
            through = [inner for inner in node.internal_links if inner.to_socket == output]
            if not through:
                return None
            socket = through[0].from_socket
        else:
            return output
    return None


def source_node(socket: bpy.types.NodeSocket) -> bpy.types.Node | None:
    output = source(socket)
    return output.node if output else None


def find_input(node: bpy.types.Node, identifiers: tuple[str, ...]) -> bpy.types.NodeSocket | None:
    """The input with one of the identifiers: display names change with version and language."""
    return next((item for item in node.inputs if item.identifier in identifiers), None)


def own_value(socket: bpy.types.NodeSocket) -> float | tuple[float, float, float]:
    """The value set on the socket itself: a number, or linear RGB."""
    value = socket.default_value
    return value if isinstance(value, int | float) else tuple(value)[:3]


def constant(socket: bpy.types.NodeSocket) -> float | tuple[float, float, float] | None:
    """The socket's value where it is one everywhere; None if a texture or the like decides it."""
    output = source(socket)
    if output is None:
        return own_value(socket)
    if output.node.bl_idname in {"ShaderNodeValue", "ShaderNodeRGB"}:
        return own_value(output)
    return None


def node_label(node: bpy.types.Node) -> str:
    """How a warning names a node: its kind and its own name."""
    return f"{node.bl_label} '{node.name}'"
