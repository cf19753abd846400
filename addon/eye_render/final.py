"""The final render: F12, animations and batch, each view of one view layer in turn."""

import time
from collections.abc import Callable

import bpy
import numpy as np

from . import batch, contradictions, cryptomatte, export, found, passes, reporting
from .core import EyeRenderError
from .export.camera import (
    CameraPose,
    Frame,
    check_camera,
    focus_distance_m,
    frame_of,
    set_camera,
)
from .export.motion import Motion, record_motion, shutter_of
from .observer import has_automatic_pupil, holds_pupil, make_observer, observer_arguments
from .session import RenderSession, make_settings

SLICE_S = 0.1  # between looks at the Esc key
FIRST_PICTURE_S = 0.5  # until the picture is shown for the first time
SLOWEST_PICTURE_S = 8.0
PICTURE_INTERVAL_GROWTH = 1.5

_EYE_OF_STEREO_VIEW = {"left": "LEFT", "right": "RIGHT"}


class _Cancelled(Exception):
    """The user pressed Esc."""


def _say(text: str) -> None:
    print(f"Eye Render: {text}", flush=True)


def _make_warn(engine: bpy.types.RenderEngine) -> Callable[[str], None]:
    """A function that says each sentence once."""
    said: set[str] = set()

    def warn(sentence: str) -> None:
        if sentence in said:
            return
        said.add(sentence)
        _say(f"warning: {sentence}")
        if not bpy.app.background:  # where Blender would print it a second time
            engine.report({"WARNING"}, sentence)

    return warn


def render(engine: bpy.types.RenderEngine, depsgraph: bpy.types.Depsgraph) -> None:
    """Render the depsgraph's view layer into the engine's result. Raises what goes wrong."""

    def check_cancel() -> None:
        if engine.test_break():
            raise _Cancelled

    warn = _make_warn(engine)
    view_layer = depsgraph.view_layer_eval
    camera = engine.camera_override or depsgraph.scene_eval.camera
    check_camera(camera)
    settings = camera.data.eye_render
    contradictions.check(settings, batch.overrides)
    is_held = holds_pupil(settings, batch.overrides)
    passes.add(engine, view_layer)
    try:
        engine.update_stats("", "Exporting the scene")
        core_scene, motion = _export(engine, depsgraph, warn, check_cancel)
        camera = engine.camera_override or depsgraph.scene_eval.camera
        known_pupil = found.first_pupil_of_render(camera.data) if is_held else None
        for view in engine.get_result().views:
            engine.active_view_set(view.name)
            # One person's pupils are alike: the views share the first one's.
            camera_poses = motion.camera_poses(view.name) if motion else []
            known_pupil = _render_view(
                engine, depsgraph, core_scene, camera_poses, view.name, known_pupil, warn
            )
    except _Cancelled:
        return


def _export(
    engine: bpy.types.RenderEngine,
    depsgraph: bpy.types.Depsgraph,
    warn: Callable[[str], None],
    check_cancel: Callable[[], None],
) -> tuple[object, Motion | None]:
    """The core's scene and, of a picture with motion blur, what moves in it."""
    scene, motion = depsgraph.scene_eval, None
    frame = (scene.frame_current, scene.frame_subframe)
    shutter = shutter_of(scene, depsgraph.view_layer_eval, warn)
    try:
        if shutter:
            picture = frame_of(scene.render)
            motion = record_motion(engine, depsgraph, shutter, picture, check_cancel)
        core_scene, names = export.export_scene(depsgraph, warn, check_cancel, motion)
    finally:
        if shutter:
            engine.frame_set(*frame)  # animations count on it
    cryptomatte.stamp(engine.get_result(), depsgraph.view_layer_eval, names)
    return core_scene, motion


def _render_view(
    engine: bpy.types.RenderEngine,
    depsgraph: bpy.types.Depsgraph,
    core_scene,
    camera_poses: list[CameraPose],
    view_name: str,
    known_pupil: found.Pupil | None,
    warn: Callable[[str], None],
) -> found.Pupil | None:
    """The automatic pupil that the view was seen with, if it was."""
    scene = depsgraph.scene_eval
    camera = engine.camera_override or scene.camera
    overrides = batch.overrides
    frame = frame_of(scene.render)
    set_camera(core_scene, engine, depsgraph, camera, frame, camera_poses)

    settings = camera.data.eye_render
    eye = _EYE_OF_STEREO_VIEW.get(view_name, overrides.side or settings.eye)
    own, others = ("rx", "rx_left") if eye == "RIGHT" else ("rx_left", "rx")
    if not view_name and getattr(overrides, own) is None and getattr(overrides, others):
        option = f"--eye-{others.replace('_', '-')}"
        warn(f"{option} is not for the {eye.lower()} eye, which this picture is seen with")
    world_from_camera = np.array(engine.camera_model_matrix(camera))
    observer = make_observer(
        observer_arguments(
            settings,
            scene.eye_render,
            overrides,
            eye,
            focus_distance_m(depsgraph, camera, world_from_camera),
            known_pupil.diameter_mm if known_pupil else None,
        )
    )
    core_settings = make_settings(scene, depsgraph.view_layer_eval, overrides)

    engine.update_stats("", "Preparing the render")
    with RenderSession(core_scene, observer, core_settings) as session:
        for line in session.plan_text.strip().splitlines():
            _say(line)
        where = f"frame {scene.frame_current}" + (f", view {view_name}" if view_name else "")
        pupil = known_pupil
        if known_pupil:
            _say(f"pupil: {known_pupil.report}, as in {known_pupil.where}")
        else:
            _say(f"pupil: {session.pupil_report}")
            if has_automatic_pupil(settings, overrides):
                pupil = found.pupil_by(session, where)
        for sentence in session.warnings:
            warn(sentence)
        facts = {**session.facts, "eye": eye.lower()}
        if pupil:
            facts.update(pupil.facts)
            found.remember_pupil(camera.data, pupil)
        found.remember_focus(camera.data, session)
        _stamp(engine, facts, view_name)
        _show_until_finished(engine, depsgraph, session, frame, view_name)
        if session.lost_rays:
            _say(session.lost_rays)
        if overrides.report is not None:
            number = scene.frame_current if reporting.has_other_frames(engine) else None
            _say(reporting.write_of_picture(overrides.report, observer, facts, view_name, number))
    return pupil


def _stamp(engine: bpy.types.RenderEngine, facts: dict[str, str | float], view_name: str) -> None:
    """Write the observer into the file's metadata; each stereo view has its own."""
    result = engine.get_result()
    suffix = f".{view_name}" if view_name else ""
    for key, fact in facts.items():
        text = fact if isinstance(fact, str) else f"{fact:.6g}"
        result.stamp_data_add_field(f"eye_render:{key}{suffix}", text)


def _show_until_finished(
    engine: bpy.types.RenderEngine,
    depsgraph: bpy.types.Depsgraph,
    session: RenderSession,
    frame: Frame,
    view_name: str,
) -> None:
    """Pull pictures from the session at growing intervals, and the finished one at its end."""

    def show() -> None:
        _write(engine, depsgraph.view_layer_eval.name, view_name, frame, session.snapshot())

    is_watched = not bpy.app.background
    interval_s = FIRST_PICTURE_S
    next_picture = time.monotonic() + interval_s
    while not session.wait(SLICE_S):
        done = session.progress()
        if engine.test_break():
            if is_watched and done.samples_done > 0:
                show()
            raise _Cancelled
        engine.update_progress(done.fraction)
        engine.update_stats(view_name, f"Sample {done.samples_done}/{done.samples}")
        if is_watched and time.monotonic() >= next_picture:
            show()
            interval_s = min(interval_s * PICTURE_INTERVAL_GROWTH, SLOWEST_PICTURE_S)
            next_picture = time.monotonic() + interval_s
    show()
    done = session.progress()
    engine.update_progress(done.fraction)
    engine.update_stats(view_name, f"Sample {done.samples_done}/{done.samples}")


def _write(
    engine: bpy.types.RenderEngine,
    layer_name: str,
    view_name: str,
    frame: Frame,
    pixels: dict[str, np.ndarray],
) -> None:
    # With a border Blender hands out a result of the border's size, whatever is asked for.
    result = engine.begin_result(0, 0, frame.width, frame.height, layer=layer_name, view=view_name)
    height, width, _ = pixels["Combined"].shape
    expected = (result.resolution_x, result.resolution_y)
    if (width, height) != expected:
        engine.end_result(result, cancel=True)
        raise EyeRenderError(f"The picture has {width}x{height} pixels, Blender wants {expected}")
    passes.write(result.layers[0], pixels)
    engine.end_result(result)
