"""The Pupil panel: a diameter, or the luminance that decides it."""

import bpy
from bpy.types import Panel

from .. import choices, found
from ..observer import is_stereo
from .tabs import CameraTab, SceneCameraTab, draw_sentence, split_column


def _draw_field(column: bpy.types.UILayout, observer: bpy.types.PropertyGroup) -> None:
    """The adapting field, as far as the formula asks for it."""
    field = column.column()
    field.active = observer.pupil_formula in choices.FORMULAS_OF_FIELD
    field.row().prop(observer, "pupil_field", expand=True)
    if observer.pupil_field == "FIXED":
        field.prop(observer, "pupil_field_deg", text="Field Diameter (°)")
    eyes = column.row()
    eyes.active = observer.pupil_formula in choices.FORMULAS_OF_EYES
    eyes.prop(observer, "pupil_eyes", text="Eyes in the Light")


class _Pupil:
    bl_label = "Pupil"

    def draw(self, context):
        observer = self.camera(context).eye_render
        scene = context.scene.eye_render

        column = split_column(self.layout)
        column.row().prop(observer, "pupil_mode", expand=True)
        if observer.pupil_mode == "MANUAL":
            column.prop(observer, "pupil_mm", text="Diameter (mm)")
        else:
            column.prop(observer, "pupil_formula")
            column.prop(scene, "cd_m2_per_unit", text="Luminance of 1.0 (cd/m²)")
            column.prop(scene, "luminance_sigma")
            _draw_field(column, observer)
            column.prop(observer, "pupil_hold")
            if is_stereo(context.scene.render):
                column.label(text="The first stereo view decides for all", icon="INFO")
        column.prop(scene, "pupil_pattern", text="Pattern")
        pupil = found.last_pupil(self.camera(context))
        if pupil is not None:
            text = f"Last render, {pupil.where}: {pupil.report}"
            draw_sentence(self.layout, context, text, "INFO")
            if pupil.clamps:
                draw_sentence(self.layout, context, pupil.clamps)


class EYE_RENDER_PT_camera_pupil(_Pupil, CameraTab, Panel):
    pass


class EYE_RENDER_PT_pupil(_Pupil, SceneCameraTab, Panel):
    pass


classes = (EYE_RENDER_PT_camera_pupil, EYE_RENDER_PT_pupil)
