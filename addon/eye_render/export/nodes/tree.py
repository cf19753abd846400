"""Sockets of a Blender tree to sockets of the core: flattened, then made modern, then built."""

from collections.abc import Iterable
from typing import NamedTuple

import bpy

from ..image import ImageTable
from .build import GraphBuilder, PlainShader
from .flatten import TreeReader
from .versions import modernize


class ExportedTree(NamedTuple):
    graph: object  # of the core
    sockets: list[object | None]  # of the graph, what feeds each socket asked for
    kinds: frozenset[str]  # of the nodes that the core was given
    left_out: list[str]  # what could not be shown, for a warning


def export_sockets(
    sockets: Iterable[bpy.types.NodeSocket], images: ImageTable, plain_shader: PlainShader
) -> ExportedTree:
    """One graph with all that these inputs of the tree's output node depend on."""
    reader = TreeReader()
    sources = [reader.read(socket).source for socket in sockets]
    for node in reader.nodes:
        modernize(node)
    builder = GraphBuilder(images, plain_shader)
    built = [builder.add(source) if source else None for source in sources]
    left_out = list(dict.fromkeys(builder.left_out))
    return ExportedTree(builder.graph, built, frozenset(builder.kinds), left_out)


def linked_label(socket: bpy.types.NodeSocket) -> str | None:
    """The name, for a warning, of the node that feeds the socket; None if nothing does."""
    source = TreeReader().read(socket).source
    return source.node.label if source else None
