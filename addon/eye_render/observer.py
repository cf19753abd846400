"""From a camera's properties and the command line to the core's eye and observer."""

import math

import bpy

from . import choices, core, prescription, wavefront
from .batch import Overrides
from .core import EyeRenderError


def seen_eyes(
    scene: bpy.types.Scene, settings: bpy.types.PropertyGroup, overrides: Overrides
) -> tuple[str, ...]:
    """The eyes that a scene is rendered with: "RIGHT", "LEFT" or both."""
    if scene.render.use_multiview:
        return ("RIGHT", "LEFT")
    return (overrides.side or settings.eye,)


def observer_arguments(
    settings: bpy.types.PropertyGroup,
    scene_settings: bpy.types.PropertyGroup,
    overrides: Overrides,
    eye: str,
    focus_m: float,
    known_pupil_mm: float | None,
) -> dict[str, object]:
    """What the core's Observer with the given eye ("RIGHT" or "LEFT") is told.

    `focus_m` is what the eye looks at if its focus mode is DISTANCE, `known_pupil_mm` what an
    automatic pupil was found to be before. Raises EyeRenderError or ValueError.
    """
    pupil = _pupil(settings, overrides)
    if pupil == "auto" and known_pupil_mm is not None:
        pupil = known_pupil_mm
    field_area_deg2 = None
    if settings.pupil_field == "FIXED":
        field_area_deg2 = math.pi / 4 * settings.pupil_field_deg**2
    return {
        **eye_arguments(settings, overrides, eye),
        "age_years": settings.age if overrides.age is None else overrides.age,
        "amplitude_formula": settings.amplitude_formula,
        "pupil": pupil,
        "pupil_formula": settings.pupil_formula,
        "cd_m2_per_unit": scene_settings.cd_m2_per_unit,
        "luminance_sigma": scene_settings.luminance_sigma,
        "field_area_deg2": field_area_deg2,
        "eyes": settings.pupil_eyes,
        "focus": focus(settings, overrides, focus_m),
    }


def make_observer(arguments: dict[str, object]):
    """The core's Observer of `observer_arguments`."""
    with core.speaking() as eyecore:
        return eyecore.Observer(**arguments)


def eye_arguments(
    settings: bpy.types.PropertyGroup, overrides: Overrides, eye: str
) -> dict[str, object]:
    """What the core's Observer and its Eye are told alike. Raises EyeRenderError or ValueError."""
    model = _model(settings, overrides)
    arguments = {
        "model": model.lower(),
        "rx": _own(settings, overrides, eye),
        "vertex_mm": settings.vertex_mm,
        **_worn(settings, overrides, eye),
    }
    if model == "WAVEFRONT":
        arguments["wavefront"] = _wavefront(settings, overrides, eye)
    elif model in choices.SCHEMATIC_MODELS:
        arguments["refraction_zero"] = settings.refraction_zero.lower()
        arguments["exact_trace"] = settings.exact_trace
    return arguments


def focus(settings: bpy.types.PropertyGroup, overrides: Overrides, focus_m: float) -> str | float:
    """ "relaxed", "center" or metres."""
    if overrides.focus is not None:
        return overrides.focus
    return {"RELAXED": "relaxed", "CENTER": "center", "DISTANCE": focus_m}[settings.focus_mode]


def has_automatic_pupil(settings: bpy.types.PropertyGroup, overrides: Overrides) -> bool:
    """Whether the light of the scene decides how wide the pupil is."""
    return _model(settings, overrides) != "PINHOLE" and _pupil(settings, overrides) == "auto"


def _model(settings: bpy.types.PropertyGroup, overrides: Overrides) -> str:
    if overrides.model is not None:
        return overrides.model
    return "WAVEFRONT" if overrides.wavefront is not None else settings.model


def _pupil(settings: bpy.types.PropertyGroup, overrides: Overrides) -> str | float:
    if overrides.pupil is not None:
        return overrides.pupil
    return "auto" if settings.pupil_mode == "AUTO" else settings.pupil_mm


def _own(settings: bpy.types.PropertyGroup, overrides: Overrides, eye: str):
    text = overrides.rx_left if eye == "LEFT" else overrides.rx
    if text is not None:
        return prescription.parse(text, eye)
    own = settings.left if eye == "LEFT" else settings.right
    _refuse(own.problem(), f"Prescription of the {eye.lower()} eye")
    return own.as_core()


def _worn(settings: bpy.types.PropertyGroup, overrides: Overrides, eye: str) -> dict[str, object]:
    correction = settings.correction
    if overrides.worn == "none":
        correction = "NONE"
    elif overrides.worn is not None and correction == "NONE":
        correction = "GLASSES"
    if correction == "NONE":
        return {}
    arguments = {
        "correction": correction.lower(),
        "near_part": correction == "GLASSES" and settings.worn_add,
    }
    if overrides.worn is None:
        worn = settings.left_worn if eye == "LEFT" else settings.right_worn
        _refuse(worn.problem(), f"What the {eye.lower()} eye wears")
        arguments["worn"] = worn.as_core()
    elif overrides.worn != "own":
        arguments["worn"] = prescription.parse(overrides.worn, eye)
    return arguments


def _wavefront(settings: bpy.types.PropertyGroup, overrides: Overrides, eye: str):
    """None for the mean of healthy eyes."""
    measured = overrides.wavefront
    if measured is None:
        if settings.wavefront_source == "POPULATION":
            return None
        measured = settings.left_wavefront if eye == "LEFT" else settings.right_wavefront
        if not measured.is_there:
            raise EyeRenderError(f"No wavefront of the {eye.lower()} eye has been imported")
    elif measured.side not in ("", prescription.SIDE_OF_EYE[eye]):
        raise EyeRenderError(
            f"--eye-wavefront is of the eye {measured.side}, "
            f"but this picture is seen with the {eye.lower()} eye"
        )
    return wavefront.as_core(measured)


def _refuse(problem: str, what: str) -> None:
    if problem:
        raise EyeRenderError(f"{what}: {problem}")
