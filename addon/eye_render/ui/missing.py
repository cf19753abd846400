"""The panel that says why nothing can be rendered."""

from bpy.types import Panel

from .. import core
from .tabs import CameraTab, RenderTab, draw_sentence


class _Missing:
    bl_label = "Eye Render Cannot Run"
    bl_order = 0

    @classmethod
    def poll(cls, context):
        return super().poll(context) and core.module is None

    def draw(self, context):
        draw_sentence(self.layout, context, core.problem)


class EYE_RENDER_PT_missing(_Missing, RenderTab, Panel):
    pass


class EYE_RENDER_PT_camera_missing(_Missing, CameraTab, Panel):
    pass


classes = (EYE_RENDER_PT_missing, EYE_RENDER_PT_camera_missing)
