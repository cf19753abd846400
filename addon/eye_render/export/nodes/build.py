"""Plain nodes to a graph of the core, whose own table of node kinds tells what it can show.

What it cannot show is named and replaced: a value by the one set on the socket that wanted it, a
shader by a plain one of its own colour.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ... import core
from ..image import ImageTable
from .coordinates import map_texture, name_object
from .flat import Input, Node, Output, Value, converted
from .ies import read_profile
from .pictures import number_texture
from .tables import sample_curves, sample_ramp


class PlainShader(NamedTuple):
    """What stands in for a shader that the core does not have."""

    kind: str
    output: str


DIFFUSE = PlainShader("BSDF_DIFFUSE", "BSDF")
EMISSION = PlainShader("EMISSION", "Emission")
BACKGROUND = PlainShader("BACKGROUND", "Background")


class _Found(NamedTuple):
    """What feeds an input in the core: an output of a node, or a value; None: neither."""

    socket: object | None = None
    value: Value | None = None


# What turns an option that points into Blender's data into numbers.
_LOWER: dict[str, Callable[[Node], None]] = {
    "mapping": sample_curves,
    "color_ramp": sample_ramp,
    "object": name_object,
    "texture_mapping": map_texture,
    "ies": read_profile,
}
# Options that do not change what a node shows.
_WITHOUT_EFFECT = {"use_alpha"}
# Inputs that do nothing by themselves although they are not zero.
_SUBORDINATE_INPUTS = {"Filter Width", "Thin Film IOR"}


class GraphBuilder:
    """Builds one graph; `left_out` names what could not be taken over."""

    def __init__(self, images: ImageTable, plain_shader: PlainShader):
        module = core.require()
        self.graph = module.NodeGraph()
        self.left_out: list[str] = []
        self._types = module.NODE_TYPES
        self._images = images
        self._plain_shader = plain_shader
        self._placed: dict[Node, object | None] = {}
        self.kinds: set[str] = set()
        self._unlinked: list[Node] = []

    def add(self, source: Output) -> object | None:
        """The core's socket of a shader or a value, with all that it depends on; None, after its
        name went to `left_out`, if it cannot be had."""
        found = self._find(source)
        while self._unlinked:  # not by recursion: chains of nodes may be long
            node = self._unlinked.pop()
            for identifier, item in node.inputs.items():
                self._fill(node, identifier, item)
        return found.socket

    def _find(self, source: Output) -> _Found:
        node = source.node
        if source.identifier in node.redirected_outputs:
            return self._find(node.redirected_outputs[source.identifier])
        if node not in self._placed:
            self._placed[node] = self._place(node, source)
        identifier = node.renamed_outputs.get(source.identifier, source.identifier)
        if identifier in node.constant_outputs:
            return _Found(value=node.constant_outputs[identifier])
        placed = self._placed[node]
        if placed is None:
            return _Found()
        if identifier not in self._types[node.kind]["outputs"]:
            self.left_out.append(f"{identifier} of {node.label}")
            return _Found()
        return _Found(socket=placed[identifier])

    def _place(self, node: Node, source: Output) -> object | None:
        placed = self._add_node(node)
        if placed is None and source.type == "SHADER":
            self._make_plain(node, source)
            placed = self._add_node(node)
        if placed is not None:
            self._unlinked.append(node)
        return placed

    def _add_node(self, node: Node) -> object | None:
        """The core's node, without inputs; None, and named, if the core refuses it."""
        if node.kind not in self._types:
            self.left_out.append(node.label)
            return None
        self._lower(node)
        known = self._types[node.kind]["options"]
        ignored = node.changed & node.options.keys() - set(known) - _WITHOUT_EFFECT
        self.left_out += [f"{name} of {node.label}" for name in sorted(ignored)]
        self.left_out += [f"{note} {node.label}" for note in node.notes]
        options = {name: node.options[name] for name in known if name in node.options}
        try:
            added = self.graph.add(node.kind, **options)
        except ValueError as error:  # a value of an option that the core refuses
            self.left_out.append(f"{node.label} ({error})")
            return None
        self.kinds.add(node.kind)
        return added

    def _lower(self, node: Node) -> None:
        for name in _LOWER.keys() & node.options.keys():
            _LOWER[name](node)
        if "image" in node.options:
            number_texture(node, self._images)

    def _make_plain(self, node: Node, source: Output) -> None:
        color = node.inputs.get("Base Color") or node.inputs.get("Color")
        node.kind = self._plain_shader.kind
        node.options, node.changed, node.notes = {}, set(), []
        node.inputs = {"Color": color} if color else {}
        node.renamed_outputs = {source.identifier: self._plain_shader.output}

    def _fill(self, node: Node, identifier: str, item: Input) -> None:
        if identifier not in self._types[node.kind]["inputs"]:
            is_idle = item.source is None and not np.any(item.value)
            if not is_idle and identifier not in _SUBORDINATE_INPUTS:
                self.left_out.append(f"{identifier} of {node.label}")
            return
        value = item.value
        if item.source is not None:
            found = self._find(item.source)
            if found.socket is not None:
                self._placed[node].set(identifier, found.socket)
                return
            if found.value is not None:
                value = converted(found.value, item.type)
        if value is not None and np.isfinite(value).all():
            self._placed[node].set(identifier, value)
