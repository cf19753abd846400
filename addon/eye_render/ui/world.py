"""Panels of the world, for what Blender shows by each engine's own."""

from bpy.types import Panel

from .. import cycles_settings
from .tabs import Tab, split_column


class _WorldTab(Tab):
    bl_context = "world"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.world is not None


class EYE_RENDER_PT_world_ray_visibility(_WorldTab, Panel):
    bl_label = "Ray Visibility"

    @classmethod
    def poll(cls, context):
        return super().poll(context) and cycles_settings.visibility(context.world) is not None

    def draw(self, context):
        visible = cycles_settings.visibility(context.world)
        column = split_column(self.layout)
        for rays in cycles_settings.RAYS_OF_WORLD:
            column.prop(visible, rays)


class EYE_RENDER_PT_occlusion(_WorldTab, Panel):
    bl_label = "Ambient Occlusion Pass"

    def draw(self, context):
        split_column(self.layout).prop(context.world.light_settings, "distance")


classes = (EYE_RENDER_PT_world_ray_visibility, EYE_RENDER_PT_occlusion)
