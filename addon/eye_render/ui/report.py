"""The Report panel: what the observer's eye makes of points, as numbers and as a picture."""

from pathlib import Path

import bpy
from bpy.props import StringProperty
from bpy.types import Operator, Panel
from bpy_extras.io_utils import ExportHelper

from .. import core, reporting
from .tabs import SceneCameraTab, split_column


class EYE_RENDER_OT_report(Operator, ExportHelper):
    """Write blur, contrast and focus of the observer's eye to a JSON file, and a picture of them
    beside it"""

    bl_idname = "eye_render.report"
    bl_label = "Write Report"
    filename_ext = ".json"
    filter_glob: StringProperty(default="*.json", options={"HIDDEN"})

    @classmethod
    def poll(cls, context):
        return core.module is not None and context.scene.camera is not None

    def execute(self, context):
        try:
            subject = reporting.subject_in(context)
            written = reporting.write(subject, Path(bpy.path.abspath(self.filepath)))
        except core.EyeRenderError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if written.note:
            self.report({"WARNING"}, written.note[:1].upper() + written.note[1:])
        else:
            self.report({"INFO"}, f"Wrote {written.numbers.name} and {written.picture.name}")
        return {"FINISHED"}


class EYE_RENDER_PT_report(SceneCameraTab, Panel):
    bl_label = "Report"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        split_column(self.layout).operator(EYE_RENDER_OT_report.bl_idname, icon="FILE_TEXT")


classes = (EYE_RENDER_OT_report, EYE_RENDER_PT_report)
