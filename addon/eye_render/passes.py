"""Render passes: one table, from the core, for registering, adding and writing."""

import bpy
import numpy as np

from . import batch, compat, core

_VALUE_KIND = {1: "VALUE", 3: "VECTOR", 4: "COLOR"}

# The property that switches each pass: Blender's, of the view layer, or that of
# `view_layer.eye_render` where Blender has none.
_SWITCHES = {
    "Depth": "use_pass_z",
    "Normal": "use_pass_normal",
    "Diffuse Direct": "use_pass_diffuse_direct",
    "Diffuse Indirect": "use_pass_diffuse_indirect",
    "Diffuse Color": "use_pass_diffuse_color",
    "Glossy Direct": "use_pass_glossy_direct",
    "Glossy Indirect": "use_pass_glossy_indirect",
    "Glossy Color": "use_pass_glossy_color",
    "Transmission Direct": "use_pass_transmission_direct",
    "Transmission Indirect": "use_pass_transmission_indirect",
    "Transmission Color": "use_pass_transmission_color",
    "Volume Direct": "use_pass_volume_direct",
    "Volume Indirect": "use_pass_volume_indirect",
    "Emission": "use_pass_emit",
    "Environment": "use_pass_environment",
    "Denoising Albedo": "denoising_store_passes",
    "Defocus": "use_pass_defocus",
    "Blur": "use_pass_blur",
}


def switches(view_layer: bpy.types.ViewLayer) -> dict[str, bpy.types.bpy_struct]:
    """The switches of passes, each with what holds it."""
    return {
        switch: view_layer if hasattr(view_layer, switch) else view_layer.eye_render
        for switch in _SWITCHES.values()
    }


def _is_enabled(view_layer: bpy.types.ViewLayer, name: str) -> bool:
    if name == "Combined":
        return True
    switch = _SWITCHES[name]
    # Files made for Cycles keep what they switched on there.
    holders = (view_layer, view_layer.eye_render, getattr(view_layer, "cycles", None))
    return any(getattr(holder, switch, False) for holder in holders)


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
        shown = compat.pass_name(name)
        engine.register_pass(scene, view_layer, shown, channels, channel_ids, kind)


def add(engine: bpy.types.RenderEngine, view_layer: bpy.types.ViewLayer) -> list[str]:
    """Add the enabled passes to the render result; gives their names in the core."""
    rows = enabled(view_layer)
    for name, channels, channel_ids in rows:
        if name != "Combined":  # Blender adds this one itself
            shown = compat.pass_name(name)
            engine.add_pass(shown, channels, channel_ids, layer=view_layer.name)
    return [name for name, _, _ in rows]


def write(layer: bpy.types.RenderLayer, pixels: dict[str, np.ndarray]) -> None:
    """Fill all passes of the layer in one call, by far the fastest way from Blender 3.4 to 5.2."""
    height, width, _ = pixels["Combined"].shape
    shown = {compat.pass_name(name): array for name, array in pixels.items()}
    flat = [
        shown[item.name].ravel()
        if item.name in shown
        else np.zeros(height * width * item.channels, np.float32)
        for item in layer.passes
    ]
    layer.passes.foreach_set("rect", np.concatenate(flat))
