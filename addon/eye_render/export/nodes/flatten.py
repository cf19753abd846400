"""A tree of Blender to plain data: groups opened, reroutes and muted nodes passed through.

Only what the asked-for sockets depend on is read, and each node once for each place its group
stands at.
"""

from collections.abc import Iterable

import bpy

from ... import compat
from .. import image_file
from .flat import NUMBER_TYPES, Input, Node, Output, Value, converted

# What all nodes have; the other properties are the options of a kind.
_COMMON_PROPERTIES = {prop.identifier for prop in bpy.types.ShaderNode.bl_rna.properties}
# These nodes keep their value in an output socket.
_KINDS_WITH_OUTPUT_VALUE = {"VALUE", "RGB", "NORMAL"}

# Where a node stands: the group nodes around it, outermost first.
Path = tuple[bpy.types.Node, ...]


class TreeReader:
    """Reads sockets of one tree; `nodes` are all that they depend on."""

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self._known: dict[tuple, Node] = {}
        self._unread: list[tuple[Node, bpy.types.Node, Path]] = []
        self._links_into: dict[int, dict[int, bpy.types.NodeLink]] = {}

    def read(self, socket: bpy.types.NodeSocket, path: Path = ()) -> Input:
        """The input of a node that stands there, with everything that it depends on."""
        result = self._input(socket, path)
        while self._unread:  # not by recursion: chains of nodes may be long
            node, original, path = self._unread.pop()
            for inner in original.inputs:
                if inner.enabled and inner.type != "CUSTOM":
                    node.inputs[inner.identifier] = self._input(inner, path)
        return result

    def _input(self, socket: bpy.types.NodeSocket, path: Path) -> Input:
        end, inner_path, through_number = self._follow(socket, path)
        if end is None:  # a reroute or muted node that nothing is linked to
            zero = None if socket.hide_value else converted(0.0, socket.type)
            return Input(socket.type, zero)
        if not end.is_output:
            value = None if socket.hide_value else own_value(end)
            if through_number:
                value = converted(value, "VALUE")
            return Input(socket.type, converted(value, socket.type))
        source = self._node(end.node, inner_path).output(end.identifier, end.type)
        own = None if socket.hide_value else own_value(socket)
        if socket.type == "SHADER" and source.type != "SHADER":
            source = self._emission(source)
        elif socket.type != "SHADER" and source.type == "SHADER":
            return Input(socket.type, own)
        elif through_number and source.type in {"RGBA", "VECTOR"}:
            source = self._number(source)
        return Input(socket.type, own, source)

    def _follow(
        self, socket: bpy.types.NodeSocket, path: Path
    ) -> tuple[bpy.types.NodeSocket | None, Path, bool]:
        """Where an input's value comes from, that node's path, and if it was a number on its way.

        The output of a node that computes, or the input whose own value counts; None where the way
        ends at a reroute or in a muted node.
        """
        first = socket
        passes_through = through_number = False
        while True:
            link = self._link_into(socket)
            if link is None:
                return (None if passes_through else socket), path, through_number
            output, node = link.from_socket, link.from_node
            passes_through = node.type == "REROUTE" or node.mute
            if node.type == "REROUTE":
                socket = node.inputs[0]
            elif node.mute:
                through = [inner for inner in node.internal_links if inner.to_socket == output]
                if not through:
                    return first, path, False
                socket = through[0].from_socket
            elif node.type == "GROUP":
                inside = _named(_group_output_sockets(node), output.identifier)
                if inside is None:
                    return first, path, False
                socket, path = inside, (*path, node)
            elif node.type == "GROUP_INPUT":
                outside = _named(path[-1].inputs, output.identifier) if path else None
                if outside is None:
                    return first, path, False
                socket, path = outside, path[:-1]
            else:
                return output, path, through_number
            narrows = socket.type in NUMBER_TYPES and first.type not in NUMBER_TYPES
            through_number = through_number or narrows

    def _link_into(self, socket: bpy.types.NodeSocket) -> bpy.types.NodeLink | None:
        """As `socket.links` of an input, which would go through all links of the tree."""
        tree = socket.id_data
        links = self._links_into.get(tree.as_pointer())
        if links is None:
            links = self._links_into[tree.as_pointer()] = {
                link.to_socket.as_pointer(): link
                for link in tree.links
                if link.is_valid and not link.is_muted
            }
        return links.get(socket.as_pointer())

    def _node(self, original: bpy.types.Node, path: Path) -> Node:
        key = (*(group.as_pointer() for group in path), original.as_pointer())
        if key not in self._known:
            node = self._known[key] = Node(original.type, node_label(original))
            node.options, node.changed = _options(original)
            self.nodes.append(node)
            self._unread.append((node, original, path))
        return self._known[key]

    def _emission(self, source: Output) -> Output:
        """What Blender makes of a colour or a number where it wants a shader."""
        node = Node("EMISSION", "Emission")
        node.inputs["Color"] = Input("RGBA", (1.0, 1.0, 1.0), source)
        node.inputs["Strength"] = Input("VALUE", 1.0)
        self.nodes.append(node)
        return node.output("Emission", "SHADER")

    def _number(self, source: Output) -> Output:
        """The number that a colour or vector becomes between two sockets that want more."""
        if source.type == "RGBA":
            node = Node("RGBTOBW", "RGB to BW")
            node.inputs["Color"] = Input("RGBA", None, source)
            output = node.output("Val", "VALUE")
        else:
            node = Node("VECT_MATH", "Vector Math", {"operation": "DOT_PRODUCT"})
            node.inputs["Vector"] = Input("VECTOR", None, source)
            node.inputs["Vector_001"] = Input("VECTOR", (1 / 3, 1 / 3, 1 / 3))
            output = node.output("Value", "VALUE")
        self.nodes.append(node)
        return output


def node_label(node: bpy.types.Node) -> str:
    """How a warning names a node: its kind and its own name."""
    return f"{node.bl_label} '{compat.node_name(node)}'"


def own_value(socket: bpy.types.NodeSocket) -> Value | None:
    """The value set on the socket itself: a number, three numbers, or None for a shader."""
    value = getattr(socket, "default_value", None)
    if isinstance(value, bool | int | float):
        return float(value)
    if value is None or isinstance(value, str):
        return None
    return (*value, 0.0)[:3]


def _group_output_sockets(group: bpy.types.Node) -> Iterable[bpy.types.NodeSocket]:
    """The sockets inside that give the outputs of the group node."""
    nodes = group.node_tree.nodes if group.node_tree else ()
    output = next((n for n in nodes if n.type == "GROUP_OUTPUT" and n.is_active_output), None)
    return output.inputs if output else ()


def _named(
    sockets: Iterable[bpy.types.NodeSocket], identifier: str
) -> bpy.types.NodeSocket | None:
    return next((item for item in sockets if item.identifier == identifier), None)


def _options(node: bpy.types.Node) -> tuple[dict[str, object], set[str]]:
    """The properties that only this kind of node has, and the names of those that are changed."""
    options: dict[str, object] = {}
    changed = set()
    for prop in node.bl_rna.properties:
        name = prop.identifier
        if name in _COMMON_PROPERTIES or prop.type == "COLLECTION":
            continue
        value = getattr(node, name)
        if getattr(prop, "is_array", False):
            value = [float(number) for number in value]
        elif prop.type != "POINTER" and value != prop.default:
            changed.add(name)
        options[name] = image_file.absolute(value, node.id_data) if name == "filepath" else value
    if node.type in _KINDS_WITH_OUTPUT_VALUE:
        value = own_value(node.outputs[0])
        options["value"] = list(value) if isinstance(value, tuple) else value
    return options, changed
