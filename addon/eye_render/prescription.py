"""One eye's prescription: the text that is typed, and the numbers that it means, kept in step."""

import bpy
from bpy.props import FloatProperty, StringProperty

from . import core

SIDE_OF_EYE = {"RIGHT": "OD", "LEFT": "OS"}
_EYE_OF_SIDE = {"OD": "right", "OS": "left"}

_step_in_progress = False  # one side of a prescription is being written from the other


def parse(text: str, eye: str):
    """The core's Prescription of the `eye` ("RIGHT" or "LEFT"); ValueError tells what is wrong."""
    rx = core.require().Prescription.parse(text)
    if rx.eye in _EYE_OF_SIDE and rx.eye != SIDE_OF_EYE[eye]:
        raise ValueError(
            f"{rx.eye} means the {_EYE_OF_SIDE[rx.eye]} eye, "
            f"but this is the prescription of the {eye.lower()} eye"
        )
    return _of_side(SIDE_OF_EYE[eye], rx)


def _of_side(side: str, rx):
    """The same prescription for the side "OD", "OS" or "", which tells where the nose is."""
    return core.require().Prescription(
        rx.sphere_d,
        rx.cylinder_d,
        rx.axis_deg,
        rx.add_d,
        base_in_pd=rx.base_in_pd,
        base_up_pd=rx.base_up_pd,
        eye=side,
    )


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
        self,
        sphere=rx.sphere_d,
        cylinder=rx.cylinder_d,
        axis=rx.axis_deg,
        add=rx.add_d,
        base_in=rx.base_in_pd,
        base_up=rx.base_up_pd,
    )


def _number_changed(self, _context):
    if _step_in_progress or core.module is None:
        return
    try:
        text = _of_side("", self._numbers()).text()
    except ValueError:
        return
    _write_in_step(self, text=text)


class _Prescription:
    """A prescription for the eye `EYE`. The text, while valid, equals the numbers."""

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
        description="Reading addition in dioptres, in the near part of glasses",
        min=0.0,
        max=4.0,
        step=25,
        precision=2,
        update=_number_changed,
    )
    base_in: FloatProperty(
        name="Prism In",
        description="Prism in prism dioptres with its base towards the nose, negative outwards",
        min=-30.0,
        max=30.0,
        soft_min=-10.0,
        soft_max=10.0,
        step=50,
        precision=2,
        update=_number_changed,
    )
    base_up: FloatProperty(
        name="Prism Up",
        description="Prism in prism dioptres with its base upwards, negative downwards",
        min=-30.0,
        max=30.0,
        soft_min=-10.0,
        soft_max=10.0,
        step=50,
        precision=2,
        update=_number_changed,
    )

    def _numbers(self):
        # Blender's single precision turns -2.1 into -2.0999999; nobody means that.
        sphere, cylinder, axis, add, base_in, base_up = (
            round(number, 5)
            for number in (
                self.sphere,
                self.cylinder,
                self.axis,
                self.add,
                self.base_in,
                self.base_up,
            )
        )
        return core.require().Prescription(
            sphere,
            cylinder,
            axis,
            add,
            base_in_pd=base_in,
            base_up_pd=base_up,
            eye=SIDE_OF_EYE[self.EYE],
        )

    def as_core(self):
        """The numbers as the core's Prescription; they lead, because they can be animated."""
        return self._numbers()

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
        if core.module is None or self.problem() or not self.text.strip():
            return ""
        numbers = self._numbers()
        typed = parse(self.text, self.EYE)
        # As powers, since an axis of 0 is one of 180.
        if all(abs(a - b) < 1e-5 for a, b in zip(_powers(numbers), _powers(typed), strict=True)):
            return ""
        return f"The numbers rule, not the text: {_of_side('', numbers).text()}"


def _powers(rx) -> tuple[float, ...]:
    return (*rx.power_vector(), rx.add_d, rx.base_in_pd, rx.base_up_pd)


class _Own(_Prescription):
    """What the eye needs to see well, for glasses at the vertex distance."""

    text: StringProperty(
        name="Prescription",
        description='What an optician writes, for example "-2.00DS -0.75DC 160A"',
        default="Plano",
        update=_text_changed,
    )


class _Worn(_Prescription):
    """What the lenses in use are made to; without a text, what the eye needs."""

    text: StringProperty(
        name="Worn",
        description="What the lens worn is made to; empty for what the eye needs",
        update=_text_changed,
    )

    def as_core(self):
        """None for what the eye needs."""
        return self._numbers() if self.text.strip() else None

    def problem(self) -> str:
        return super().problem() if self.text.strip() else ""


class EyeRenderRightPrescription(_Own, bpy.types.PropertyGroup):
    EYE = "RIGHT"


class EyeRenderLeftPrescription(_Own, bpy.types.PropertyGroup):
    EYE = "LEFT"


class EyeRenderRightWorn(_Worn, bpy.types.PropertyGroup):
    EYE = "RIGHT"


class EyeRenderLeftWorn(_Worn, bpy.types.PropertyGroup):
    EYE = "LEFT"


classes = (
    EyeRenderRightPrescription,
    EyeRenderLeftPrescription,
    EyeRenderRightWorn,
    EyeRenderLeftWorn,
)
