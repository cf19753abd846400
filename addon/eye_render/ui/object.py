"""Panels of an object, for what Blender shows by each engine's own: which rays see it, and how its
motion is looked at."""

from bpy.types import Panel

from .. import cycles_settings
from .tabs import Tab, split_column


class EYE_RENDER_PT_ray_visibility(Tab, Panel):
    bl_label = "Ray Visibility"
    bl_context = "object"
    bl_parent_id = "OBJECT_PT_visibility"

    def draw(self, context):
        shown = context.object
        column = split_column(self.layout)
        column.prop(shown, "visible_camera", text="Camera")
        column.prop(shown, "visible_diffuse", text="Diffuse")
        column.prop(shown, "visible_glossy", text="Glossy")
        column.prop(shown, "visible_transmission", text="Transmission")
        column.prop(shown, "visible_volume_scatter", text="Volume Scatter")
        if shown.type != "LIGHT":
            column.prop(shown, "visible_shadow", text="Shadow")
            column.prop(shown, "is_shadow_catcher")


class EYE_RENDER_PT_object_motion_blur(Tab, Panel):
    bl_label = "Motion Blur"
    bl_context = "object"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return super().poll(context) and cycles_settings.of(context.object) is not None

    def draw_header(self, context):
        self.layout.prop(cycles_settings.of(context.object), "use_motion_blur", text="")

    def draw(self, context):
        settings = cycles_settings.of(context.object)
        column = split_column(self.layout)
        column.active = context.scene.render.use_motion_blur and settings.use_motion_blur
        column.prop(settings, "motion_steps", text="Steps")
        if context.object.type != "CAMERA":
            column.prop(settings, "use_deform_motion", text="Deformation")


classes = (EYE_RENDER_PT_ray_visibility, EYE_RENDER_PT_object_motion_blur)
