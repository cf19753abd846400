"""What the command line asks for that nothing comes of, given the rest of it and the file."""

import bpy

from . import choices
from .batch import OptionError, Overrides
from .observer import correction_of, model_of, worn_override


def check(settings: bpy.types.PropertyGroup, overrides: Overrides) -> None:
    """OptionError names the options that do not go together, and what would."""
    corrections = {correction_of(settings, overrides, eye) for eye, *_ in choices.EYES}
    worn = {worn_override(overrides, eye) for eye, *_ in choices.EYES}
    said = overrides.spoken
    if overrides.correction == "NONE" and worn - {None, "none"}:
        options = said(("--eye-correction", "--eye-worn", "--eye-worn-left"))
        raise OptionError(f"{options}; expected --eye-correction glasses or contacts")
    if overrides.correction in ("GLASSES", "CONTACTS") and worn == {"none"}:
        options = said(("--eye-correction", "--eye-worn", "--eye-worn-left"))
        raise OptionError(f"{options}; expected --eye-worn own or a prescription")
    if overrides.worn_part is not None and "GLASSES" not in corrections:
        options = said(("--eye-worn-part", "--eye-correction", "--eye-worn"))
        raise OptionError(f"{options}, but no glasses are worn; expected --eye-correction glasses")

    model = model_of(settings, overrides)
    of_wavefront = said(("--eye-wavefront", "--eye-wavefront-left"))
    if of_wavefront and model != "WAVEFRONT":
        raise OptionError(
            f"{of_wavefront}, {said(('--eye-model',))}; expected --eye-model wavefront"
        )
    of_surfaces = said(("--eye-refraction-zero", "--eye-exact-trace"))
    if of_surfaces and model not in choices.SCHEMATIC_MODELS:
        raise OptionError(
            f"{of_surfaces}, but the eye's model is {model.lower()}; "
            "expected --eye-model navarro, arizona or le_grand"
        )
    if overrides.report is not None and (model == "PINHOLE" or overrides.pupil == 0.0):
        options = said(("--eye-report", "--eye-model", "--eye-pupil"))
        raise OptionError(f"{options}, but an eye without a pupil's width has no blur to report")
