"""What moves in feature scenes. Inside Blender."""

import bpy


def animated(owner: bpy.types.bpy_struct, path: str, before, after) -> None:
    """Linear between frames 0 and 2, seen at frame 1."""
    for frame, value in ((0, before), (2, after)):
        setattr(owner, path, value)
        owner.keyframe_insert(path, frame=frame)
    for curve in curves_of(owner.id_data.animation_data.action):
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"
    bpy.context.scene.frame_set(1)


def moved(owner: bpy.types.bpy_struct, path: str, before, after) -> None:
    """The same, blurred over one frame."""
    animated(owner, path, before, after)
    render = bpy.context.scene.render
    render.use_motion_blur, render.motion_blur_shutter = True, 1.0


def curves_of(action: bpy.types.Action):
    if hasattr(action, "fcurves"):
        return action.fcurves
    return action.layers[0].strips[0].channelbags[0].fcurves  # from Blender 5.0
