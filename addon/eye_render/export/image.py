"""Images to textures of the core: files by their path, everything else by its pixels."""

from collections.abc import Callable
from pathlib import Path

import bpy
import numpy as np

from ..working_space import working_space
from . import image_file

# As Cycles has it on a processor, Smart is Cubic.
_INTERPOLATIONS = {"Smart": "Cubic"}
# What the alpha of a file is, Cycles takes from the file.
_ALPHA_MODES = {"PREMUL": "STRAIGHT"}
_EXTENSIONS = {"REPEAT", "EXTEND", "CLIP"}
# The core's names of colour spaces by Blender's. What is Linear is in the working space.
_COLORSPACES = {
    "sRGB": "sRGB",
    "Linear": "Linear Rec.709",  # so called before Blender 4.0
    "Linear Rec.709": "Linear Rec.709",
    "scene_linear": "Linear",
    "Non-Color": "Non-Color",
    "Raw": "Non-Color",
}
MISSING_COLOR = (1.0, 0.0, 1.0)


class ImageTable:
    """The textures of one core scene, each (picture, way of reading it) once.

    Each way to ask gives None, after a warning, for what can only be shown as missing.
    """

    def __init__(self, core_scene, frame: int, warn: Callable[[str], None]):
        self._core_scene = core_scene
        self._frame = frame
        self._warn = warn
        self._textures: dict[tuple, int | None] = {}

    def texture(
        self,
        image: bpy.types.Image,
        user: bpy.types.ImageUser,
        extension: str = "REPEAT",
        interpolation: str = "Linear",
    ) -> int | None:
        """The picture that the user of the image shows at this frame."""
        if image.source == "SEQUENCE":
            path = image_file.of_frame(image, user, self._frame)
            return self._file(image, path, extension, interpolation)
        is_file = image.source == "FILE" and not image.packed_files and not image.is_dirty
        if is_file and (_known_colorspace(image) or not image.is_float):
            return self._file(image, image_file.of_image(image), extension, interpolation)
        return self._once(image, "", extension, interpolation, self._add_pixels)

    def tiles(
        self, image: bpy.types.Image, extension: str = "REPEAT", interpolation: str = "Linear"
    ) -> list[int]:
        """Number and texture of each UDIM tile, in turns."""
        if image.packed_files or not image_file.has_tile_mark(image):
            self._warn(f"Image '{image.name}' is shown magenta: its tiles are not in files")
            return []
        numbers = []
        for tile in image.tiles:
            path = image_file.of_tile(image, tile.number)
            numbers += [tile.number, self._file(image, path, extension, interpolation)]
        return numbers

    def _file(
        self, image: bpy.types.Image, path: Path, extension: str, interpolation: str
    ) -> int | None:
        def add(image: bpy.types.Image, **how: str) -> int:
            colorspace = self._colorspace(image)
            return self._core_scene.add_texture(str(path), colorspace=colorspace, **how)

        return self._once(image, str(path), extension, interpolation, add)

    def _once(
        self,
        image: bpy.types.Image,
        path: str,
        extension: str,
        interpolation: str,
        add: Callable[..., int | None],
    ) -> int | None:
        key = (image.name_full, path, extension, interpolation)
        if key not in self._textures:
            if extension not in _EXTENSIONS:
                self._warn(f"Image '{image.name}': extension {extension} is shown as REPEAT")
                extension = "REPEAT"
            self._textures[key] = add(
                image,
                extension=extension,
                interpolation=_INTERPOLATIONS.get(interpolation, interpolation),
                alpha=_ALPHA_MODES.get(image.alpha_mode, image.alpha_mode),
            )
        return self._textures[key]

    def _add_pixels(self, image: bpy.types.Image, **how: str) -> int | None:
        if image.source == "MOVIE":
            self._warn(f"Image '{image.name}': a movie is shown by one of its frames")
        width, height = image.size
        if not image.has_data and width * height == 0:
            self._warn(f"Image '{image.name}' is shown magenta: it has no pixels")
            return None
        pixels = np.empty((height, width, 4), np.float32)
        image.pixels.foreach_get(pixels.ravel())
        if image.is_float:  # Blender has made these linear already, whatever they were
            is_data = _known_colorspace(image) == "Non-Color"
            colorspace = "Non-Color" if is_data else "Linear"
        else:
            pixels = np.rint(pixels * 255.0).astype(np.uint8)
            colorspace = self._colorspace(image)
        return self._core_scene.add_texture_pixels(
            image.name_full, pixels, colorspace=colorspace, **how
        )

    def _colorspace(self, image: bpy.types.Image) -> str:
        known = _known_colorspace(image)
        if known is None:
            name = image.colorspace_settings.name
            self._warn(f"Image '{image.name}': colour space {name} is read as sRGB")
        return known or "sRGB"


def _known_colorspace(image: bpy.types.Image) -> str | None:
    """What the core calls the image's colour space, if it reads it itself."""
    name = image.colorspace_settings.name
    return "Linear" if name == working_space() else _COLORSPACES.get(name)
