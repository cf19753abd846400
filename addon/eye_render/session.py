"""One run of the core: its settings from Blender's properties, then its session."""

from typing import NamedTuple

import bpy
import numpy as np

from . import choices, core, cycles_settings, passes
from .batch import Overrides, ruled
from .core import EyeRenderError
from .export.motion import Shutter


class Progress(NamedTuple):
    samples_done: int
    samples: int
    fraction: float  # 0 to 1


def make_settings(
    scene: bpy.types.Scene,
    view_layer: bpy.types.ViewLayer,
    overrides: Overrides,
    shutter: Shutter | None = None,
):
    """The core's settings; `shutter` of a picture in which things move."""
    settings = scene.eye_render
    quality = ruled(overrides.quality, settings.quality)
    of_quality = choices.QUALITY_SAMPLES.get(quality, settings.samples)
    with core.speaking() as eyecore:
        return eyecore.Settings(
            samples=ruled(overrides.samples, of_quality),
            max_bounces=settings.max_bounces,
            seed=ruled(overrides.seed, settings.seed),
            sample_range=overrides.sample_range,
            pattern=settings.pupil_pattern,
            threads=scene.render.threads if scene.render.threads_mode == "FIXED" else 0,
            film_transparent=scene.render.film_transparent,
            limits=cycles_settings.limits(scene),
            **cycles_settings.film(scene),
            **effects(settings, overrides),
            **passes.settings(scene, view_layer),
            **(shutter.settings() if shutter else {}),
        )


def effects(settings: bpy.types.PropertyGroup, overrides: Overrides) -> dict[str, object]:
    """The settings of what an eye does beside blurring."""
    return {
        "chromatic": ruled(overrides.chromatic, settings.chromatic),
        "stiles_crawford": ruled(overrides.stiles_crawford, settings.stiles_crawford),
    }


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
    def facts(self) -> dict[str, str | float]:
        return self._core.facts

    @property
    def lost_rays(self) -> str:
        """Which rays the eye did not let through, in words; empty if it lost none."""
        fates = self._core.ray_fates
        lost = {fate: count for fate, count in fates.items() if count and fate != "transmitted"}
        if not lost:
            return ""
        share = 100.0 * sum(lost.values()) / sum(fates.values())
        reasons = ", ".join(f"{fate.replace('_', ' ')} {count}" for fate, count in lost.items())
        return f"{share:.2g} % of the rays are lost in the eye: {reasons}"

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
