"""Images to textures of the core: files by their path, everything else by its pixels."""

from collections.abc import Callable
from pathlib import Path

import bpy
import numpy as np

# Blender's interpolations that the core does not have are close to linear.
_INTERPOLATIONS = {"Closest": "Closest"}
_EXTENSIONS = {"REPEAT", "EXTEND", "CLIP"}
_DATA_COLORSPACES = {"Non-Color", "Raw"}
MISSING_COLOR = (1.0, 0.0, 1.0)


class ImageTable:
    """The textures of one core scene, each (image, way of reading it) once."""

    def __init__(self, core_scene, warn: Callable[[str], None]):
        self._core_scene = core_scene
        self._warn = warn
        self._textures: dict[tuple, int | None] = {}

    def texture(
        self, image: bpy.types.Image, extension: str = "REPEAT", interpolation: str = "Linear"
    ) -> int | None:
        """The core's texture; None, after a warning, for what can only be shown as missing."""
        key = (image.name_full, extension, interpolation)
        if key not in self._textures:
            if extension not in _EXTENSIONS:
                self._warn(f"Image '{image.name}': extension {extension} is shown as REPEAT")
                extension = "REPEAT"
            self._textures[key] = self._add(
                image,
                extension=extension,
                interpolation=_INTERPOLATIONS.get(interpolation, "Linear"),
            )
        return self._textures[key]

    def _add(self, image: bpy.types.Image, **how: str) -> int | None:
        if image.source not in {"FILE", "GENERATED"}:
            kind = image.bl_rna.properties["source"].enum_items[image.source].name
            self._warn(f"Image '{image.name}' is shown magenta: {kind} is not supported")
            return None
        if image.source == "FILE" and not image.packed_files and not image.is_dirty:
            # Where Blender itself looks: it also reads the backslashes of files from Windows.
            path = Path(image.filepath_from_user()).resolve()
            return self._core_scene.add_texture(
                str(path), colorspace=self._colorspace(image), **how
            )
        return self._add_pixels(image, **how)

    def _add_pixels(self, image: bpy.types.Image, **how: str) -> int | None:
        width, height = image.size
        if not image.has_data and width * height == 0:
            self._warn(f"Image '{image.name}' is shown magenta: it has no pixels")
            return None
        pixels = np.empty((height, width, 4), np.float32)
        image.pixels.foreach_get(pixels.ravel())
        if image.is_float:  # Blender has made these linear already
            is_data = image.colorspace_settings.name in _DATA_COLORSPACES
            colorspace = "Non-Color" if is_data else "Linear"
        else:
            pixels = np.rint(pixels * 255.0).astype(np.uint8)
            colorspace = self._colorspace(image)
        return self._core_scene.add_texture_pixels(
            image.name_full, pixels, colorspace=colorspace, **how
        )

    def _colorspace(self, image: bpy.types.Image) -> str:
        name = image.colorspace_settings.name
        if name in _DATA_COLORSPACES:
            return "Non-Color"
        if name in {"Linear", "Linear Rec.709", "scene_linear"}:
            return "Linear"
        if name != "sRGB":
            self._warn(f"Image '{image.name}': colour space {name} is read as sRGB")
        return "sRGB"
