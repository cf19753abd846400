"""What each eye model costs and how exact it is, in one run. Inside Blender, on the demo hall:

blender -b --factory-startup --addons eye_render HALL.blend --python eye_models.py -- RESULT.json

What is measured of a ray, eye_rays.py says. The share is of a render at one wavelength.
"""

import json
import statistics
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))

import eye_rays
import eyecore
from eye_rays import WAVELENGTHS_NM

ROUNDS = 5
RAYS = 20_000
EXACT_RAYS = 4_000  # of a reference, which may trace every surface
SIZE_PX, SAMPLES, BOUNCES = 128, 32, 4
RENDERED_NM = 555.0


@dataclass
class Row:
    model: str
    ray_ns: dict[float, float]  # by wavelength
    render_s: float  # CPU time of the whole render
    share: float  # of it that goes into the model's rays
    errors: dict[float, eye_rays.RayError]


def render_s(model: str) -> float:
    bpy.context.scene.camera.data.eye_render.model = model.upper()
    start = time.process_time()
    bpy.ops.render.render()
    return time.process_time() - start


def set_up() -> None:
    scene = bpy.context.scene
    scene.render.engine = "EYE_RENDER"
    scene.render.resolution_x = scene.render.resolution_y = SIZE_PX
    settings = scene.eye_render
    settings.quality, settings.samples, settings.max_bounces = "CUSTOM", SAMPLES, BOUNCES
    observer = scene.camera.data.eye_render
    observer.pupil_mode, observer.pupil_mm = "MANUAL", eye_rays.PUPIL_MM
    observer.right.text = eye_rays.RX


def measure() -> list[Row]:
    set_up()
    models = eyecore.EYE_MODELS
    eyes = {model: eye_rays.make_eye(model) for model in models}
    ns = {(model, nm): [] for model in models for nm in WAVELENGTHS_NM}
    seconds = {model: [] for model in models}
    for _ in range(ROUNDS):  # turn about, so that what else the machine does hits all
        for model in models:
            for nm in WAVELENGTHS_NM:
                ns[model, nm].append(eye_rays.ray_ns(eyes[model], nm, RAYS))
            seconds[model].append(render_s(model))
    copy_ns = statistics.median(ns[eye_rays.COPY, RENDERED_NM])
    rows = []
    for model in models:
        of_ray = {nm: statistics.median(ns[model, nm]) - copy_ns for nm in WAVELENGTHS_NM}
        of_render = statistics.median(seconds[model])
        rows.append(
            Row(
                model=model,
                ray_ns=of_ray,
                render_s=of_render,
                share=of_ray[RENDERED_NM] * 1e-9 * SIZE_PX**2 * SAMPLES / of_render,
                errors={nm: eye_rays.ray_error(model, nm, EXACT_RAYS) for nm in WAVELENGTHS_NM},
            )
        )
    return rows


def table(rows: list[Row]) -> str:
    lines = [
        f"{eye_rays.RX}, {eye_rays.PUPIL_MM:g} mm, {eye_rays.FIELD_DEG:g} degrees; "
        f"hall {SIZE_PX} x {SIZE_PX}, {SAMPLES} samples, {BOUNCES} bounces; medians of {ROUNDS}",
        "model        ns/ray above the copy at   render s   share   "
        "median' and largest' error at",
        "             " + "".join(f"{nm:5.0f} nm" for nm in WAVELENGTHS_NM) + " " * 24
        + "".join(f"{nm:12.0f} nm      " for nm in WAVELENGTHS_NM),
    ]  # fmt: skip
    for row in rows:
        ns = "".join(f"{row.ray_ns[nm]:8.0f}" for nm in WAVELENGTHS_NM)
        errors = "".join(
            f"{error.median_arcmin:10.5f} {error.largest_arcmin:9.5f} "
            for error in row.errors.values()
        )
        lines.append(f"{row.model:12}{ns} {row.render_s:9.2f} {100 * row.share:6.1f} %   {errors}")
    return "\n".join(lines)


def main(result: Path) -> None:
    rows = measure()
    print("\n" + table(rows))
    result.write_text(json.dumps([asdict(row) for row in rows], indent=1))


main(Path(sys.argv[sys.argv.index("--") + 1]))
