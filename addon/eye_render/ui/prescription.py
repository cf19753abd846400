"""The Prescription panel: which eye looks, and what an optician wrote for each."""

import bpy
from bpy.types import Panel

from .. import batch
from ..observer import seen_eyes
from .tabs import NAME_SHARE, CameraTab, SceneCameraTab, draw_sentence, split_column


def draw_prescription(
    layout: bpy.types.UILayout,
    context: bpy.types.Context,
    prescription: bpy.types.PropertyGroup,
    name: str,
    is_used: bool,
) -> None:
    """The text, what is wrong with it, and its numbers, if there is a text."""
    column = split_column(layout)
    column.active = is_used
    problem = prescription.problem()
    row = column.row()
    row.alert = bool(problem)
    row.prop(prescription, "text", text=name)
    if problem:
        draw_sentence(column, context, problem)
    disagreement = prescription.disagreement()
    if disagreement:
        draw_sentence(column, context, disagreement, "INFO")
    if not prescription.text.strip():
        below_the_text = column.split(factor=NAME_SHARE)
        below_the_text.label()
        below_the_text.label(text="What the eye needs")
        return
    powers = column.column(align=True)
    powers.prop(prescription, "sphere", text="Sphere (D)")
    powers.prop(prescription, "cylinder", text="Cylinder (D)")
    axis = powers.row()
    axis.active = prescription.cylinder != 0.0
    axis.prop(prescription, "axis", text="Axis (°)")
    powers.prop(prescription, "add", text="Add (D)")
    if prescription.base_in != 0.0 or prescription.base_up != 0.0:
        powers.prop(prescription, "base_in", text="Prism In (Δ)")
        powers.prop(prescription, "base_up", text="Up (Δ)")


class _Prescription:
    bl_label = "Prescription"

    def draw(self, context):
        layout = self.layout
        observer = self.camera(context).eye_render
        eyes = seen_eyes(context.scene, observer, batch.overrides)

        column = split_column(layout)
        row = column.row()
        row.active = len(eyes) == 1
        row.prop(observer, "eye", expand=True)
        for prescription, name in ((observer.right, "Right (OD)"), (observer.left, "Left (OS)")):
            draw_prescription(layout, context, prescription, name, prescription.EYE in eyes)
        column = split_column(layout)
        column.prop(observer, "vertex_mm", text="Vertex Distance (mm)")
        column.prop(observer, "age", text="Age (years)")
        if batch.overrides != batch.Overrides():
            layout.label(text="The command line overrides some of this", icon="INFO")


class EYE_RENDER_PT_camera_prescription(_Prescription, CameraTab, Panel):
    pass


class EYE_RENDER_PT_prescription(_Prescription, SceneCameraTab, Panel):
    pass


classes = (EYE_RENDER_PT_camera_prescription, EYE_RENDER_PT_prescription)
