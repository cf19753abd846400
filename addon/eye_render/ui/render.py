"""Panels of the rendering itself, and of a view layer: its filter, and in Blender's panel of its
passes those that are switched one by one.

What Cycles has a setting for is that setting here, too.
"""

from bpy.types import Panel

from .. import batch, compat, cycles_settings, passes
from .tabs import RenderTab, Tab, split_column


class EYE_RENDER_PT_sampling(RenderTab, Panel):
    bl_label = "Sampling"

    def draw(self, context):
        settings = context.scene.eye_render
        column = split_column(self.layout)
        column.prop(settings, "quality")
        if settings.quality == "CUSTOM":
            column.prop(settings, "samples")
        column.prop(settings, "seed")
        if batch.overrides != batch.Overrides():
            column.label(text="The command line overrides some of this", icon="INFO")


class EYE_RENDER_PT_light_paths(RenderTab, Panel):
    bl_label = "Light Paths"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        column = split_column(self.layout)
        column.prop(context.scene.eye_render, "max_bounces", text="Max Bounces")
        cycles = cycles_settings.of(context.scene)
        if cycles is None:
            return
        kinds = column.column(align=True)
        kinds.prop(cycles, "diffuse_bounces", text="Diffuse")
        kinds.prop(cycles, "glossy_bounces", text="Glossy")
        kinds.prop(cycles, "transmission_bounces", text="Transmission")
        kinds.prop(cycles, "volume_bounces", text="Volume")
        kinds.prop(cycles, "transparent_max_bounces", text="Transparent")
        clamping = self.layout.column(align=True)
        clamping.prop(cycles, "sample_clamp_direct", text="Clamp Direct Light")
        clamping.prop(cycles, "sample_clamp_indirect", text="Indirect Light")
        caustics = self.layout.column()
        caustics.prop(cycles, "blur_glossy", text="Filter Glossy")
        caustics = caustics.column(heading="Caustics", align=True)
        caustics.prop(cycles, "caustics_reflective", text="Reflective")
        caustics.prop(cycles, "caustics_refractive", text="Refractive")


class EYE_RENDER_PT_film(RenderTab, Panel):
    bl_label = "Film"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        render = context.scene.render
        column = split_column(self.layout)
        cycles = cycles_settings.of(context.scene)
        if cycles is None:
            column.prop(render, "film_transparent", text="Transparent")
            return
        column.prop(cycles, "film_exposure")
        column.prop(cycles, "pixel_filter_type", text="Pixel Filter")
        if cycles.pixel_filter_type != "BOX":
            column.prop(cycles, "filter_width", text="Width")
        column.prop(render, "film_transparent", text="Transparent")
        glass = column.column()
        glass.active = render.film_transparent
        glass.prop(cycles, "film_transparent_glass", text="Transparent Glass")
        roughness = glass.column()
        roughness.active = cycles.film_transparent_glass
        roughness.prop(cycles, "film_transparent_roughness", text="Roughness Threshold")


class EYE_RENDER_PT_motion_blur(RenderTab, Panel):
    bl_label = "Motion Blur"
    bl_options = {"DEFAULT_CLOSED"}

    def draw_header(self, context):
        self.layout.prop(context.scene.render, "use_motion_blur", text="")

    def draw(self, context):
        render = context.scene.render
        column = split_column(self.layout)
        column.active = render.use_motion_blur
        position = compat.shutter_position_switch(context.scene)
        if position is not None:
            column.prop(*position, text="Position")
        column.prop(render, "motion_blur_shutter", text="Shutter")


class EYE_RENDER_PT_curves(RenderTab, Panel):
    bl_label = "Curves"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return super().poll(context) and cycles_settings.curves(context.scene) is not None

    def draw(self, context):
        split_column(self.layout).prop(cycles_settings.curves(context.scene), "shape")


class EYE_RENDER_PT_performance(RenderTab, Panel):
    bl_label = "Performance"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        render = context.scene.render
        column = split_column(self.layout)
        column.prop(render, "threads_mode")
        threads = column.column()
        threads.enabled = render.threads_mode == "FIXED"
        threads.prop(render, "threads")


class EYE_RENDER_PT_simplify(RenderTab, Panel):
    bl_label = "Simplify"
    bl_options = {"DEFAULT_CLOSED"}

    def draw_header(self, context):
        self.layout.prop(context.scene.render, "use_simplify", text="")

    def draw(self, context):
        render = context.scene.render
        column = split_column(self.layout)
        column.active = render.use_simplify
        column.prop(render, "simplify_subdivision_render", text="Max Subdivision")
        column.prop(render, "simplify_child_particles_render", text="Child Particles")


class EYE_RENDER_PT_filter(Tab, Panel):
    bl_label = "Filter"
    bl_context = "view_layer"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layer = context.view_layer
        column = split_column(self.layout).column(heading="Include")
        column.prop(layer, "use_sky", text="Environment")
        column.prop(layer, "use_solid", text="Surfaces")
        column.prop(layer, "use_strand", text="Hair")
        blur = column.row()
        blur.active = context.scene.render.use_motion_blur
        blur.prop(layer, "use_motion_blur", text="Motion Blur")


class _PassesTab(Tab):
    bl_context = "view_layer"
    bl_parent_id = "VIEWLAYER_PT_layer_passes"

    def draw(self, context):
        column = split_column(self.layout)
        for switch, holder in passes.switches(context.view_layer, self.light):
            row = column.row()
            row.active = (
                switch != passes.SWITCHES["Vector"] or not context.scene.render.use_motion_blur
            )
            row.prop(holder, switch)


class EYE_RENDER_PT_passes_data(_PassesTab, Panel):
    bl_label = "Data"
    light = False


class EYE_RENDER_PT_passes_light(_PassesTab, Panel):
    bl_label = "Light"
    light = True


classes = (
    EYE_RENDER_PT_sampling,
    EYE_RENDER_PT_light_paths,
    EYE_RENDER_PT_film,
    EYE_RENDER_PT_motion_blur,
    EYE_RENDER_PT_curves,
    EYE_RENDER_PT_performance,
    EYE_RENDER_PT_simplify,
    EYE_RENDER_PT_filter,
    EYE_RENDER_PT_passes_data,
    EYE_RENDER_PT_passes_light,
)
