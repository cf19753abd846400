"""Reports on the observer of a camera: as the picture is rendered, or as the scene stands now."""

import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import bpy
import numpy as np

from . import batch, core
from .core import EyeRenderError
from .export import export_scene
from .export.camera import check_camera, focus_distance_m, frame_of, middle_matrix, set_camera
from .observer import has_automatic_pupil, make_observer, observer_arguments, seen_eyes
from .session import effects

# The report needs the native module, without which the add-on still shows why it is missing.
if TYPE_CHECKING:
    from .report import Subject, Written


def write(subject: "Subject", distances_m: Sequence[float], path: Path) -> "Written":
    """Write the report, at the usual distances if none are given; EyeRenderError says what is in
    the way."""
    from .report import distances_of, write_report

    try:
        return write_report(subject, distances_m or distances_of(subject), path)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise EyeRenderError(f"The report {path} cannot be written: {reason}") from error
    except ValueError as error:
        raise EyeRenderError(f"There is no report: {error}") from error


def has_other_frames(engine: bpy.types.RenderEngine) -> bool:
    """Whether what is rendered may be one of several frames. Blender takes -f, too, for an
    animation, which has one frame if it is alone."""
    return engine.is_animation and not batch.asks_for_one_frame(sys.argv)


def write_of_picture(
    path: Path, observer, facts: dict[str, str | float], view: str, frame: int | None
) -> str:
    """The report that --eye-report asks for, in a file of its own for each stereo view, and for
    each frame where there may be several; the sentence that says so."""
    from .report import subject_of

    path = Path(bpy.path.abspath(str(path)))
    number = () if frame is None else (f"{frame:04d}",)  # as Blender numbers pictures
    path = path.with_stem(".".join((path.stem, *number, *filter(None, [view]))))
    distances_m = batch.overrides.report_distances or ()
    written = write(subject_of(observer, facts), distances_m, path)
    return f"report: {path}" + (f"; {written.note}" if written.note else "")


def subjects_in(context: bpy.types.Context, warn: Callable[[str], None]) -> dict[str, "Subject"]:
    """Each eye that looks through the scene's camera ("RIGHT", "LEFT"), found as a render finds
    it, in the scene as the viewport evaluates it. `warn` takes sentences on what is left out."""
    from .report import subject_of

    scene = context.scene
    check_camera(scene.camera)
    depsgraph = context.evaluated_depsgraph_get()
    camera = scene.camera.evaluated_get(depsgraph)
    settings = scene.camera.data.eye_render  # the evaluated ones may lag behind
    focus_m = focus_distance_m(depsgraph, camera, middle_matrix(camera))
    core_scene = None
    known_pupil_mm = known_centre_m = None  # one person's eyes are alike and look at one thing
    subjects = {}
    for eye in seen_eyes(scene, settings, batch.overrides):
        arguments = observer_arguments(
            settings,
            scene.eye_render,
            batch.overrides,
            eye,
            focus_m,
            known_pupil_mm,
            known_centre_m,
        )
        observer = make_observer(arguments)
        if not looks_at_the_scene(arguments):
            facts = facts_of(observer)
        else:
            if core_scene is None:
                core_scene, _ = export_scene(depsgraph, warn, check_cancel=lambda: None)
                frame = frame_of(scene.render)
                set_camera(core_scene, _Middle(), depsgraph, camera, frame)
            with core.speaking() as eyecore:
                facts = eyecore.Session(core_scene, observer, eyecore.Settings()).facts
        if has_automatic_pupil(settings, batch.overrides):
            known_pupil_mm = facts["pupil_mm"]
        if arguments["focus"] == "center":
            known_centre_m = facts["focus_m"]
        elif known_centre_m is not None:
            facts["focus"] = "center"
        shown = effects(scene.eye_render, batch.overrides)
        shown["chromatic"] = "yes" if shown["chromatic"] else "no"  # as a session tells it
        subjects[eye] = subject_of(observer, facts | {"eye": eye.lower(), **shown})
    return subjects


def looks_at_the_scene(arguments: dict[str, object]) -> bool:
    """Whether pupil or accommodation depend on what is before the eye."""
    return arguments["focus"] == "center" or arguments["pupil"] == "auto"


class _Middle:
    """Says where a camera stands as a render engine does, between its stereo views."""

    @staticmethod
    def camera_model_matrix(camera: bpy.types.Object) -> np.ndarray:
        return middle_matrix(camera)

    @staticmethod
    def camera_shift_x(camera: bpy.types.Object) -> float:
        return camera.data.shift_x


def facts_of(observer) -> dict[str, str | float]:
    """What a session tells of an observer who sees nothing."""
    with core.speaking() as eyecore:
        nothing = eyecore.Scene()
        nothing.set_camera(np.eye(4), (-1.0, 1.0, -1.0, 1.0), (1, 1))
        return eyecore.Session(nothing, observer, eyecore.Settings()).facts
