"""The Pupil panel: a diameter, or the luminance that decides it."""

from bpy.types import Panel

from .tabs import CameraTab, SceneCameraTab, split_column


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
        column.prop(scene, "pupil_pattern", text="Pattern")


class EYE_RENDER_PT_camera_pupil(_Pupil, CameraTab, Panel):
    pass


class EYE_RENDER_PT_pupil(_Pupil, SceneCameraTab, Panel):
    pass


classes = (EYE_RENDER_PT_camera_pupil, EYE_RENDER_PT_pupil)
