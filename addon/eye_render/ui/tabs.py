"""Where the engine's panels stand in the properties editor, and how they write sentences."""

import re
import textwrap

import bpy

NAME_SHARE = 0.4  # of the width, in Blender's property columns
_MARGIN_PX = 80  # of a panel: its borders, the icon, the scroll bar
_LETTER_WIDTH_PX = 5.6  # on average, in Blender's own font
_FEWEST_LETTERS = 16


class Tab:
    """Mix-in for panels that only Eye Render shows."""

    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    COMPAT_ENGINES = {"EYE_RENDER"}

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES


class RenderTab(Tab):
    bl_context = "render"


class CameraTab(Tab):
    """The data tab of a camera."""

    bl_context = "data"

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.camera is not None

    @staticmethod
    def camera(context: bpy.types.Context) -> bpy.types.Camera:
        return context.camera

    @staticmethod
    def camera_object(context: bpy.types.Context) -> bpy.types.Object | None:
        """Who stands with that camera; None where the data alone is pinned."""
        shown = context.object
        return shown if shown is not None and shown.data == context.camera else None


class SceneCameraTab(RenderTab):
    """The render tab, for the camera that the scene is rendered with."""

    @classmethod
    def poll(cls, context):
        camera = context.scene.camera
        return super().poll(context) and camera is not None and camera.type == "CAMERA"

    @staticmethod
    def camera(context: bpy.types.Context) -> bpy.types.Camera:
        return context.scene.camera.data

    @staticmethod
    def camera_object(context: bpy.types.Context) -> bpy.types.Object:
        return context.scene.camera


def split_column(layout: bpy.types.UILayout) -> bpy.types.UILayout:
    """A column in Blender's style: name at the left, value at the right."""
    layout.use_property_split = True
    return layout.column()


def draw_sentence(
    layout: bpy.types.UILayout, context: bpy.types.Context, text: str, icon: str = "ERROR"
) -> None:
    """A text as wide as the region allows, in red if its icon is ERROR."""
    column = layout.column(align=True)
    column.use_property_split = False
    column.alert = icon == "ERROR"
    width = context.region.width / context.preferences.system.ui_scale - _MARGIN_PX
    letters = max(_FEWEST_LETTERS, int(width / _LETTER_WIDTH_PX))
    unbroken = re.sub(r"(\d) (?=(m|mm|D)\b)", "\\1\u00a0", text)
    for number, line in enumerate(textwrap.wrap(unbroken, letters)):
        column.label(text=line, icon="BLANK1" if number else icon)
