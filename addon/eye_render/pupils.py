"""What renders found of the pupil: shown in the panel, shared by stereo views, and held through an
animation. Known while Blender runs, and never saved."""

from typing import NamedTuple

import bpy
from bpy.app.handlers import persistent

from .session import RenderSession

# What a picture's metadata says of where its pupil came from.
_ORIGIN = {
    "pupil_formula",
    "luminance_cd_m2",
    "cd_m2_per_unit",
    "luminance_sigma",
    "field_area_deg2",
    "eyes",
    "pupil_clamps",
}


class FoundPupil(NamedTuple):
    diameter_mm: float
    report: str  # one line: how wide, and what made it so
    where: str  # which picture found it, such as "frame 1"
    metadata: dict[str, str]

    @property
    def clamps(self) -> str:
        """What was out of a formula's range; empty if nothing was."""
        return self.metadata.get("pupil_clamps", "")


def found_by(session: RenderSession, where: str) -> FoundPupil:
    metadata = {key: text for key, text in session.metadata.items() if key in _ORIGIN}
    if metadata:  # an automatic pupil
        metadata["pupil_found_in"] = where
    return FoundPupil(session.pupil_mm, session.pupil_report, where, metadata)


# By the full name of the camera's data: its evaluated copies share it, and undo keeps it.
_last: dict[str, FoundPupil] = {}
_first_of_render: dict[str, FoundPupil] = {}


def remember(camera: bpy.types.Camera, found: FoundPupil) -> None:
    _last[camera.name_full] = found
    _first_of_render.setdefault(camera.name_full, found)


def last(camera: bpy.types.Camera) -> FoundPupil | None:
    """What the last render through this camera found."""
    return _last.get(camera.name_full)


def first_of_render(camera: bpy.types.Camera) -> FoundPupil | None:
    """What the first picture of the running render found."""
    return _first_of_render.get(camera.name_full)


@persistent
def _render_begins(*_):
    _first_of_render.clear()


@persistent
def _file_is_left(*_):
    _first_of_render.clear()
    _last.clear()


def register():
    bpy.app.handlers.render_init.append(_render_begins)
    bpy.app.handlers.load_pre.append(_file_is_left)


def unregister():
    bpy.app.handlers.render_init.remove(_render_begins)
    bpy.app.handlers.load_pre.remove(_file_is_left)
