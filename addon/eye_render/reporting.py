"""Reports on the observer of a camera: as the picture is rendered, or as the scene stands now."""

import math
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import bpy
import numpy as np

from . import batch, core, found
from .core import EyeRenderError
from .export.camera import check_camera, focus_distance_m, metres_per_unit
from .observer import focus, has_automatic_pupil, make_observer

# The report needs the native module, without which the add-on still shows why it is missing.
if TYPE_CHECKING:
    from .report import Subject, Written


def write(subject: "Subject", path: Path) -> "Written":
    """Write the report; EyeRenderError says what is in the way."""
    from .report import distances_of, write_report

    try:
        return write_report(subject, distances_of(subject), path)
    except OSError as error:
        raise EyeRenderError(f"The report cannot be written: {error}") from error
    except ValueError as error:
        raise EyeRenderError(f"There is no report: {error}") from error


def write_of_picture(path: Path, observer, metadata: dict[str, str], view: str) -> str:
    """The report that --eye-report asks for, each stereo view's in a file of its own; the sentence
    that says so. Of an animation, the last frame's stays."""
    from .report import subject_of

    path = Path(bpy.path.abspath(str(path)))
    if view:
        path = path.with_stem(f"{path.stem}.{view}")
    written = write(subject_of(observer, metadata), path)
    return f"report: {path}" + (f"; {written.note}" if written.note else "")


def subject_in(context: bpy.types.Context) -> "Subject":
    """The observer of the scene's camera, without a render. An automatic pupil is what the last
    render found."""
    from .report import subject_of

    scene = context.scene
    camera = scene.camera
    check_camera(camera)
    depsgraph = context.evaluated_depsgraph_get()
    settings = camera.data.eye_render
    overrides = batch.overrides
    eye = overrides.side or settings.eye
    world_from_camera = np.array(camera.matrix_world)
    focus_m = focus_distance_m(depsgraph, camera, world_from_camera)
    if focus(settings, overrides, focus_m) == "center":
        overrides = replace(overrides, focus=_distance_ahead_m(depsgraph, camera))
    pupil = found.last_pupil(camera.data)
    observer = make_observer(
        settings,
        scene.eye_render,
        overrides,
        eye,
        focus_m,
        pupil.diameter_mm if pupil else settings.pupil_mm,
    )
    source = "set"
    if has_automatic_pupil(settings, overrides):
        source = f"found in {pupil.where}" if pupil else "assumed: no render has found it yet"
    metadata = {**metadata_of(observer), "eye": eye.lower(), "pupil_source": source}
    return subject_of(observer, metadata)


def metadata_of(observer) -> dict[str, str]:
    """What a picture would say of the observer, from a session that sees nothing."""
    with core.speaking() as eyecore:
        nothing = eyecore.Scene()
        nothing.set_camera(np.eye(4), (-1.0, 1.0, -1.0, 1.0), (1, 1))
        return eyecore.Session(nothing, observer, eyecore.Settings()).metadata


def _distance_ahead_m(depsgraph: bpy.types.Depsgraph, camera: bpy.types.Object) -> float:
    """Along the camera's axis to the first surface, or infinity."""
    scene = depsgraph.scene
    at = camera.matrix_world
    ahead = -at.col[2].to_3d().normalized()
    start = at.translation + ahead * camera.data.clip_start
    is_hit, location, *_ = scene.ray_cast(depsgraph, start, ahead)
    if not is_hit:
        return math.inf
    return (location - at.translation).length * metres_per_unit(scene)
