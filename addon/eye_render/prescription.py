"""One eye's prescription: the text that is typed, and the numbers that it means, kept in step."""

import bpy
from bpy.props import FloatProperty, StringProperty

from . import core

_SIDE_OF_EYE = {"RIGHT": "OD", "LEFT": "OS"}
_EYE_OF_SIDE = {"OD": "right", "OS": "left"}

_step_in_progress = False  # one side of a prescription is being written from the other


def parse(text: str, eye: str):
    """The core's Prescription of the `eye` ("RIGHT" or "LEFT"); ValueError tells what is wrong."""
    rx = core.require().Prescription.parse(text)
    if rx.eye in _EYE_OF_SIDE and rx.eye != _SIDE_OF_EYE[eye]:
        raise ValueError(
            f"{rx.eye} means the {_EYE_OF_SIDE[rx.eye]} eye, "
            f"but this is the prescription of the {eye.lower()} eye"
        )
    return rx


def _write_in_step(prescription: "_Prescription", **values) -> None:
    """Set properties without their update callbacks writing back."""
    global _step_in_progress
    _step_in_progress = True
    try:
        for name, value in values.items():
            setattr(prescription, name, value)
    finally:
        _step_in_progress = False


def _text_changed(self, _context):
    if _step_in_progress or core.module is None:
        return
    try:
        rx = parse(self.text, self.EYE)
    except ValueError:
        return  # the numbers keep the last valid text; panel and render show `problem()`
    _write_in_step(
        self, sphere=rx.sphere_d, cylinder=rx.cylinder_d, axis=rx.axis_deg, add=rx.add_d
    )


def _number_changed(self, _context):
    if _step_in_progress or core.module is None:
        return
    try:
        text = self.as_core().text()
    except ValueError:
        return
    _write_in_step(self, text=text)


class _Prescription:
    """One eye's refraction at the spectacle plane. The text, while valid, equals the numbers."""

    text: StringProperty(
        name="Prescription",
        description='What an optician writes, for example "-2.00DS -0.75DC 160A"',
        default="Plano",
        update=_text_changed,
    )
    sphere: FloatProperty(
        name="Sphere",
        description="Spherical power in dioptres, negative for a short-sighted eye",
        min=-30.0,
        max=30.0,
        soft_min=-20.0,
        soft_max=20.0,
        step=25,
        precision=2,
        update=_number_changed,
    )
    cylinder: FloatProperty(
        name="Cylinder",
        description="Cylindrical power in dioptres, zero for an eye without astigmatism",
        min=-15.0,
        max=15.0,
        soft_min=-6.0,
        soft_max=6.0,
        step=25,
        precision=2,
        update=_number_changed,
    )
    axis: FloatProperty(
        name="Axis",
        description="Axis of the cylinder in degrees, counter-clockwise as the optician sees it",
        min=0.0,
        max=180.0,
        default=180.0,
        step=500,
        precision=0,
        update=_number_changed,
    )
    add: FloatProperty(
        name="Add",
        description="Reading addition in dioptres, kept with the prescription",
        min=0.0,
        max=4.0,
        step=25,
        precision=2,
        update=_number_changed,
    )

    def as_core(self):
        """The numbers as the core's Prescription; they lead, because they can be animated."""
        numbers = (self.sphere, self.cylinder, self.axis, self.add)
        # Blender's single precision turns -2.1 into -2.0999999; nobody means that.
        return core.require().Prescription(*(round(number, 5) for number in numbers))

    def problem(self) -> str:
        """What is wrong with the text, as a sentence; empty if nothing is."""
        if core.module is None:
            return ""
        try:
            parse(self.text, self.EYE)
        except ValueError as error:
            return str(error)
        return ""

    def disagreement(self) -> str:
        """A sentence on which rules where animated numbers left the text behind, else empty."""
        if core.module is None or self.problem():
            return ""
        numbers = self.as_core()
        typed = parse(self.text, self.EYE)
        # As powers, since an axis of 0 is one of 180.
        if all(abs(a - b) < 1e-5 for a, b in zip(_powers(numbers), _powers(typed), strict=True)):
            return ""
        return f"The numbers rule, not the text: {numbers.text()}"


def _powers(rx) -> tuple[float, ...]:
    return (*rx.power_vector(), rx.add_d)


class EyeRenderRightPrescription(_Prescription, bpy.types.PropertyGroup):
    """Of the right eye."""

    EYE = "RIGHT"


class EyeRenderLeftPrescription(_Prescription, bpy.types.PropertyGroup):
    """Of the left eye."""

    EYE = "LEFT"


classes = (EyeRenderRightPrescription, EyeRenderLeftPrescription)
