"""The Eye Model panel: how the eye forms its rays, and what it is told of its own."""

import bpy
from bpy.types import Panel

from .. import batch, choices
from ..observer import seen_eyes
from ..operators import EYE_RENDER_OT_import_wavefront
from .tabs import CameraTab, SceneCameraTab, draw_sentence, split_column


def _draw_wavefront(
    layout: bpy.types.UILayout, context: bpy.types.Context, camera: bpy.types.Camera
) -> None:
    observer = camera.eye_render
    column = split_column(layout)
    column.row().prop(observer, "wavefront_source", expand=True)
    if observer.wavefront_source == "MEASURED":
        for eye in seen_eyes(context.scene, observer, batch.overrides):
            measured = observer.left_wavefront if eye == "LEFT" else observer.right_wavefront
            text = f"{eye.title()}: nothing imported yet"
            if measured.is_there:
                text = f"{eye.title()}: {measured.source}, over {measured.pupil_mm:.2f} mm"
            draw_sentence(layout, context, text, "INFO" if measured.is_there else "ERROR")
            operator = layout.operator(
                EYE_RENDER_OT_import_wavefront.bl_idname, text=f"Import {eye.title()} Eye"
            )
            operator.eye = eye
            operator.camera = camera.name
    draw_sentence(
        layout, context, "Its tilt and second order do not count: the prescription rules", "INFO"
    )


class _Model:
    bl_label = "Eye Model"

    def draw(self, context):
        camera = self.camera(context)
        observer = camera.eye_render
        scene = context.scene.eye_render
        column = split_column(self.layout)
        column.prop(observer, "model", text="Model")
        if observer.model == "WAVEFRONT":
            _draw_wavefront(self.layout, context, camera)
        elif observer.model in choices.SCHEMATIC_MODELS:
            column.row().prop(observer, "refraction_zero", expand=True)
            column.prop(observer, "exact_trace")
        column = split_column(self.layout)
        column.active = observer.model != "PINHOLE"
        column.prop(scene, "chromatic")
        column.prop(scene, "stiles_crawford")


class EYE_RENDER_PT_camera_model(_Model, CameraTab, Panel):
    pass


class EYE_RENDER_PT_model(_Model, SceneCameraTab, Panel):
    pass


classes = (EYE_RENDER_PT_camera_model, EYE_RENDER_PT_model)
