"""What renders found of the eye that looked: shown in panels, shared by stereo views, and held
through an animation. Known while Blender runs, and never saved."""

from dataclasses import dataclass, field
from typing import NamedTuple

import bpy
from bpy.app.handlers import persistent

from .session import RenderSession

# What a session tells of where its automatic pupil came from.
_ORIGIN = {
    "pupil_formula",
    "luminance_cd_m2",
    "cd_m2_per_unit",
    "luminance_sigma",
    "field_area_deg2",
    "eyes",
    "pupil_clamps",
}


class Pupil(NamedTuple):
    """An automatic pupil."""

    diameter_mm: float
    report: str  # one line: how wide, and what made it so
    where: str  # which picture found it, such as "frame 1"
    facts: dict[str, str | float]  # for the files of the pictures seen with it

    @property
    def clamps(self) -> str:
        """What was out of a formula's range; empty if nothing was."""
        return self.facts.get("pupil_clamps", "")


def pupil_by(session: RenderSession, where: str) -> Pupil:
    origin = {key: fact for key, fact in session.facts.items() if key in _ORIGIN}
    return Pupil(
        session.pupil_mm, session.pupil_report, where, {**origin, "pupil_found_in": where}
    )


@dataclass
class Look:
    """How the eye behind a camera looks at one frame, as the first of its pictures found it: all
    view layers and stereo views of the frame are seen by the same eye."""

    pupil: Pupil | None = None  # if it is automatic
    centre_m: float | None = None  # how far away the image centre is, if the eye looks there
    facts: dict[str, dict[str, str | float]] = field(default_factory=dict)  # by stereo view


# The latest frame of each camera, by its full name: (frame, what was found).
_looks: dict[str, tuple[float, Look]] = {}


def look_of_frame(camera: bpy.types.Object, frame: float) -> Look:
    """What the running render has found so far of the frame; the caller adds what it finds."""
    if _looks.get(camera.name_full, (None,))[0] != frame:
        _looks[camera.name_full] = (frame, Look())
    return _looks[camera.name_full][1]


# By the full name of the camera's data: its evaluated copies share it, and undo keeps it.
_last_pupil: dict[str, Pupil] = {}
_first_pupil_of_render: dict[str, Pupil] = {}
_last_centre_m: dict[str, float] = {}


def remember_pupil(camera: bpy.types.Camera, pupil: Pupil) -> None:
    _last_pupil[camera.name_full] = pupil
    _first_pupil_of_render.setdefault(camera.name_full, pupil)


def last_pupil(camera: bpy.types.Camera) -> Pupil | None:
    """What the last render through this camera found."""
    return _last_pupil.get(camera.name_full)


def first_pupil_of_render(camera: bpy.types.Camera) -> Pupil | None:
    """What the first picture of the running render found."""
    return _first_pupil_of_render.get(camera.name_full)


def remember_centre(camera: bpy.types.Camera, centre_m: float) -> None:
    _last_centre_m[camera.name_full] = centre_m


def last_centre_m(camera: bpy.types.Camera) -> float | None:
    """How far away the image centre was when an eye last looked at it."""
    return _last_centre_m.get(camera.name_full)


@persistent
def _render_begins(*_):
    _first_pupil_of_render.clear()
    _looks.clear()


@persistent
def _file_is_left(*_):
    for memory in (_first_pupil_of_render, _last_pupil, _last_centre_m, _looks):
        memory.clear()


def register():
    bpy.app.handlers.render_init.append(_render_begins)
    bpy.app.handlers.load_pre.append(_file_is_left)


def unregister():
    bpy.app.handlers.render_init.remove(_render_begins)
    bpy.app.handlers.load_pre.remove(_file_is_left)
