"""Property groups: the observer of a camera, the rendering of a scene, the view layer's passes."""

import bpy
from bpy.props import (
    BoolProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)
from bpy.types import PropertyGroup

from . import choices, core

_step_in_progress = False  # one side of a prescription is being written from the other


def _write_in_step(prescription: "EyeRenderPrescription", **values) -> None:
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
        rx = core.module.Prescription.parse(self.text)
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


class EyeRenderPrescription(PropertyGroup):
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
            core.module.Prescription.parse(self.text)
        except ValueError as error:
            return str(error)
        return ""


class EyeRenderObserver(PropertyGroup):
    """Who looks through a camera."""

    eye: EnumProperty(
        name="Eye",
        description="The eye that a picture without stereo is seen with",
        items=choices.EYES,
        default="RIGHT",
    )
    right: PointerProperty(type=EyeRenderPrescription, name="Right Eye (OD)")
    left: PointerProperty(type=EyeRenderPrescription, name="Left Eye (OS)")
    vertex_mm: FloatProperty(
        name="Vertex Distance",
        description="Distance in millimetres from cornea to lens at which the eye was refracted",
        default=12.0,
        min=0.0,
        max=30.0,
        step=100,
        precision=1,
    )
    age: FloatProperty(
        name="Age",
        description="Age in years, which limits accommodation and narrows the pupil",
        default=30.0,
        min=choices.AGE_RANGE_YEARS[0],
        max=choices.AGE_RANGE_YEARS[1],
        step=100,
        precision=0,
    )
    pupil_mode: EnumProperty(
        name="Pupil",
        description="Where the pupil's diameter comes from",
        items=choices.PUPIL_MODES,
        default="AUTO",
    )
    pupil_mm: FloatProperty(
        name="Diameter",
        description="Diameter of the entrance pupil in millimetres",
        default=4.0,
        min=choices.PUPIL_RANGE_MM[0],
        max=choices.PUPIL_RANGE_MM[1],
        soft_min=1.5,
        step=25,
        precision=2,
    )
    pupil_formula: EnumProperty(
        name="Formula",
        description="Published formula that gives the pupil's diameter from luminance",
        items=choices.PUPIL_FORMULAS,
        default="WATSON_YELLOTT",
    )
    focus_mode: EnumProperty(
        name="Focus",
        description="What the eye accommodates to, as far as its age allows",
        items=choices.FOCUS_MODES,
        default="RELAXED",
    )
    model: EnumProperty(
        name="Eye Model",
        description="How the eye turns a point of its pupil into a ray",
        items=choices.EYE_MODELS,
        default="PARAXIAL",
    )


class EyeRenderScene(PropertyGroup):
    """How a scene is rendered."""

    quality: EnumProperty(
        name="Quality",
        description="Points of the trade-off between time and noise",
        items=choices.QUALITIES,
        default="FINAL",
    )
    samples: IntProperty(
        name="Samples",
        description="Number of samples for each pixel",
        default=256,
        min=choices.SAMPLES_RANGE[0],
        max=choices.SAMPLES_RANGE[1],
        soft_max=16384,
    )
    max_bounces: IntProperty(
        name="Max Bounces",
        description="Longest path of light, counted in reflections and refractions",
        default=8,
        min=0,
        max=1024,
        soft_max=64,
    )
    seed: IntProperty(
        name="Seed",
        description="Number that chooses the noise pattern",
        min=choices.SEED_RANGE[0],
        max=choices.SEED_RANGE[1],
    )
    pupil_pattern: EnumProperty(
        name="Pupil Pattern",
        description="How sample points are spread over the pupil",
        items=choices.PUPIL_PATTERNS,
        default="SOBOL",
    )
    cd_m2_per_unit: FloatProperty(
        name="Luminance of 1.0",
        description="Candelas per square metre of a white surface whose pixel value is 1",
        default=179.0,
        min=1e-6,
        max=1e9,
        soft_max=1e4,
        precision=2,
    )
    luminance_sigma: FloatProperty(
        name="Weighting Width",
        description="Width of the Gaussian weight around the image centre, of half the image size",
        default=0.5,
        min=0.01,
        max=10.0,
        precision=2,
    )


class EyeRenderPasses(PropertyGroup):
    """The passes that Blender has no switch for."""

    use_pass_albedo: BoolProperty(
        name="Albedo", description="Deliver the colour of surfaces without light"
    )
    use_pass_defocus: BoolProperty(
        name="Defocus", description="Deliver the defocus of what each pixel shows, in dioptres"
    )
    use_pass_blur: BoolProperty(
        name="Blur", description="Deliver the size of the blur at each pixel, in minutes of arc"
    )


_classes = (EyeRenderPrescription, EyeRenderObserver, EyeRenderScene, EyeRenderPasses)


def register():
    for cls in _classes:
        bpy.utils.register_class(cls)
    bpy.types.Camera.eye_render = PointerProperty(type=EyeRenderObserver)
    bpy.types.Scene.eye_render = PointerProperty(type=EyeRenderScene)
    bpy.types.ViewLayer.eye_render = PointerProperty(type=EyeRenderPasses)


def unregister():
    del bpy.types.ViewLayer.eye_render
    del bpy.types.Scene.eye_render
    del bpy.types.Camera.eye_render
    for cls in reversed(_classes):
        bpy.utils.unregister_class(cls)
