"""The panel of a lamp, with the settings that the core reads."""

from bpy.types import Panel

from .. import compat
from .tabs import Tab, split_column


class EYE_RENDER_PT_light(Tab, Panel):
    bl_label = "Light"
    bl_context = "data"

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.light is not None

    def draw(self, context):
        light = context.light
        self.layout.row().prop(light, "type", expand=True)
        column = split_column(self.layout)
        column.prop(light, "color")
        column.prop(light, "energy")
        compat.draw_light_extras(column, light)
        if light.type in {"POINT", "SPOT"}:
            column.prop(light, "shadow_soft_size", text="Radius")
        if light.type == "SPOT":
            column.prop(light, "spot_size")
            column.prop(light, "spot_blend", slider=True)
        if light.type == "SUN":
            column.prop(light, "angle")
        if light.type == "AREA":
            column.prop(light, "shape")
            column.prop(light, "size")
            if light.shape in {"RECTANGLE", "ELLIPSE"}:
                column.prop(light, "size_y")
            column.prop(light, "spread")
        column.prop(*compat.shadow_switch(light), text="Cast Shadow")


classes = (EYE_RENDER_PT_light,)
