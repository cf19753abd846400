"""One run of the core: its observer and settings from Blender's properties, then its session."""

import math
from typing import NamedTuple

import bpy
import numpy as np

from . import choices, core, prescription
from .batch import Overrides
from .core import EyeRenderError


class Progress(NamedTuple):
    samples_done: int
    samples: int
    fraction: float  # 0 to 1


def make_observer(
    settings: bpy.types.PropertyGroup,
    scene_settings: bpy.types.PropertyGroup,
    overrides: Overrides,
    eye: str,
    focus_m: float,
    known_pupil_mm: float | None,
):
    """The core's observer with the given eye ("RIGHT" or "LEFT").

    `focus_m` is what the eye looks at if its focus mode is DISTANCE, `known_pupil_mm` what an
    automatic pupil was found to be before.
    """
    pupil = _pupil(settings, overrides)
    if pupil == "auto" and known_pupil_mm is not None:
        pupil = known_pupil_mm
    field_area_deg2 = None
    if settings.pupil_field == "FIXED":
        field_area_deg2 = math.pi / 4 * settings.pupil_field_deg**2
    focus = overrides.focus
    if focus is None:
        focus = {"RELAXED": "relaxed", "CENTER": "center", "DISTANCE": focus_m}[
            settings.focus_mode
        ]
    with core.speaking() as eyecore:
        return eyecore.Observer(
            model=(overrides.model or settings.model).lower(),
            rx=_prescription(settings, overrides, eye),
            vertex_mm=settings.vertex_mm,
            age_years=settings.age if overrides.age is None else overrides.age,
            pupil=pupil,
            pupil_formula=settings.pupil_formula,
            cd_m2_per_unit=scene_settings.cd_m2_per_unit,
            luminance_sigma=scene_settings.luminance_sigma,
            field_area_deg2=field_area_deg2,
            eyes=settings.pupil_eyes,
            focus=focus,
        )


def _pupil(settings: bpy.types.PropertyGroup, overrides: Overrides) -> str | float:
    if overrides.pupil is not None:
        return overrides.pupil
    return "auto" if settings.pupil_mode == "AUTO" else settings.pupil_mm


def has_automatic_pupil(settings: bpy.types.PropertyGroup, overrides: Overrides) -> bool:
    """Whether the light of the scene decides how wide the pupil is."""
    model = overrides.model or settings.model
    return model != "PINHOLE" and _pupil(settings, overrides) == "auto"


def _prescription(settings: bpy.types.PropertyGroup, overrides: Overrides, eye: str):
    text = overrides.rx_left if eye == "LEFT" else overrides.rx
    if text is not None:
        return prescription.parse(text, eye)
    own = settings.left if eye == "LEFT" else settings.right
    problem = own.problem()
    if problem:
        raise EyeRenderError(f"Prescription of the {eye.lower()} eye: {problem}")
    return own.as_core()


def make_settings(scene: bpy.types.Scene, overrides: Overrides, pass_names: list[str]):
    """The core's settings."""
    settings = scene.eye_render
    quality = overrides.quality or settings.quality
    samples = overrides.samples or choices.QUALITY_SAMPLES.get(quality, settings.samples)
    narrowest, widest = choices.FILTER_RANGE_PX
    with core.speaking() as eyecore:
        return eyecore.Settings(
            samples=samples,
            max_bounces=settings.max_bounces,
            seed=settings.seed if overrides.seed is None else overrides.seed,
            sample_range=overrides.sample_range,
            pattern=settings.pupil_pattern,
            passes=pass_names,
            threads=scene.render.threads if scene.render.threads_mode == "FIXED" else 0,
            film_transparent=scene.render.film_transparent,
            filter_width_px=min(max(scene.render.filter_size, narrowest), widest),
        )


class RenderSession:
    """A started render; always `close` it, best by `with`."""

    def __init__(self, core_scene, observer, settings):
        with core.speaking() as eyecore:
            self._core = eyecore.Session(core_scene, observer, settings)
        self._core.start()

    def __enter__(self) -> "RenderSession":
        return self

    def __exit__(self, *_exception) -> None:
        self._core.cancel()

    @property
    def plan_text(self) -> str:
        return self._core.plan_text

    @property
    def pupil_mm(self) -> float:
        return self._core.pupil_mm

    @property
    def pupil_report(self) -> str:
        return self._core.pupil_report

    @property
    def warnings(self) -> list[str]:
        return self._core.warnings

    @property
    def metadata(self) -> dict[str, str]:
        return self._core.metadata

    def wait(self, timeout_s: float) -> bool:
        """True when the render has finished; EyeRenderError if it failed."""
        is_finished = self._core.wait(timeout_s)
        if self._core.error:
            raise EyeRenderError(self._core.error)
        return is_finished

    def progress(self) -> Progress:
        return Progress(self._core.samples_done, self._core.samples_total, self._core.progress)

    def snapshot(self) -> dict[str, np.ndarray]:
        """The picture so far: (height, width, channels) for each pass, rows bottom-up."""
        return self._core.snapshot()
