"""Panels of the rendering itself: Sampling and Film, and the Passes of a view layer."""

from bpy.types import Panel

from .. import batch, passes
from .tabs import RenderTab, Tab, split_column


class EYE_RENDER_PT_sampling(RenderTab, Panel):
    bl_label = "Sampling"

    def draw(self, context):
        settings = context.scene.eye_render
        column = split_column(self.layout)
        column.prop(settings, "quality")
        if settings.quality == "CUSTOM":
            column.prop(settings, "samples")
        column.prop(settings, "max_bounces")
        column.prop(settings, "seed")
        if batch.overrides != batch.Overrides():
            column.label(text="The command line overrides some of this", icon="INFO")


class EYE_RENDER_PT_film(RenderTab, Panel):
    bl_label = "Film"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        render = context.scene.render
        column = split_column(self.layout)
        column.prop(render, "filter_size")
        column.prop(render, "film_transparent", text="Transparent")


class EYE_RENDER_PT_passes(Tab, Panel):
    bl_label = "Passes"
    bl_context = "view_layer"

    def draw(self, context):
        view_layer = context.view_layer
        column = split_column(self.layout)
        for switch, holder in passes.switches(view_layer).items():
            column.prop(holder, switch)


classes = (EYE_RENDER_PT_sampling, EYE_RENDER_PT_film, EYE_RENDER_PT_passes)
