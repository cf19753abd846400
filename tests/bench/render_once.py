"""Renders the open file by one engine, set up so that two engines should agree. Inside Blender:

blender -b --factory-startup --addons eye_render FILE.blend --python render_once.py -- JSON

JSON: {"engine", "blur", "samples", "bounces", "size", "seed", "exr"}
"""

import json
import sys

import bpy

PUPIL_MM, FOCUS_M = 4.0, 0.5


def set_up_both(scene, bounces: int) -> None:
    """What both engines read: nothing is clamped or filtered."""
    cycles = scene.cycles
    cycles.diffuse_bounces = cycles.glossy_bounces = bounces
    cycles.transmission_bounces = cycles.transparent_max_bounces = bounces
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = 0.0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.pixel_filter_type, cycles.filter_width = "BLACKMAN_HARRIS", 1.5


def set_up_cycles(scene, samples: int, bounces: int, seed: int) -> None:
    """Plain path tracing: nothing denoised, adapted or left to a threshold."""
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.seed = "CPU", samples, seed
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces, cycles.light_sampling_threshold = bounces, 0.0


def set_up_eye_render(scene, samples: int, bounces: int, seed: int) -> None:
    scene.render.engine = "EYE_RENDER"
    settings = scene.eye_render
    settings.quality, settings.samples = "CUSTOM", samples
    settings.max_bounces, settings.seed = bounces, seed


def set_up_lens(camera, engine: str, blur: bool) -> None:
    """Either a pinhole, or an emmetrope's pupil focused at FOCUS_M and the thin lens like it."""
    lens = camera.dof
    lens.use_dof, lens.focus_distance = blur, FOCUS_M
    lens.aperture_fstop = camera.lens / PUPIL_MM
    if engine == "eye_render":
        observer = camera.eye_render
        observer.model = "PARAXIAL" if blur else "PINHOLE"
        observer.pupil_mode, observer.pupil_mm = "MANUAL", PUPIL_MM
        observer.focus_mode = "DISTANCE"


def main(job: dict) -> None:
    scene = bpy.context.scene
    set_up = {"cycles": set_up_cycles, "eye_render": set_up_eye_render}[job["engine"]]
    set_up_both(scene, job["bounces"])
    set_up(scene, job["samples"], job["bounces"], job["seed"])
    set_up_lens(scene.camera.data, job["engine"], job["blur"])
    scene.render.resolution_x = scene.render.resolution_y = job["size"]
    image = scene.render.image_settings
    image.file_format, image.color_mode, image.color_depth = "OPEN_EXR", "RGB", "32"
    scene.render.filepath = job["exr"]
    bpy.ops.render.render(write_still=True)


main(json.loads(sys.argv[sys.argv.index("--") + 1]))
