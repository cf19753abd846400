"""The panel that says why nothing can be rendered."""

import textwrap

from bpy.types import Panel

from .. import core
from .tabs import CameraTab, RenderTab

_LINE_LENGTH = 48


class _Missing:
    bl_label = "Eye Render Cannot Run"
    bl_order = 0

    @classmethod
    def poll(cls, context):
        return super().poll(context) and core.module is None

    def draw(self, context):
        column = self.layout.column(align=True)
        column.alert = True
        for number, line in enumerate(textwrap.wrap(core.problem, _LINE_LENGTH)):
            column.label(text=line, icon="BLANK1" if number else "ERROR")


class EYE_RENDER_PT_missing(_Missing, RenderTab, Panel):
    pass


class EYE_RENDER_PT_camera_missing(_Missing, CameraTab, Panel):
    pass


classes = (EYE_RENDER_PT_missing, EYE_RENDER_PT_camera_missing)
