"""How a scene is rendered, and which passes of a view layer are delivered."""

from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty
from bpy.types import PropertyGroup

from .. import choices


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
    chromatic: BoolProperty(
        name="Chromatic",
        description="Let the eye focus each colour at its own distance, as eyes do",
    )
    stiles_crawford: EnumProperty(
        name="Stiles-Crawford",
        description="Weight light by where it enters the pupil, as cones do, most in the middle",
        items=choices.STILES_CRAWFORD_MODES,
        default="OFF",
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
    """The passes that neither Blender nor Cycles has a switch for."""

    use_pass_defocus: BoolProperty(
        name="Defocus",
        description="Deliver the defocus of what each pixel shows, in dioptres, as on the axis",
    )
    use_pass_blur: BoolProperty(
        name="Blur",
        description="Deliver the blur by defocus and astigmatism at each pixel, in minutes of arc",
    )


classes = (EyeRenderScene, EyeRenderPasses)
