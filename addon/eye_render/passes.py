"""Render passes: one table, from the core, for registering, adding and writing."""

from typing import NamedTuple

import bpy
import numpy as np

from . import batch, compat, core, cycles_settings

# The property that switches each pass: Blender's, of the view layer; or Cycles', of
# `view_layer.cycles`; or that of `view_layer.eye_render` where neither has one.
_DATA_SWITCHES = {
    "Depth": "use_pass_z",
    "Mist": "use_pass_mist",
    "Position": "use_pass_position",
    "Normal": "use_pass_normal",
    "Vector": "use_pass_vector",
    "UV": "use_pass_uv",
    "Object Index": "use_pass_object_index",
    "Material Index": "use_pass_material_index",
    "Denoising Normal": "denoising_store_passes",
    "Denoising Albedo": "denoising_store_passes",
    "Defocus": "use_pass_defocus",
    "Blur": "use_pass_blur",
}
_LIGHT_SWITCHES = {
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
    "Ambient Occlusion": "use_pass_ambient_occlusion",
    "Shadow": "use_pass_shadow",
    "Shadow Catcher": "use_pass_shadow_catcher",
}
SWITCHES = _DATA_SWITCHES | _LIGHT_SWITCHES
_CRYPTOMATTE_SWITCHES = {
    "CryptoObject": "use_pass_cryptomatte_object",
    "CryptoMaterial": "use_pass_cryptomatte_material",
    "CryptoAsset": "use_pass_cryptomatte_asset",
}
_THINGS_IN_A_PICTURE = 2  # of Cryptomatte


class Row(NamedTuple):
    """One picture that a render delivers."""

    name: str  # in the core
    channels: int
    channel_ids: str

    @property
    def shown(self) -> str:
        """Its name in this Blender."""
        return compat.pass_name(self.name)

    @property
    def kind(self) -> str:
        if self.channel_ids.upper() in {"RGB", "RGBA"}:
            return "COLOR"
        return "VALUE" if self.channels == 1 else "VECTOR"


def switches(
    view_layer: bpy.types.ViewLayer, light: bool
) -> list[tuple[str, bpy.types.bpy_struct]]:
    """The switches of passes, of light or of data, each with what holds it."""
    names = dict.fromkeys((_LIGHT_SWITCHES if light else _DATA_SWITCHES).values())
    held = ((name, _holder(view_layer, name)) for name in names)
    return [(name, holder) for name, holder in held if holder is not None]


def _holder(view_layer: bpy.types.ViewLayer, switch: str) -> bpy.types.bpy_struct | None:
    """None for a switch of Cycles where Cycles is not enabled, and for one that this Blender has
    for others alone."""
    if switch == SWITCHES["Shadow"] and not compat.HAS_SHADOW_PASS:
        return None
    holders = (view_layer, view_layer.eye_render, cycles_settings.of(view_layer))
    return next((holder for holder in holders if hasattr(holder, switch)), None)


def _is_on(view_layer: bpy.types.ViewLayer, switch: str) -> bool:
    return getattr(_holder(view_layer, switch), switch, False)


def cryptomatte_kinds(view_layer: bpy.types.ViewLayer) -> list[str]:
    """The names of Cryptomattes that the view layer asks for, without their numbers."""
    return [name for name, switch in _CRYPTOMATTE_SWITCHES.items() if _is_on(view_layer, switch)]


def blurs_motion(scene: bpy.types.Scene, view_layer: bpy.types.ViewLayer) -> bool:
    return scene.render.use_motion_blur and view_layer.use_motion_blur


def needs_motion(scene: bpy.types.Scene, view_layer: bpy.types.ViewLayer) -> bool:
    """Whether the Vector pass is to be filled; as in Cycles, not of a picture that is blurred."""
    return _is_on(view_layer, SWITCHES["Vector"]) and not blurs_motion(scene, view_layer)


def needs_uvs(view_layer: bpy.types.ViewLayer) -> bool:
    return _is_on(view_layer, SWITCHES["UV"])


def aovs(view_layer: bpy.types.ViewLayer) -> dict[str, str]:
    """The values that materials are asked to write out: VALUE or COLOR by name."""
    return {aov.name: aov.type for aov in view_layer.aovs if aov.is_valid}


def _named_rows(view_layer: bpy.types.ViewLayer) -> list[Row]:
    of_group, of_value, of_color = (Row(*row) for row in core.require().NAMED_PASSES)
    groups = [of_group._replace(name=of_group.name + g.name) for g in view_layer.lightgroups]
    of_kind = {"VALUE": of_value, "COLOR": of_color}
    return groups + [of_kind[kind]._replace(name=name) for name, kind in aovs(view_layer).items()]


def enabled(view_layer: bpy.types.ViewLayer) -> list[Row]:
    """What the view layer asks for; and, of a part of the samples, the pass that merges it with
    the others."""
    table = core.require()
    rows = [
        Row(*row)
        for row in table.PASSES
        if row[0] == "Combined" or _is_on(view_layer, SWITCHES[row[0]])
    ]
    things = view_layer.pass_cryptomatte_depth
    for name, channels, channel_ids in table.CRYPTOMATTE:
        if name in cryptomatte_kinds(view_layer):
            pictures = -(-things // _THINGS_IN_A_PICTURE)
            rows += [Row(f"{name}{i:02}", channels, channel_ids) for i in range(pictures)]
    rows += _named_rows(view_layer)
    is_part = batch.overrides.sample_range is not None
    return [*rows, Row(*table.SAMPLE_WEIGHT)] if is_part else rows


def settings(scene: bpy.types.Scene, view_layer: bpy.types.ViewLayer) -> dict[str, object]:
    """What the core's settings say about passes."""
    values = aovs(view_layer)
    left_out = {*values, *([] if needs_motion(scene, view_layer) else ["Vector"])}
    result = {
        "passes": [row.name for row in enabled(view_layer) if row.name not in left_out],
        "aovs": values,
        "pass_alpha_threshold": view_layer.pass_alpha_threshold,
    }
    world = compat.world_of(scene, view_layer)
    if world is not None:
        mist = world.mist_settings
        result |= {
            "mist_start": mist.start,
            "mist_depth": max(mist.depth, _LEAST_MIST_DEPTH),
            "mist_falloff": mist.falloff,
            "occlusion_distance": world.light_settings.distance,
        }
    return result


_LEAST_MIST_DEPTH = 1e-6  # Blender allows 0: a wall of mist


def register(
    engine: bpy.types.RenderEngine, scene: bpy.types.Scene, view_layer: bpy.types.ViewLayer
) -> None:
    """Tell the compositor which sockets the render layer has."""
    for row in enabled(view_layer):
        engine.register_pass(scene, view_layer, row.shown, row.channels, row.channel_ids, row.kind)


def add(engine: bpy.types.RenderEngine, view_layer: bpy.types.ViewLayer) -> None:
    """Add the enabled passes to the render result."""
    for row in enabled(view_layer):
        if row.name != "Combined":  # Blender adds this one itself
            engine.add_pass(row.shown, row.channels, row.channel_ids, layer=view_layer.name)


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
