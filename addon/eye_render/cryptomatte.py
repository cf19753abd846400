"""Cryptomatte's metadata: which name each number in the pictures stands for.

By the Cryptomatte specification, under the keys that Blender's Cryptomatte node and others read.
"""

import json
import struct
from typing import NamedTuple

import bpy

from . import core, passes


class MatteNames(NamedTuple):
    """The names of what a render shows."""

    objects: set[str]
    materials: set[str]
    assets: set[str]  # what objects are part of: the last of their parents


def asset_of(shown: bpy.types.Object) -> str:
    while shown.parent:
        shown = shown.parent
    return shown.name


def stamp(
    result: bpy.types.RenderResult, view_layer: bpy.types.ViewLayer, names: MatteNames
) -> None:
    """Write the manifests of the Cryptomattes that the view layer asks for."""
    of_kind = dict(zip(("CryptoObject", "CryptoMaterial", "CryptoAsset"), names, strict=True))
    for kind in passes.cryptomatte_kinds(view_layer):
        layer = f"{view_layer.name}.{kind}"
        key = f"cryptomatte/{core.require().murmur3_32(layer):08x}"[: len("cryptomatte/") + 7]
        manifest = {name: _hex(name) for name in sorted(of_kind[kind])}
        result.stamp_data_add_field(f"{key}/name", layer)
        result.stamp_data_add_field(f"{key}/hash", "MurmurHash3_32")
        result.stamp_data_add_field(f"{key}/conversion", "uint32_to_float32")
        result.stamp_data_add_field(f"{key}/manifest", json.dumps(manifest, ensure_ascii=False))


def _hex(name: str) -> str:
    """The bits of the number in the pictures."""
    return struct.pack(">f", core.require().matte_id(name)).hex()
