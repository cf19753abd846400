"""The Report panel: what the observer's eye makes of points, as numbers and as a picture."""

from pathlib import Path

import bpy
from bpy.props import StringProperty
from bpy.types import Operator, Panel
from bpy_extras.io_utils import ExportHelper

from .. import core, reporting
from ..options import read_distances
from .tabs import SceneCameraTab, split_column


class EYE_RENDER_OT_report(Operator, ExportHelper):
    """Write blur, contrast and focus of the observer's eye to a JSON file, and a picture of them
    beside it"""

    bl_idname = "eye_render.report"
    bl_label = "Write Report"
    filename_ext = ".json"
    filter_glob: StringProperty(default="*.json", options={"HIDDEN"})
    distances: StringProperty(
        name="Distances",
        description="Metres from the eye, such as 0.3, 0.6, 6, inf; empty for the usual ones",
    )

    @classmethod
    def poll(cls, context):
        return core.module is not None and context.scene.camera is not None

    def _distances_m(self) -> tuple[float, ...]:
        if not self.distances.strip():
            return ()
        try:
            return read_distances(self.distances)
        except ValueError as error:
            raise core.EyeRenderError(f"Distances are '{self.distances}'; {error}") from None

    def execute(self, context):
        path = Path(bpy.path.abspath(self.filepath))
        notes = {}  # in order, each once
        try:
            distances_m = self._distances_m()
            subjects = reporting.subjects_in(context, lambda note: notes.setdefault(note))
            files = []
            for eye, subject in subjects.items():
                stem = path.stem if len(subjects) == 1 else f"{path.stem}.{eye.lower()}"
                written = reporting.write(subject, distances_m, path.with_stem(stem))
                files += [file.name for file in (written.numbers, written.picture) if file]
                if written.note:
                    notes.setdefault(written.note)
        except (core.EyeRenderError, ValueError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for note in notes:
            self.report({"WARNING"}, note[:1].upper() + note[1:])
        self.report({"INFO"}, f"Wrote {' and '.join(files)}")
        return {"FINISHED"}


class EYE_RENDER_PT_report(SceneCameraTab, Panel):
    bl_label = "Report"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        split_column(self.layout).operator(EYE_RENDER_OT_report.bl_idname, icon="FILE_TEXT")


classes = (EYE_RENDER_OT_report, EYE_RENDER_PT_report)
