"""Panels of the engine, and Blender's own panels opened to it."""

import bpy

from . import (
    focus,
    light,
    missing,
    model,
    object,
    prescription,
    pupil,
    render,
    report,
    world,
    worn,
)

_ENGINE = "EYE_RENDER"

# Panels for every engine that would show settings without effect here, or that ours replace.
_REPLACED = {
    "DATA_PT_area",
    "DATA_PT_falloff_curve",
    "DATA_PT_light",
    "DATA_PT_preview",
    "DATA_PT_spot",
    "EEVEE_MATERIAL_PT_viewport_settings",
    "NODE_DATA_PT_light",
    "NODE_DATA_PT_spot",
    "RENDER_PT_freestyle",
    "RENDER_PT_simplify",  # which would stand above the engine's own
    "VIEWLAYER_PT_filter",
}
# Panels that Blender shows for its own engines alone, though they suit any engine.
_WELCOME = {
    "EEVEE_MATERIAL_PT_context_material",
    "EEVEE_MATERIAL_PT_surface",
    "EEVEE_MATERIAL_PT_volume",
    "EEVEE_WORLD_PT_mist",
    "EEVEE_WORLD_PT_surface",
    "EEVEE_WORLD_PT_volume",
    "VIEWLAYER_PT_layer_passes",
    "VIEWLAYER_PT_layer_passes_aov",
    "VIEWLAYER_PT_layer_passes_cryptomatte",
    "VIEWLAYER_PT_layer_passes_lightgroups",
}

_classes = (
    *missing.classes,
    *prescription.classes,
    *worn.classes,
    *pupil.classes,
    *focus.classes,
    *model.classes,
    *render.classes,
    *report.classes,
    *light.classes,
    *object.classes,
    *world.classes,
)


def _blender_panels() -> list[type]:
    shared = {
        panel
        for panel in bpy.types.Panel.__subclasses__()
        if "BLENDER_RENDER" in getattr(panel, "COMPAT_ENGINES", ())
        and panel.__name__ not in _REPLACED
    }
    welcome = {getattr(bpy.types, name) for name in _WELCOME if hasattr(bpy.types, name)}
    return sorted(shared | welcome, key=lambda panel: panel.__name__)


def register():
    for panel in _blender_panels():
        panel.COMPAT_ENGINES.add(_ENGINE)
    for cls in _classes:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_classes):
        bpy.utils.unregister_class(cls)
    for panel in _blender_panels():
        panel.COMPAT_ENGINES.discard(_ENGINE)
