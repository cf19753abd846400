"""Render passes: one table, from the core, for registering, adding and writing."""

import bpy
import numpy as np

from . import batch, core

_VALUE_KIND = {1: "VALUE", 3: "VECTOR", 4: "COLOR"}

# Passes that Blender itself has a switch for; the others are switched in `view_layer.eye_render`.
_BLENDER_SWITCH = {"Depth": "use_pass_z", "Normal": "use_pass_normal"}


def _is_enabled(view_layer: bpy.types.ViewLayer, name: str) -> bool:
    if name == "Combined":
        return True
    if name in _BLENDER_SWITCH:
        return getattr(view_layer, _BLENDER_SWITCH[name])
    return getattr(view_layer.eye_render, f"use_pass_{name.lower()}")


def enabled(view_layer: bpy.types.ViewLayer) -> list[tuple[str, int, str]]:
    """(name, channels, channel ids) of the passes that the view layer asks for; and, of a part of
    the samples, the pass that merges it with the others."""
    rows = [row for row in core.require().PASSES if _is_enabled(view_layer, row[0])]
    is_part = batch.overrides.sample_range is not None
    return [*rows, core.require().SAMPLE_WEIGHT] if is_part else rows


def register(
    engine: bpy.types.RenderEngine, scene: bpy.types.Scene, view_layer: bpy.types.ViewLayer
) -> None:
    """Tell the compositor which sockets the render layer has."""
    for name, channels, channel_ids in enabled(view_layer):
        kind = "COLOR" if channel_ids == "RGB" else _VALUE_KIND[channels]
        engine.register_pass(scene, view_layer, name, channels, channel_ids, kind)


def add(engine: bpy.types.RenderEngine, view_layer: bpy.types.ViewLayer) -> list[str]:
    """Add the enabled passes to the render result; gives their names."""
    rows = enabled(view_layer)
    for name, channels, channel_ids in rows:
        if name != "Combined":  # Blender adds this one itself
            engine.add_pass(name, channels, channel_ids, layer=view_layer.name)
    return [name for name, _, _ in rows]


def write(layer: bpy.types.RenderLayer, pixels: dict[str, np.ndarray]) -> None:
    """Fill all passes of the layer in one call, by far the fastest way from Blender 3.4 to 5.2."""
    height, width, _ = pixels["Combined"].shape
    flat = [
        pixels[item.name].ravel()
        if item.name in pixels
        else np.zeros(height * width * item.channels, np.float32)
        for item in layer.passes
    ]
    layer.passes.foreach_set("rect", np.concatenate(flat))
