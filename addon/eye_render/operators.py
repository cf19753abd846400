"""Operators of the add-on."""

import bpy
from bpy.props import EnumProperty, StringProperty
from bpy.types import Operator
from bpy_extras.io_utils import ImportHelper

from . import choices, wavefront
from .prescription import SIDE_OF_EYE


class EYE_RENDER_OT_import_wavefront(Operator, ImportHelper):
    """Read the aberrations of an eye from a CSV or JSON file"""

    bl_idname = "eye_render.import_wavefront"
    bl_label = "Import Wavefront"
    bl_options = {"REGISTER", "UNDO"}

    filter_glob: StringProperty(default="*.csv;*.json", options={"HIDDEN"})
    eye: EnumProperty(
        name="Eye", description="The eye that was measured", items=choices.EYES, default="RIGHT"
    )
    camera: StringProperty(
        name="Camera", description="Name of the camera that is this observer", options={"HIDDEN"}
    )

    def execute(self, context):
        camera = bpy.data.cameras.get(self.camera)
        if camera is None:
            self.report({"ERROR"}, f"There is no camera '{self.camera}'")
            return {"CANCELLED"}
        try:
            measured = wavefront.read(self.filepath)
            if measured.side not in ("", SIDE_OF_EYE[self.eye]):
                raise ValueError(f"the file is of the eye {measured.side}")
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        observer = camera.eye_render
        target = observer.left_wavefront if self.eye == "LEFT" else observer.right_wavefront
        target.source = bpy.path.basename(self.filepath)
        target.coefficients_um = measured.coefficients_um
        target.pupil_mm = measured.pupil_mm
        target.wavelength_nm = measured.wavelength_nm
        target.is_there = True
        observer.wavefront_source = "MEASURED"
        return {"FINISHED"}


_classes = (EYE_RENDER_OT_import_wavefront,)


def register():
    for cls in _classes:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_classes):
        bpy.utils.unregister_class(cls)
