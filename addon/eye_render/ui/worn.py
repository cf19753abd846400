"""The panel of what is worn: glasses or contact lenses, right for the eyes or not."""

import bpy
from bpy.types import Panel

from .. import batch
from ..observer import seen_eyes
from .prescription import draw_prescription
from .tabs import CameraTab, SceneCameraTab, draw_sentence, split_column


def _without_effect(observer: bpy.types.PropertyGroup, eye: str) -> str:
    """A sentence on what of the prescription the eye does not look through; empty if nothing."""
    own = observer.left if eye == "LEFT" else observer.right
    worn = observer.left_worn if eye == "LEFT" else observer.right_worn
    if observer.correction == "GLASSES":
        lens = worn if worn.text.strip() else own
        if observer.worn_add and lens.add == 0.0:
            return f"The {eye.lower()} eye's glasses have no add: the near part is like the rest"
        return ""
    has_prism = own.base_in != 0.0 or own.base_up != 0.0
    parts = [name for name, is_there in (("add", own.add > 0.0), ("prism", has_prism)) if is_there]
    if not parts:
        return ""
    verb = "has" if len(parts) == 1 else "have"
    return f"The {eye.lower()} eye's {' and '.join(parts)} {verb} no effect without glasses"


class _Worn:
    bl_label = "Glasses and Contacts"

    def draw(self, context):
        observer = self.camera(context).eye_render
        self.layout.row().prop(observer, "correction", expand=True)
        eyes = seen_eyes(context.scene, observer, batch.overrides)
        is_worn = observer.correction != "NONE" and observer.model != "PINHOLE"
        for worn, name in ((observer.right_worn, "Right"), (observer.left_worn, "Left")):
            # What is laid aside stays in sight.
            if observer.correction != "NONE" or worn.text.strip():
                is_used = is_worn and worn.EYE in eyes
                draw_prescription(self.layout, context, worn, name, is_used)
        if observer.correction == "GLASSES" or observer.worn_add:
            column = split_column(self.layout)
            column.active = is_worn and observer.correction == "GLASSES"
            column.prop(observer, "worn_add")
        if observer.model == "PINHOLE" and observer.correction != "NONE":
            sentence = "A pinhole eye sees everything sharply, and nothing of a lens"
            draw_sentence(self.layout, context, sentence, "INFO")
        for eye in eyes:
            sentence = _without_effect(observer, eye)
            if sentence:
                draw_sentence(self.layout, context, sentence, "INFO")


class EYE_RENDER_PT_camera_worn(_Worn, CameraTab, Panel):
    pass


class EYE_RENDER_PT_worn(_Worn, SceneCameraTab, Panel):
    pass


classes = (EYE_RENDER_PT_camera_worn, EYE_RENDER_PT_worn)
