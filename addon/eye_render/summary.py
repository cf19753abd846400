"""One line for the panel on what the observer's eye makes of points, as the scene stands now."""

from dataclasses import replace

import bpy
import numpy as np

from . import batch, found
from .core import EyeRenderError
from .export.camera import focus_distance_m
from .observer import eye_arguments, focus, has_automatic_pupil, make_observer
from .reporting import metadata_of

_last: tuple[str, str] = ("", "")  # what was asked and answered: panels ask at every redraw


def line(context: bpy.types.Context, camera: bpy.types.Object) -> str:
    """Blur, far and near point and pupil; or why they are not known."""
    settings = camera.data.eye_render
    overrides = batch.overrides
    pupil = found.last_pupil(camera.data)
    if has_automatic_pupil(settings, overrides) and pupil is None:
        return "Blur: the first render finds the pupil"
    # The graph as it is: drawing must not evaluate it anew.
    depsgraph = context.view_layer.depsgraph
    focus_m = focus_distance_m(depsgraph, camera, np.array(camera.matrix_world))
    if focus(settings, overrides, focus_m) == "center":
        centre_m = found.last_focus_m(camera.data)
        if centre_m is None:
            return "Blur: the first render finds what is at the image centre"
        overrides = replace(overrides, focus=centre_m)
    eye = overrides.side or settings.eye
    pupil_mm = pupil.diameter_mm if pupil else None
    try:
        arguments = eye_arguments(settings, overrides, eye)
        observer = make_observer(
            settings, context.scene.eye_render, overrides, eye, focus_m, pupil_mm
        )
        return _summary(observer, f"{arguments} {observer!r}")
    except (EyeRenderError, ValueError) as error:
        return f"Blur: {error}"


def _summary(observer, asked: str) -> str:
    """`asked` tells everything that the answer depends on."""
    global _last
    if asked != _last[0]:
        # The report needs the native module, without which the panels still say why it is missing.
        from .report import subject_of, summary_line

        metadata = metadata_of(observer)
        focus_m = float(metadata.get("focus_m", "inf"))
        _last = (asked, summary_line(subject_of(observer, metadata), focus_m))
    return _last[1]
