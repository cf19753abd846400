"""Shader trees of Blender to graphs of the core."""

from .build import BACKGROUND, DIFFUSE
from .derived import ATTRIBUTES as DERIVED_ATTRIBUTES
from .flat import constant
from .flatten import TreeReader
from .tree import export_sockets, linked_label

__all__ = [
    "BACKGROUND",
    "DERIVED_ATTRIBUTES",
    "DIFFUSE",
    "TreeReader",
    "constant",
    "export_sockets",
    "linked_label",
]
