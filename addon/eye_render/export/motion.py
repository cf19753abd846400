"""What moves while the shutter is open. Blender's scene is gone through at times before and after
the picture's own; what is found is kept until the geometry is handed over at its own."""

import math
from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple

import bpy
from mathutils import Matrix

from .. import compat, cycles_settings, passes
from .camera import CameraPose, Frame, pose_of
from .light import LampPose, lamp_differs, lamp_pose
from .pose import Pose
from .sources import TYPES, Source, sources_of

MIDDLE = Fraction(1, 2)  # time runs from 0, when the shutter opens, to 1, when it closes

Key = tuple[int, ...]


# What has an animation of its own, besides the camera.
_MOVING_TYPES = TYPES | {"LIGHT"}

# Of the Vector pass: from the frame before to the frame after.
_FRAMES_OF_VECTORS = 2.0
_STEPS_OF_VECTORS = 3

_STEPS_OF_CURVE = 256


class Shutter(NamedTuple):
    """Times in frames."""

    middle: float
    open_for: float
    blurs: bool = True  # else what moves is for the Vector pass alone
    curve: tuple[float, ...] = ()  # how far it is open at equally spaced times; empty: always

    def frame_at(self, time: Fraction) -> float:
        return self.middle + float(time - MIDDLE) * self.open_for

    def steps_of(self, shown: bpy.types.Object, placer: bpy.types.Object) -> int:
        """At how many times an object is looked at; 0 for one that is not to be blurred."""
        if not self.blurs:
            return _STEPS_OF_VECTORS
        steps = 1
        for owner in (shown, placer):
            settings = cycles_settings.of(owner)
            if settings is None:
                continue
            if not settings.use_motion_blur:
                return 0
            steps = max(steps, settings.motion_steps)
        return 2**steps + 1

    def settings(self) -> dict[str, object]:
        """Keywords of `eyecore.Settings`."""
        return {"motion_blur": self.blurs, "shutter_curve": self.curve}


def shutter_of(
    scene: bpy.types.Scene, view_layer: bpy.types.ViewLayer, warn: Callable[[str], None]
) -> Shutter | None:
    """None for a picture in which nothing moves."""
    render = scene.render
    frame = scene.frame_current + scene.frame_subframe
    if passes.needs_motion(scene, view_layer):
        return Shutter(frame, _FRAMES_OF_VECTORS, blurs=False)
    if not passes.blurs_motion(scene, view_layer):
        return None
    if getattr(cycles_settings.of(scene), "rolling_shutter_type", "NONE") != "NONE":
        warn("A rolling shutter is not supported: all of the picture is seen at once")
    ahead = {"START": 0.5, "CENTER": 0.0, "END": -0.5}[compat.shutter_position(scene)]
    open_for = render.motion_blur_shutter
    return Shutter(frame + ahead * open_for, open_for, curve=_curve_of(render))


def _curve_of(render: bpy.types.RenderSettings) -> tuple[float, ...]:
    mapping = render.motion_blur_shutter_curve
    mapping.initialize()
    values = tuple(
        max(mapping.evaluate(mapping.curves[0], step / _STEPS_OF_CURVE), 0.0)
        for step in range(_STEPS_OF_CURVE + 1)
    )
    # A shutter that is never open lets light in as one that always is, as in Cycles.
    return values if max(values) > min(values) else ()


def times_of(steps: int) -> list[Fraction]:
    """Equally spaced, the middle among them."""
    return [Fraction(step, steps - 1) for step in range(steps)]


def key_of(instance: bpy.types.DepsgraphObjectInstance) -> Key:
    """The same for the same instance at any time."""
    if not instance.is_instance:
        return (instance.object.original.as_pointer(),)
    return (instance.parent.original.as_pointer(), *instance.persistent_id)


def _may_deform(shown: bpy.types.Object, scene: bpy.types.Scene) -> bool:
    settings = cycles_settings.of(shown)
    if settings is not None and not settings.use_deform_motion:
        return False
    # Hair, curves and points may change without a modifier of the kind.
    is_mesh_alone = shown.type == "MESH" and not shown.particle_systems
    return not is_mesh_alone or shown.is_deform_modified(scene, "RENDER")


class Motion:
    """What is there at each time but the middle."""

    def __init__(self, shutter: Shutter):
        self.shutter = shutter
        self._lamps: dict[Fraction, dict[Key, LampPose]] = {}
        self._matrices: dict[Fraction, dict[Key, Matrix]] = {}
        self._poses: dict[Fraction, dict[tuple[Key, str], Pose]] = {}
        self._cameras: dict[str, dict[Fraction, CameraPose]] = {}

    def matrices(self, key: Key, middle: Matrix, steps: int) -> list[Matrix]:
        """At all times; an instance that is not found at one is there where it is half way."""
        return [
            middle if time == MIDDLE else self._matrices.get(time, {}).get(key, middle)
            for time in times_of(steps)
        ]

    def poses(
        self, instance: bpy.types.DepsgraphObjectInstance, source: Source, steps: int
    ) -> list[Pose]:
        """At all times; none if nothing deforms, or if other vertices are there at some time."""
        place = (key_of(instance), source.part)
        if place not in self._poses.get(Fraction(0), {}):
            return []
        middle = source.pose()
        poses = [
            middle if time == MIDDLE else self._poses.get(time, {}).get(place)
            for time in times_of(steps)
        ]
        if not all(pose is not None and pose.is_like(middle) for pose in poses):
            return []
        return poses if any(pose.differs(middle) for pose in poses) else []

    def lamp_poses(
        self, instance: bpy.types.DepsgraphObjectInstance, placer: bpy.types.Object
    ) -> list[LampPose]:
        """At all times; none of a lamp that keeps still."""
        shown, key = instance.object, key_of(instance)
        middle = lamp_pose(shown.data, instance.matrix_world)
        poses = [
            middle if time == MIDDLE else self._lamps.get(time, {}).get(key, middle)
            for time in times_of(self.shutter.steps_of(shown, placer))
        ]
        return poses if any(lamp_differs(pose, middle) for pose in poses) else []

    def camera_poses(self, view_name: str) -> list[CameraPose]:
        """At the camera's times; the middle one alone if it is not to be blurred."""
        found = self._cameras[view_name]
        return [found[time] for time in sorted(found)]

    def record_camera(self, view_name: str, time: Fraction, pose: CameraPose) -> None:
        self._cameras.setdefault(view_name, {})[time] = pose

    def record(self, time: Fraction, depsgraph: bpy.types.Depsgraph) -> None:
        """What the depsgraph shows at that time."""
        scene = depsgraph.scene_eval
        matrices = self._matrices[time] = {}
        poses = self._poses[time] = {}
        lamps = self._lamps[time] = {}
        by_source: dict[tuple[int, str], Pose] = {}
        for instance in depsgraph.object_instances:
            shown = instance.object
            if shown.type not in _MOVING_TYPES or not (
                instance.show_self or instance.show_particles
            ):
                continue
            placer = instance.parent if instance.is_instance else shown
            steps = self.shutter.steps_of(shown, placer)
            if not steps or time not in times_of(steps):
                continue
            key = key_of(instance)
            if shown.type == "LIGHT":
                lamps[key] = lamp_pose(shown.data, instance.matrix_world)
                continue
            matrices[key] = instance.matrix_world.copy()
            if _may_deform(shown, scene):
                for source in sources_of(instance, depsgraph):
                    if source.key not in by_source:
                        by_source[source.key] = source.pose()
                    poses[key, source.part] = by_source[source.key]


def record_motion(
    engine: bpy.types.RenderEngine,
    depsgraph: bpy.types.Depsgraph,
    shutter: Shutter,
    frame: Frame,
    check_cancel: Callable[[], None],
) -> Motion:
    """Go through the times at which the shutter is open, and leave Blender at the middle one."""
    motion = Motion(shutter)
    camera = engine.camera_override or depsgraph.scene_eval.camera
    camera_times = {MIDDLE, *times_of(shutter.steps_of(camera, camera))}
    views = [view.name for view in engine.get_result().views]
    others = sorted({*camera_times, *_times_of_objects(depsgraph, shutter)} - {MIDDLE})
    for time in (*others, MIDDLE):
        check_cancel()
        frame_number = shutter.frame_at(time)
        # By the engine, whose own copy of the scene is to change, not the user's.
        engine.frame_set(math.floor(frame_number), frame_number % 1.0)
        if time != MIDDLE:
            motion.record(time, depsgraph)
        if time in camera_times:
            camera = engine.camera_override or depsgraph.scene_eval.camera
            for view_name in views:
                engine.active_view_set(view_name)
                pose = pose_of(engine, depsgraph, camera, frame)
                motion.record_camera(view_name, time, pose)
    return motion


def _times_of_objects(depsgraph: bpy.types.Depsgraph, shutter: Shutter) -> set[Fraction]:
    counts = {
        shutter.steps_of(
            instance.object, instance.parent if instance.is_instance else instance.object
        )
        for instance in depsgraph.object_instances
        if instance.object.type in _MOVING_TYPES
    }
    return {time for steps in counts if steps for time in times_of(steps)}
