"""Renders a picture inside Blender and keeps it twice: as measured, and as it is looked at."""

from pathlib import Path

import bpy


def render_picture(path: Path) -> None:
    """`path`, an EXR that the render itself writes, so that it carries the observer in its
    metadata; and a PNG of the same name as the file's view transform shows it."""
    scene = bpy.context.scene
    image = scene.render.image_settings
    image.file_format, image.color_mode, image.color_depth = "OPEN_EXR", "RGB", "32"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image.file_format, image.color_depth = "PNG", "8"
    result = bpy.data.images["Render Result"]
    result.save_render(str(path.with_suffix(".png")), scene=scene)
