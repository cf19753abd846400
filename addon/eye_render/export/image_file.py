"""Where the files of an image are: one file, the frames of a sequence, or UDIM tiles."""

import re
from pathlib import Path

import bpy

_UDIM, _UV = "<UDIM>", "<UVTILE>"


def absolute(path: str, owner: bpy.types.ID) -> Path:
    """What a datablock's path means: it may be relative to a library's file, and of Windows."""
    return Path(bpy.path.abspath(path, library=owner.library).replace("\\", "/")).resolve()


def of_image(image: bpy.types.Image) -> Path:
    # Where Blender itself looks: it also reads the backslashes of files from Windows.
    return Path(image.filepath_from_user()).resolve()


def of_frame(image: bpy.types.Image, user: bpy.types.ImageUser, scene_frame: int) -> Path:
    """The file of a sequence that its user shows at a frame of the scene."""
    path = _path(image)
    number = str(frame_number(user, scene_frame))
    digits = re.search(r"\d+(?=\D*$)", path.stem)
    if digits is None:
        return path
    stem = path.stem[: digits.start()] + number.zfill(len(digits[0])) + path.stem[digits.end() :]
    return path.with_name(stem + path.suffix)


def frame_number(user: bpy.types.ImageUser, scene_frame: int) -> int:
    """The picture of a sequence, counted as its files are."""
    length = user.frame_duration
    if length == 0:
        return 0
    frame = scene_frame - user.frame_start + 1
    frame = (frame - 1) % length + 1 if user.use_cyclic else min(max(frame, 0), length)
    return frame + user.frame_offset


def has_tile_mark(image: bpy.types.Image) -> bool:
    return _UDIM in image.filepath or _UV in image.filepath


def of_tile(image: bpy.types.Image, number: int) -> Path:
    """The file of UDIM tile `number`, 1001 being the first of the first row of ten."""
    row, column = divmod(number - 1001, 10)
    path = str(_path(image)).replace(_UDIM, str(number))
    return Path(path.replace(_UV, f"u{column + 1}_v{row + 1}"))


def _path(image: bpy.types.Image) -> Path:
    return absolute(image.filepath, image)
