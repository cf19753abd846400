"""The camera of one view: where it stands, its window of slopes, and what it focuses at."""

from collections.abc import Sequence
from typing import NamedTuple

import bpy
import numpy as np

from .. import core
from ..core import EyeRenderError


class Frame(NamedTuple):
    """The full picture in pixels, and the part of it that is rendered."""

    width: int
    height: int
    border: tuple[int, int, int, int] | None  # x0, y0, x1, y1 from the lower left corner


def frame_of(render: bpy.types.RenderSettings) -> Frame:
    """Rounded as Blender rounds."""
    width = render.resolution_x * render.resolution_percentage // 100
    height = render.resolution_y * render.resolution_percentage // 100
    if not render.use_border:
        return Frame(width, height, None)
    # In single precision, or the border would be off by one where the product is an integer.
    left, right = np.float32((render.border_min_x, render.border_max_x)) * np.float32(width)
    bottom, top = np.float32((render.border_min_y, render.border_max_y)) * np.float32(height)
    return Frame(width, height, (int(left), int(bottom), int(right), int(top)))


def metres_per_unit(scene: bpy.types.Scene) -> float:
    units = scene.unit_settings
    return 1.0 if units.system == "NONE" else units.scale_length


def check_camera(camera: bpy.types.Object | None) -> None:
    """Raise EyeRenderError for what no eye can be put in place of."""
    if camera is None or camera.type != "CAMERA":
        raise EyeRenderError("The scene has no camera to look through")
    if camera.data.type != "PERSP":
        kind = camera.data.bl_rna.properties["type"].enum_items[camera.data.type].name
        raise EyeRenderError(
            f"Camera '{camera.name}' is {kind.lower()}; an eye needs a perspective camera"
        )


def middle_matrix(camera: bpy.types.Object) -> np.ndarray:
    """Where the camera stands in a render, between its stereo views: no scale counts."""
    return np.array(camera.matrix_world.normalized())


class CameraPose(NamedTuple):
    """As the engine's active stereo view has the camera at one time."""

    world_from_camera: np.ndarray
    slope_bounds: tuple[float, float, float, float]

    def differs(self, other: "CameraPose") -> bool:
        return self.slope_bounds != other.slope_bounds or bool(
            (self.world_from_camera != other.world_from_camera).any()
        )


def pose_of(
    engine: bpy.types.RenderEngine,
    depsgraph: bpy.types.Depsgraph,
    camera: bpy.types.Object,
    frame: Frame,
) -> CameraPose:
    return CameraPose(
        np.array(engine.camera_model_matrix(camera), np.float64),
        _slope_bounds(engine, depsgraph, camera, frame),
    )


def set_camera(
    core_scene,
    engine: bpy.types.RenderEngine,
    depsgraph: bpy.types.Depsgraph,
    camera: bpy.types.Object,
    frame: Frame,
    poses: Sequence[CameraPose] = (),
) -> None:
    """Put the camera, as the engine's active stereo view has it, into the core's scene: now, or
    with the poses that it has while the shutter is open."""
    poses = poses or [pose_of(engine, depsgraph, camera, frame)]
    middle = poses[len(poses) // 2]
    moves = any(pose.differs(middle) for pose in poses)
    with core.speaking(f"Camera '{camera.name}'"):
        core_scene.set_camera(
            *middle,
            (frame.width, frame.height),
            border=frame.border,
            clip=(camera.data.clip_start, camera.data.clip_end),
            metres_per_unit=metres_per_unit(depsgraph.scene_eval),
            **({"motion": list(poses)} if moves else {}),
        )


def _slope_bounds(
    engine: bpy.types.RenderEngine,
    depsgraph: bpy.types.Depsgraph,
    camera: bpy.types.Object,
    frame: Frame,
) -> tuple[float, float, float, float]:
    """(left, right, bottom, top) of the full frame, from slope = (ndc + offset) / scale."""
    render = depsgraph.scene_eval.render
    projection = camera.calc_matrix_camera(
        depsgraph,
        x=frame.width,
        y=frame.height,
        scale_x=render.pixel_aspect_x,
        scale_y=render.pixel_aspect_y,
    )
    # The projection knows the camera's own shift but not the stereo view's. Blender measures
    # shifts in the side that the sensor is fitted to.
    stereo_shift = engine.camera_shift_x(camera) - camera.data.shift_x
    sides = (frame.width * render.pixel_aspect_x, frame.height * render.pixel_aspect_y)
    fit = camera.data.sensor_fit
    fitted = {"HORIZONTAL": sides[0], "VERTICAL": sides[1], "AUTO": max(sides)}[fit]
    offset_x = projection[0][2] + 2.0 * stereo_shift * fitted / sides[0]
    offset_y = projection[1][2]
    return (
        (offset_x - 1.0) / projection[0][0],
        (offset_x + 1.0) / projection[0][0],
        (offset_y - 1.0) / projection[1][1],
        (offset_y + 1.0) / projection[1][1],
    )


def focus_distance_m(
    depsgraph: bpy.types.Depsgraph, camera: bpy.types.Object, world_from_camera: np.ndarray
) -> float:
    """Distance along the line of sight to the camera's focus object, or its focus distance."""
    focus = camera.data.dof
    distance = focus.focus_distance
    if focus.focus_object is not None:
        target = focus.focus_object.evaluated_get(depsgraph)
        world_from_target = target.matrix_world
        bone = target.pose.bones.get(focus.focus_subtarget) if target.pose else None
        if bone is not None:
            world_from_target = world_from_target @ bone.matrix
        towards = np.array(world_from_target.translation) - world_from_camera[:3, 3]
        distance = abs(float(towards @ world_from_camera[:3, 2]))
    return distance * metres_per_unit(depsgraph.scene_eval)
