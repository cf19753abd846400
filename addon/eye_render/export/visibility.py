"""Which rays see an object, and whether it is cut out of the picture but for its shadows."""

from typing import NamedTuple

import bpy

_PROPERTIES = {
    "CAMERA": "visible_camera",
    "DIFFUSE": "visible_diffuse",
    "GLOSSY": "visible_glossy",
    "TRANSMISSION": "visible_transmission",
    "VOLUME_SCATTER": "visible_volume_scatter",
    "SHADOW": "visible_shadow",
}


class Visibility(NamedTuple):
    hidden_from: tuple[str, ...] = ()
    is_holdout: bool = False
    is_shadow_catcher: bool = False


def visibility_of(
    shown: bpy.types.Object, placer: bpy.types.Object, view_layer: bpy.types.ViewLayer
) -> Visibility:
    """What the object says, and the one that instances it (else itself) with its collections."""
    hidden = {
        ray
        for ray, name in _PROPERTIES.items()
        if not (getattr(shown, name) and getattr(placer, name))
    }
    is_holdout = shown.is_holdout or placer.holdout_get(view_layer=view_layer)
    if not is_holdout and placer.indirect_only_get(view_layer=view_layer):
        hidden.add("CAMERA")
    is_catcher = shown.is_shadow_catcher or placer.is_shadow_catcher
    return Visibility(tuple(sorted(hidden)), is_holdout, is_catcher)


def light_group_of(
    shown: bpy.types.Object, placer: bpy.types.Object, view_layer: bpy.types.ViewLayer
) -> str:
    """The light group that the object is in, or else the one that instances it; empty for none of
    those that the view layer asks for."""
    name = shown.lightgroup or placer.lightgroup
    return name if name in view_layer.lightgroups else ""
