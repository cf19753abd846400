"""The final render: F12, animations and batch, each view of one view layer in turn."""

import time
from collections.abc import Callable
from typing import NamedTuple

import bpy
import numpy as np

from . import batch, contradictions, cryptomatte, export, found, passes, reporting
from .core import EyeRenderError
from .export.camera import (
    Frame,
    check_camera,
    focus_distance_m,
    frame_of,
    set_camera,
)
from .export.motion import Motion, record_motion, shutter_of
from .observer import (
    eye_of_view,
    focus,
    has_automatic_pupil,
    holds_pupil,
    is_stereo,
    make_observer,
    observer_arguments,
)
from .session import RenderSession, make_settings

SLICE_S = 0.1  # between looks at the Esc key
FIRST_PICTURE_S = 0.5  # until the picture is shown for the first time
SLOWEST_PICTURE_S = 8.0
PICTURE_INTERVAL_GROWTH = 1.5


class _Share(NamedTuple):
    """Which of the pictures that a render consists of: each view of each layer."""

    number: int  # from 0
    count: int

    def progress(self, fraction: float) -> float:
        return (self.number + fraction) / self.count


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
    layers = [layer.name for layer in engine.get_result().layers]
    views = [view.name for view in engine.get_result().views]
    for view_name in views:
        camera = _camera_of(engine, depsgraph, view_name)
        check_camera(camera)
        contradictions.check(camera.data.eye_render, batch.overrides)
    passes.add(engine, view_layer)
    try:
        engine.update_stats("", "Exporting the scene")
        core_scene, motion = _export(engine, depsgraph, warn, check_cancel)
        for number, view_name in enumerate(views, len(views) * layers.index(view_layer.name)):
            share = _Share(number, len(views) * len(layers))
            _render_view(engine, depsgraph, core_scene, motion, view_name, share, warn)
    except _Cancelled:
        return


def _camera_of(
    engine: bpy.types.RenderEngine, depsgraph: bpy.types.Depsgraph, view_name: str
) -> bpy.types.Object | None:
    """The view's own camera, or the one that the view is a place of; makes the view active."""
    engine.active_view_set(view_name)
    return engine.camera_override or depsgraph.scene_eval.camera


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
    motion: Motion | None,
    view_name: str,
    share: _Share,
    warn: Callable[[str], None],
) -> None:
    scene = depsgraph.scene_eval
    camera = _camera_of(engine, depsgraph, view_name)
    overrides = batch.overrides
    frame = frame_of(scene.render)
    camera_poses = motion.camera_poses(view_name) if motion else []
    set_camera(core_scene, engine, depsgraph, camera, frame, camera_poses)

    settings = camera.data.eye_render
    look = found.look_of_frame(camera, scene.frame_current + scene.frame_subframe)
    if holds_pupil(settings, overrides):
        look.pupil = found.first_pupil_of_render(camera.data)
    eye = eye_of_view(scene.render, view_name, settings, overrides)
    own, others = ("rx", "rx_left") if eye == "RIGHT" else ("rx_left", "rx")
    if (
        not is_stereo(scene.render)
        and getattr(overrides, own) is None
        and getattr(overrides, others)
    ):
        option = f"--eye-{others.replace('_', '-')}"
        warn(f"{option} is not for the {eye.lower()} eye, which this picture is seen with")
    world_from_camera = np.array(engine.camera_model_matrix(camera))
    focus_m = focus_distance_m(depsgraph, camera, world_from_camera)
    observer = make_observer(
        observer_arguments(
            settings,
            scene.eye_render,
            overrides,
            eye,
            focus_m,
            look.pupil.diameter_mm if look.pupil else None,
            look.centre_m,
        )
    )
    shutter = motion.shutter if motion else None
    core_settings = make_settings(scene, depsgraph.view_layer_eval, overrides, shutter)

    engine.update_stats("", "Preparing the render")
    with RenderSession(core_scene, observer, core_settings) as session:
        for line in session.plan_text.strip().splitlines():
            _say(line)
        where = f"frame {scene.frame_current}" + (f", view {view_name}" if view_name else "")
        if look.pupil:
            _say(f"pupil: {look.pupil.report}, as in {look.pupil.where}")
        else:
            _say(f"pupil: {session.pupil_report}")
            if has_automatic_pupil(settings, overrides):
                look.pupil = found.pupil_by(session, where)
        for sentence in session.warnings:
            warn(sentence)
        is_first_layer = view_name not in look.facts
        if is_first_layer:
            look.facts[view_name] = _facts(session, look, eye)
        if look.pupil:
            found.remember_pupil(camera.data, look.pupil)
        if focus(settings, overrides, focus_m) == "center":
            look.centre_m = session.facts["focus_m"]
            look.facts[view_name]["focus"] = "center"  # which the core is told the distance of
            found.remember_centre(camera.data, look.centre_m)
        facts = look.facts[view_name]
        _stamp(engine, facts, view_name)
        _show_until_finished(engine, depsgraph, session, frame, view_name, share)
        if session.lost_rays:
            _say(session.lost_rays)
        if overrides.report is not None and is_first_layer:
            number = scene.frame_current if reporting.has_other_frames(engine) else None
            _say(reporting.write_of_picture(overrides.report, observer, facts, view_name, number))


def _facts(session: RenderSession, look: found.Look, eye: str) -> dict[str, str | float]:
    """What the file tells of the observer."""
    of_pupil = look.pupil.facts if look.pupil else {}
    return {**session.facts, "eye": eye.lower(), **of_pupil}


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
    share: _Share,
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
        engine.update_progress(share.progress(done.fraction))
        engine.update_stats(view_name, f"Sample {done.samples_done}/{done.samples}")
        if is_watched and time.monotonic() >= next_picture:
            show()
            interval_s = min(interval_s * PICTURE_INTERVAL_GROWTH, SLOWEST_PICTURE_S)
            next_picture = time.monotonic() + interval_s
    show()
    done = session.progress()
    engine.update_progress(share.progress(done.fraction))
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
