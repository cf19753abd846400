"""What each eye model costs and how exact it is, in one run. Inside Blender, on the demo hall:

blender -b --factory-startup --addons eye_render HALL.blend --python eye_models.py -- RESULT.json

Nanoseconds are of one thread and include copying a ray to and from NumPy, which is all that the
pinhole does. Errors are angles between a model's rays and those of its reference, over the pupil
and directions within 20 degrees of the axis.
"""

import json
import statistics
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path

import bpy
import eyecore
import numpy as np

RX = "-2.00DS -0.75DC 160A"
PUPIL_MM = 4.0
FIELD_DEG = 20.0
ROUNDS = 5
RAYS = 20_000
EXACT_RAYS = 4_000  # of a reference, which may trace every surface
SIZE_PX, SAMPLES, BOUNCES = 128, 32, 4

SCHEMATIC = ("navarro", "arizona", "le_grand")


@dataclass
class Row:
    model: str
    ray_ns: float
    render_s: float  # CPU time of the whole render
    share: float  # of it that goes into the model's rays
    reference: str
    median_arcmin: float
    maximum_arcmin: float


def make_eye(model: str, **more) -> eyecore.Eye:
    if model == "wavefront":
        more["wavefront"] = eyecore.Wavefront.population(6.0)
    return eyecore.Eye(model, rx=RX, rx_plane="entrance_pupil", pupil_mm=PUPIL_MM, **more)


def rays_to_ask(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Directions even over the field and points even over the pupil, (count, 2) each."""
    random = np.random.default_rng(1)

    def disk(radius: float) -> np.ndarray:
        r = radius * np.sqrt(random.random(count))
        angle = 2.0 * np.pi * random.random(count)
        return np.stack([r * np.cos(angle), r * np.sin(angle)], axis=1)

    return disk(np.tan(np.radians(FIELD_DEG))), disk(PUPIL_MM * 0.5e-3)


def reference_of(model: str) -> tuple[str, eyecore.Eye]:
    if model in SCHEMATIC:
        return "exact trace", make_eye(model, exact_trace=True)
    if model == "wavefront":
        return "itself", make_eye(model)
    return "paraxial", make_eye("paraxial")


def errors_arcmin(eye: eyecore.Eye, reference: eyecore.Eye) -> np.ndarray:
    slopes, points = rays_to_ask(EXACT_RAYS)

    def directions(of: eyecore.Eye) -> np.ndarray:
        _, slope, weight = of.rays(slopes, points)
        forward = np.concatenate([slope, np.ones((len(slope), 1))], axis=1)
        forward[weight == 0.0] = np.nan
        return forward / np.linalg.norm(forward, axis=1, keepdims=True)

    a, b = directions(eye), directions(reference)
    angle = np.linalg.norm(np.cross(a, b), axis=1)
    return np.degrees(np.arcsin(angle[np.isfinite(angle)])) * 60.0


def ray_ns(eye: eyecore.Eye) -> float:
    slopes, points = rays_to_ask(RAYS)
    start = time.thread_time_ns()
    eye.rays(slopes, points)
    return (time.thread_time_ns() - start) / RAYS


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
    observer.pupil_mode, observer.pupil_mm = "MANUAL", PUPIL_MM
    observer.right.text = RX


def measure() -> list[Row]:
    set_up()
    models = eyecore.EYE_MODELS
    eyes = {model: make_eye(model) for model in models}
    ns = {model: [] for model in models}
    seconds = {model: [] for model in models}
    for _ in range(ROUNDS):  # turn about, so that what else the machine does hits all
        for model in models:
            ns[model].append(ray_ns(eyes[model]))
            seconds[model].append(render_s(model))
    rows = []
    for model in models:
        name, reference = reference_of(model)
        errors = errors_arcmin(eyes[model], reference)
        of_ray, of_render = statistics.median(ns[model]), statistics.median(seconds[model])
        rows.append(
            Row(
                model=model,
                ray_ns=of_ray,
                render_s=of_render,
                share=of_ray * 1e-9 * SIZE_PX**2 * SAMPLES / of_render,
                reference=name,
                median_arcmin=float(np.median(errors)),
                maximum_arcmin=float(errors.max()),
            )
        )
    return rows


def main(result: Path) -> None:
    rows = measure()
    print(f"\n{RX}, {PUPIL_MM:g} mm, {FIELD_DEG:g} degrees; hall {SIZE_PX} x {SIZE_PX}, "
          f"{SAMPLES} samples, {BOUNCES} bounces; medians of {ROUNDS}")  # fmt: skip
    print("model        ns/ray   render s   share   error against   median'    largest'")
    for row in rows:
        print(
            f"{row.model:10} {row.ray_ns:8.0f} {row.render_s:10.2f} {100 * row.share:6.1f} %"
            f"   {row.reference:13} {row.median_arcmin:9.4f} {row.maximum_arcmin:10.4f}"
        )
    result.write_text(json.dumps([asdict(row) for row in rows], indent=1))


main(Path(sys.argv[sys.argv.index("--") + 1]))
