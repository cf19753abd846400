"""The Focus panel: what the eye looks at, and how near it can see sharply."""

from bpy.types import Panel

from .. import core, summary
from .tabs import CameraTab, SceneCameraTab, draw_sentence, split_column


class _Focus:
    bl_label = "Focus"

    def draw(self, context):
        camera = self.camera(context)
        observer = camera.eye_render

        column = split_column(self.layout)
        column.prop(observer, "focus_mode")
        if observer.focus_mode == "DISTANCE":
            target = camera.dof.focus_object
            column.prop(camera.dof, "focus_object")
            if target is not None and target.type == "ARMATURE":
                column.prop_search(camera.dof, "focus_subtarget", target.data, "bones")
            row = column.row()
            row.active = target is None
            row.prop(camera.dof, "focus_distance")
        column.prop(observer, "amplitude_formula")
        shown = self.camera_object(context)
        if core.module is not None and shown is not None:
            for each in summary.summaries(context, shown):
                if each.accommodation:
                    draw_sentence(self.layout, context, each.accommodation, "BLANK1")
                draw_sentence(self.layout, context, each.line, "INFO")


class EYE_RENDER_PT_camera_focus(_Focus, CameraTab, Panel):
    pass


class EYE_RENDER_PT_focus(_Focus, SceneCameraTab, Panel):
    pass


classes = (EYE_RENDER_PT_camera_focus, EYE_RENDER_PT_focus)
