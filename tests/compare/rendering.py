"""One render to an array, and what Eye Render says of it. Inside Blender."""

import contextlib
import io
import re
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np

_WARNING = re.compile(r"^Eye Render: warning: (.*)$", re.MULTILINE)


@dataclass
class Picture:
    rgba: np.ndarray  # linear, (height, width, 4), rows from the top
    seconds: float


def choose_exr(scene: bpy.types.Scene) -> None:
    image = scene.render.image_settings
    if hasattr(image, "media_type"):  # from Blender 5.0
        image.media_type = "IMAGE"
    image.file_format, image.color_mode, image.color_depth = "OPEN_EXR", "RGBA", "32"


def render(scene: bpy.types.Scene, exr: Path) -> Picture:
    scene.render.filepath = str(exr)
    start = time.monotonic()
    bpy.ops.render.render(write_still=True)
    seconds = time.monotonic() - start
    image = bpy.data.images.load(str(exr))
    image.colorspace_settings.name = "Non-Color"
    pixels = np.empty((image.size[1], image.size[0], 4), np.float32)
    image.pixels.foreach_get(pixels.ravel())
    bpy.data.images.remove(image)
    return Picture(pixels[::-1], seconds)


@contextlib.contextmanager
def warnings_of_eye_render() -> Iterator[list[str]]:
    """A list that is filled, at the end of the block, from what was printed within."""
    warnings: list[str] = []
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        yield warnings
    warnings += sorted(set(_WARNING.findall(printed.getvalue())))
