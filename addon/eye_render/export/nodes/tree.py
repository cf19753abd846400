"""Sockets of a Blender tree to sockets of the core: flattened, then made modern, then built."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

import bpy

from ... import compat
from ..image import ImageTable
from .build import GraphBuilder, PlainShader
from .flat import Node, Output
from .flatten import Path, TreeReader
from .occlusion import look_as_far_as_the_world
from .versions import modernize


class PlacedSocket(NamedTuple):
    """An input of a node, and the group nodes around it, outermost first."""

    socket: bpy.types.NodeSocket
    path: Path


class ExportedTree(NamedTuple):
    graph: object  # of the core
    sockets: list[object | None]  # of the graph, what feeds each socket asked for
    kinds: frozenset[str]  # of the nodes that the core was given
    left_out: list[str]  # what could not be shown, for a warning
    values: dict[str, object]  # sockets of the graph that feed what is written out, by name


def export_sockets(
    sockets: Iterable[bpy.types.NodeSocket],
    images: ImageTable,
    plain_shader: PlainShader,
    values: Mapping[str, PlacedSocket] | None = None,
    occlusion_distance: float = 0.0,
) -> ExportedTree:
    """One graph with all that these inputs of the tree's output node depend on, and the values,
    linked or set on the socket itself. `occlusion_distance` is the world's."""
    reader = TreeReader()
    written = {name: _value_of(reader, placed) for name, placed in (values or {}).items()}
    sources = [reader.read(socket).source for socket in sockets]
    for node in reader.nodes:
        modernize(node)
        look_as_far_as_the_world(node, occlusion_distance)
    builder = GraphBuilder(images, plain_shader)
    built = [builder.add(source) if source else None for source in sources]
    found = {name: builder.add(source) for name, source in written.items()}
    left_out = list(dict.fromkeys(builder.left_out))
    kinds = frozenset(builder.kinds)
    return ExportedTree(
        builder.graph, built, kinds, left_out, {name: out for name, out in found.items() if out}
    )


def aov_sockets(tree: bpy.types.NodeTree, aovs: Mapping[str, str]) -> dict[str, PlacedSocket]:
    """The inputs of the AOV Output nodes, in groups, too, that a view layer asks for, by name.
    `aovs` is VALUE or COLOR by name."""
    return {
        name: PlacedSocket(node.inputs[aovs[name].capitalize()], path)
        for node, path in _aov_outputs(tree, ())
        if (name := compat.aov_name(node)) in aovs
    }


def _aov_outputs(tree: bpy.types.NodeTree, path: Path) -> Iterator[tuple[bpy.types.Node, Path]]:
    for node in tree.nodes:
        if node.mute:
            continue
        if node.type == "OUTPUT_AOV":
            yield node, path
        elif node.type == "GROUP" and node.node_tree:
            yield from _aov_outputs(node.node_tree, (*path, node))


def _value_of(reader: TreeReader, placed: PlacedSocket) -> Output:
    item = reader.read(*placed)
    if item.source is not None:
        return item.source
    if isinstance(item.value, tuple):
        return Node("RGB", "RGB", {"value": list(item.value)}).output("Color", "RGBA")
    return Node("VALUE", "Value", {"value": item.value}).output("Value", "VALUE")
