"""A shader tree as plain data: no groups, reroutes or muted nodes, only nodes and their links.

Kinds are Blender's `node.type`, sockets go by their identifiers. Pointers to Blender's data may
stand in options until the graph of the core is built.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from ...working_space import luminance

Value = float | tuple[float, float, float]
NUMBER_TYPES = {"VALUE", "INT", "BOOLEAN"}


class Output(NamedTuple):
    node: Node
    identifier: str
    type: str  # of the socket, as Blender says: VALUE, RGBA, VECTOR, SHADER


@dataclass
class Input:
    """A socket's own value, and what is linked to it.

    The value is None where Blender shows none: such a socket reads the normal, the texture's
    usual coordinate or the like.
    """

    type: str
    value: Value | None = None
    source: Output | None = None


@dataclass(eq=False)
class Node:
    kind: str
    label: str  # how a warning names it
    options: dict[str, object] = field(default_factory=dict)
    inputs: dict[str, Input] = field(default_factory=dict)
    changed: set[str] = field(default_factory=set)  # options that differ from Blender's default
    renamed_outputs: dict[str, str] = field(default_factory=dict)
    redirected_outputs: dict[str, Output] = field(default_factory=dict)  # other nodes have them
    constant_outputs: dict[str, Value] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)  # what of it cannot be shown

    def output(self, identifier: str, socket_type: str) -> Output:
        return Output(self, identifier, socket_type)


def converted(value: Value | None, socket_type: str) -> Value | None:
    """The value as a socket of that type reads it, by Blender's implicit conversions.

    Numbers into vectors fill all three; of colours the luminance is the number, of vectors the
    mean, but what is a colour and what a vector cannot be told from the value: it is a colour.
    """
    if value is None:
        return None
    if socket_type in NUMBER_TYPES:
        return luminance(value) if isinstance(value, tuple) else value
    return value if isinstance(value, tuple) else (value, value, value)


def math_node(
    operation: str, first: Input | float, second: Input | float, *, use_clamp: bool = False
) -> Node:
    node = Node("MATH", "Math", {"operation": operation, "use_clamp": use_clamp})
    node.inputs["Value"] = _number_input(first)
    node.inputs["Value_001"] = _number_input(second)
    return node


def math_result(node: Node) -> Input:
    """An input that a Math node feeds."""
    return Input("VALUE", source=node.output("Value", "VALUE"))


def _number_input(given: Input | float) -> Input:
    return given if isinstance(given, Input) else Input("VALUE", given)
