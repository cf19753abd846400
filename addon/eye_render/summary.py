"""What the panels tell of the observer's eyes as the scene stands now, without a render."""

import math
from typing import NamedTuple

import bpy

from . import batch, core, found
from .core import EyeRenderError
from .export.camera import focus_distance_m, middle_matrix
from .observer import focus, has_automatic_pupil, make_observer, observer_arguments, seen_eyes
from .reporting import facts_of

_ANSWERS = 8  # remembered: panels ask at every redraw, in two tabs for two eyes


# A schematic eye's map takes longer to fit than the few rays of a line to trace.
_TRACED = {"exact_trace": True}


class Summary(NamedTuple):
    line: str  # blur, far and near point and pupil; or why they are not known
    accommodation: str = ""  # how far the eye accommodates, and why no further, if that is known


_answers: dict[str, Summary] = {}


def summaries(context: bpy.types.Context, camera: bpy.types.Object) -> list[Summary]:
    """One for each eye that a render would look with."""
    settings = camera.data.eye_render
    eyes = seen_eyes(context.scene, settings, batch.overrides)
    return [_summary_of(context, camera, eye, is_one_of_two=len(eyes) > 1) for eye in eyes]


def _summary_of(
    context: bpy.types.Context, camera: bpy.types.Object, eye: str, is_one_of_two: bool
) -> Summary:
    settings = camera.data.eye_render
    overrides = batch.overrides
    unknown = []  # what only a render finds
    pupil = centre_m = None
    if has_automatic_pupil(settings, overrides):
        pupil = found.last_pupil(camera.data)
        if pupil is None:
            unknown.append("the pupil")
    # The graph as it is: drawing must not evaluate it anew.
    depsgraph = context.view_layer.depsgraph
    focus_m = focus_distance_m(depsgraph, camera, middle_matrix(camera))
    if focus(settings, overrides, focus_m) == "center":
        centre_m = found.last_centre_m(camera.data)
        if centre_m is None:
            unknown.append("what is at the image centre")
    try:
        arguments = observer_arguments(
            settings,
            context.scene.eye_render,
            overrides,
            eye,
            focus_m,
            pupil.diameter_mm if pupil else settings.pupil_mm,
            math.inf if centre_m is None else centre_m,
        )
        line, accommodation = _answer(arguments)
    except EyeRenderError as error:
        return Summary(str(error))
    if unknown:
        line = f"Blur: the first render finds {' and '.join(unknown)}"
    else:
        line += f", as found in {pupil.where}" if pupil else ""
        line += "; image centre as the last render found it" if centre_m else ""
    if is_one_of_two:
        return Summary(_of_eye(eye, line), _of_eye(eye, accommodation))
    return Summary(line, accommodation)


def _of_eye(eye: str, sentence: str) -> str:
    return f"{eye.title()} eye: {sentence[:1].lower()}{sentence[1:]}"


def _answer(arguments: dict[str, object]) -> Summary:
    """Of an observer whose pupil and focus are known."""
    asked = repr(arguments)
    if asked not in _answers:
        # The report needs the native module, without which the panels still say why it is missing.
        from .report import subject_of, summary_line

        observer = make_observer(arguments | _TRACED if "exact_trace" in arguments else arguments)
        facts = facts_of(observer)
        subject = subject_of(observer, facts)
        line = summary_line(subject, facts.get("focus_m", float("inf")))
        if len(_answers) == _ANSWERS:
            _answers.clear()
        of_age_d = core.require().accommodation_amplitude_d(
            arguments["age_years"], arguments["amplitude_formula"]
        )
        limit = "at this age" if subject.amplitude_d == of_age_d else "in this eye model"
        accommodation = f"Accommodation up to {subject.amplitude_d:.1f} D {limit}"
        _answers[asked] = Summary(line, accommodation)
    return _answers[asked]
