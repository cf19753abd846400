"""Who looks through a camera: both eyes, what they wear, and how they answer to light and age."""

from bpy.props import (
    BoolProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)
from bpy.types import PropertyGroup

from .. import choices
from ..prescription import (
    EyeRenderLeftPrescription,
    EyeRenderLeftWorn,
    EyeRenderRightPrescription,
    EyeRenderRightWorn,
)
from ..prescription import classes as _prescription_classes
from ..wavefront import MAX_TERMS


class EyeRenderWavefront(PropertyGroup):
    """The aberrations measured in one eye, in the clinician's frame."""

    is_there: BoolProperty(name="Imported", description="Whether a measurement was imported")
    source: StringProperty(name="Source", description="The file that was imported")
    coefficients_um: FloatVectorProperty(
        name="Coefficients",
        description="Zernike coefficients in micrometres by OSA/ANSI index",
        size=MAX_TERMS,
        precision=4,
    )
    pupil_mm: FloatProperty(
        name="Pupil", description="Diameter in millimetres of the pupil measured", default=6.0
    )
    wavelength_nm: FloatProperty(
        name="Wavelength",
        description="Wavelength in nanometres of the light measured with",
        default=555.0,
    )


class EyeRenderObserver(PropertyGroup):
    """Who looks through a camera."""

    eye: EnumProperty(
        name="Eye",
        description="The eye that a picture without stereo is seen with",
        items=choices.EYES,
        default="RIGHT",
    )
    right: PointerProperty(type=EyeRenderRightPrescription, name="Right Eye (OD)")
    left: PointerProperty(type=EyeRenderLeftPrescription, name="Left Eye (OS)")
    vertex_mm: FloatProperty(
        name="Vertex Distance",
        description="Distance in millimetres from cornea to glasses, refracted with or worn",
        default=12.0,
        min=choices.VERTEX_RANGE_MM[0],
        max=choices.VERTEX_RANGE_MM[1],
        step=100,
        precision=1,
    )
    correction: EnumProperty(
        name="Correction",
        description="What is worn before the eyes",
        items=choices.CORRECTIONS,
        default="NONE",
    )
    right_worn: PointerProperty(type=EyeRenderRightWorn, name="Worn, Right Eye (OD)")
    left_worn: PointerProperty(type=EyeRenderLeftWorn, name="Worn, Left Eye (OS)")
    worn_add: BoolProperty(
        name="Near Part",
        description="Look through the part of the glasses with the reading addition",
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
    pupil_field: EnumProperty(
        name="Adapting Field",
        description="The field whose light the pupil answers to",
        items=choices.PUPIL_FIELDS,
        default="CAMERA",
    )
    pupil_field_deg: FloatProperty(
        name="Field Diameter",
        description="Diameter in degrees of the disc that fills the adapting field",
        default=60.0,
        min=choices.FIELD_RANGE_DEG[0],
        max=choices.FIELD_RANGE_DEG[1],
        step=100,
        precision=1,
    )
    pupil_eyes: IntProperty(
        name="Eyes",
        description="How many eyes see the light: with one covered, both pupils are wider",
        default=2,
        min=1,
        max=2,
    )
    pupil_hold: BoolProperty(
        name="Hold in Animations",
        description="Keep the pupil that the first frame of a render finds for all its frames",
    )
    focus_mode: EnumProperty(
        name="Focus",
        description="What the eye accommodates to, as far as its age allows",
        items=choices.FOCUS_MODES,
        default="RELAXED",
    )
    amplitude_formula: EnumProperty(
        name="Amplitude",
        description="Published formula that gives the accommodation left at an age",
        items=choices.AMPLITUDE_FORMULAS,
        default="HOFSTETTER_MEAN",
    )
    model: EnumProperty(
        name="Eye Model",
        description="How the eye turns a point of its pupil into a ray",
        items=choices.EYE_MODELS,
        default="PARAXIAL",
    )
    refraction_zero: EnumProperty(
        name="Zero Refraction",
        description="What a prescription of zero means for an eye with real surfaces",
        items=choices.REFRACTION_ZEROS,
        default="PARAXIAL",
    )
    exact_trace: BoolProperty(
        name="Exact Rays",
        description="Trace every ray through the surfaces, which is slower than their fitted map",
    )
    wavefront_source: EnumProperty(
        name="Wavefront",
        description="Whose higher-order aberrations the wavefront model has",
        items=choices.WAVEFRONT_SOURCES,
        default="POPULATION",
    )
    right_wavefront: PointerProperty(type=EyeRenderWavefront, name="Wavefront, Right Eye (OD)")
    left_wavefront: PointerProperty(type=EyeRenderWavefront, name="Wavefront, Left Eye (OS)")


classes = (*_prescription_classes, EyeRenderWavefront, EyeRenderObserver)
