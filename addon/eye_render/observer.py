"""From a camera's properties and the command line to the core's eye and observer."""

import math

import bpy

from . import choices, core, prescription, wavefront
from .batch import Overrides, ruled
from .core import BadValueError, EyeRenderError


def is_stereo(render: bpy.types.RenderSettings) -> bool:
    """Whether the camera's views are those of two eyes; views may also be cameras of their own."""
    return render.use_multiview and render.views_format == "STEREO_3D"


def eye_of_view(
    render: bpy.types.RenderSettings,
    view_name: str,
    settings: bpy.types.PropertyGroup,
    overrides: Overrides,
) -> str:
    """The eye, "RIGHT" or "LEFT", that a view of the camera with these settings is seen with."""
    return view_name.upper() if is_stereo(render) else overrides.side or settings.eye


def seen_eyes(
    scene: bpy.types.Scene, settings: bpy.types.PropertyGroup, overrides: Overrides
) -> tuple[str, ...]:
    """The eyes that a scene is rendered with: "RIGHT", "LEFT" or both."""
    views = ("right", "left") if is_stereo(scene.render) else ("",)
    return tuple(eye_of_view(scene.render, view, settings, overrides) for view in views)


def observer_arguments(
    settings: bpy.types.PropertyGroup,
    scene_settings: bpy.types.PropertyGroup,
    overrides: Overrides,
    eye: str,
    focus_m: float,
    known_pupil_mm: float | None = None,
    known_centre_m: float | None = None,
) -> dict[str, object]:
    """What the core's Observer with the given eye ("RIGHT" or "LEFT") is told.

    `focus_m` is what the eye looks at if its focus mode is DISTANCE, `known_pupil_mm` what an
    automatic pupil and `known_centre_m` the distance of the image centre were found to be before.
    Raises EyeRenderError.
    """
    pupil = _pupil(settings, overrides)
    if pupil == "auto" and known_pupil_mm is not None:
        pupil = known_pupil_mm
    looked_at = focus(settings, overrides, focus_m)
    if looked_at == "center" and known_centre_m is not None:
        looked_at = known_centre_m
    with core.speaking():
        of_the_eye = eye_arguments(settings, overrides, eye)
    return {
        **of_the_eye,
        "age_years": ruled(overrides.age, settings.age),
        "amplitude_formula": settings.amplitude_formula,
        "pupil": pupil,
        "pupil_formula": settings.pupil_formula,
        "cd_m2_per_unit": scene_settings.cd_m2_per_unit,
        "luminance_sigma": scene_settings.luminance_sigma,
        "field_area_deg2": _field_area_deg2(settings, overrides),
        "eyes": settings.pupil_eyes,
        "focus": looked_at,
    }


def make_observer(arguments: dict[str, object]):
    """The core's Observer of `observer_arguments`."""
    with core.speaking() as eyecore:
        return eyecore.Observer(**arguments)


def eye_arguments(
    settings: bpy.types.PropertyGroup, overrides: Overrides, eye: str
) -> dict[str, object]:
    """What the core's Observer and its Eye are told alike. Raises EyeRenderError or ValueError."""
    model = model_of(settings, overrides)
    arguments = {
        "model": model.lower(),
        "rx": _own(settings, overrides, eye),
        "vertex_mm": ruled(overrides.vertex, settings.vertex_mm),
        **_worn(settings, overrides, eye),
    }
    if model == "WAVEFRONT":
        arguments["wavefront"] = _wavefront(settings, overrides, eye)
    elif model in choices.SCHEMATIC_MODELS:
        zero = overrides.refraction_zero or settings.refraction_zero
        arguments["refraction_zero"] = zero.lower()
        arguments["exact_trace"] = ruled(overrides.exact_trace, settings.exact_trace)
    return arguments


def focus(settings: bpy.types.PropertyGroup, overrides: Overrides, focus_m: float) -> str | float:
    """ "relaxed", "center" or metres."""
    of_file = {"RELAXED": "relaxed", "CENTER": "center", "DISTANCE": focus_m}[settings.focus_mode]
    asked = ruled(overrides.focus, of_file)
    return focus_m if asked == "camera" else asked


def has_automatic_pupil(settings: bpy.types.PropertyGroup, overrides: Overrides) -> bool:
    """Whether the light of the scene decides how wide the pupil is."""
    return model_of(settings, overrides) != "PINHOLE" and _pupil(settings, overrides) == "auto"


def holds_pupil(settings: bpy.types.PropertyGroup, overrides: Overrides) -> bool:
    """Whether the frames of an animation share the automatic pupil of the first."""
    is_held = ruled(overrides.pupil_hold, settings.pupil_hold)
    return is_held and has_automatic_pupil(settings, overrides)


def model_of(settings: bpy.types.PropertyGroup, overrides: Overrides) -> str:
    if overrides.model is not None:
        return overrides.model
    has_file = overrides.wavefront is not None or overrides.wavefront_left is not None
    return "WAVEFRONT" if has_file else settings.model


def correction_of(settings: bpy.types.PropertyGroup, overrides: Overrides, eye: str) -> str:
    """What the eye wears: "NONE", "GLASSES" or "CONTACTS"."""
    worn = worn_override(overrides, eye)
    if worn == "none":
        return "NONE"
    correction = overrides.correction or settings.correction
    return "GLASSES" if correction == "NONE" and worn is not None else correction


def worn_override(overrides: Overrides, eye: str) -> str | None:
    """ "none", "own" or a prescription; None where the command line says nothing."""
    return overrides.worn if eye == "RIGHT" else ruled(overrides.worn_left, overrides.worn)


def _pupil(settings: bpy.types.PropertyGroup, overrides: Overrides) -> str | float:
    of_file = "auto" if settings.pupil_mode == "AUTO" else settings.pupil_mm
    return ruled(overrides.pupil, of_file)


def _field_area_deg2(settings: bpy.types.PropertyGroup, overrides: Overrides) -> float | None:
    """None for the picture's own field."""
    of_file = settings.pupil_field_deg if settings.pupil_field == "FIXED" else "picture"
    diameter_deg = ruled(overrides.pupil_field, of_file)
    return None if diameter_deg == "picture" else math.pi / 4 * diameter_deg**2


def _own(settings: bpy.types.PropertyGroup, overrides: Overrides, eye: str):
    text = overrides.rx_left if eye == "LEFT" else overrides.rx
    if text is not None:
        return prescription.parse(text, eye)
    own = settings.left if eye == "LEFT" else settings.right
    _refuse(own.problem(), f"Prescription of the {eye.lower()} eye")
    return own.as_core()


def _worn(settings: bpy.types.PropertyGroup, overrides: Overrides, eye: str) -> dict[str, object]:
    correction = correction_of(settings, overrides, eye)
    if correction == "NONE":
        return {}
    is_near = ruled(overrides.worn_part, "NEAR" if settings.worn_add else "FAR") == "NEAR"
    arguments = {
        "correction": correction.lower(),
        "near_part": correction == "GLASSES" and is_near,
    }
    text = worn_override(overrides, eye)
    if text is None:
        worn = settings.left_worn if eye == "LEFT" else settings.right_worn
        _refuse(worn.problem(), f"What the {eye.lower()} eye wears")
        arguments["worn"] = worn.as_core()
    elif text != "own":
        arguments["worn"] = prescription.parse(text, eye)
    return arguments


def _wavefront(settings: bpy.types.PropertyGroup, overrides: Overrides, eye: str):
    """None for the mean of healthy eyes."""
    of_file = settings.left_wavefront if eye == "LEFT" else settings.right_wavefront
    measured = _wavefront_override(overrides, eye)
    if measured is None:
        has_own = settings.wavefront_source == "MEASURED" and of_file.is_there
        others = overrides.wavefront or overrides.wavefront_left
        if others is not None and not has_own:
            raise BadValueError(_only_of_the_other(others, eye))
        if settings.wavefront_source == "POPULATION":
            return None
        measured = of_file
        if not measured.is_there:
            raise EyeRenderError(f"No wavefront of the {eye.lower()} eye has been imported")
    elif measured.side not in ("", prescription.SIDE_OF_EYE[eye]):
        raise BadValueError(
            f"the wavefront is of the eye {measured.side}, "
            f"but this picture is seen with the {eye.lower()} eye"
        )
    return wavefront.as_core(measured)


def _wavefront_override(overrides: Overrides, eye: str) -> wavefront.WavefrontFile | None:
    """What the command line says of this eye. Left and right eyes mirror each other, so no file is
    for both; --eye-wavefront is for the right one, unless its file says that it is of the left."""
    if eye == "RIGHT":
        return overrides.wavefront
    of_left = overrides.wavefront is not None and overrides.wavefront.side == "OS"
    return ruled(overrides.wavefront_left, overrides.wavefront if of_left else None)


def _only_of_the_other(others: wavefront.WavefrontFile, eye: str) -> str:
    if eye == "RIGHT":
        return (
            "--eye-wavefront-left is of the left eye, but this picture is seen with the right "
            "eye; expected --eye-wavefront FILE of that eye, too"
        )
    whose = "is of the eye OD" if others.side else "names no eye and so is of the right one"
    says_so = "" if others.side else ", or a line eye,OS in the file if it is of that eye"
    return (
        f"the file of --eye-wavefront {whose}, but this picture is seen with the left eye; "
        f"expected --eye-wavefront-left FILE{says_so}"
    )


def _refuse(problem: str, what: str) -> None:
    if problem:
        raise EyeRenderError(f"{what}: {problem}")
