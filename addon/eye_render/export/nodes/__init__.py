"""Shader trees of Blender to graphs of the core."""

from .build import BACKGROUND, DIFFUSE, EMISSION
from .derived import ATTRIBUTES as DERIVED_ATTRIBUTES
from .named import OWNER_PREFIXES, PARTICLE_PREFIX, PLACE_PREFIX
from .tree import aov_sockets, export_sockets

__all__ = [
    "BACKGROUND",
    "DERIVED_ATTRIBUTES",
    "DIFFUSE",
    "EMISSION",
    "OWNER_PREFIXES",
    "PARTICLE_PREFIX",
    "PLACE_PREFIX",
    "aov_sockets",
    "export_sockets",
]
