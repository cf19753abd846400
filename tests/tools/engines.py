"""Sets a scene up so that Cycles and Eye Render should show the same. Inside Blender."""

import bpy

BOUNCES = 4
TRANSPARENT_BOUNCES = 8


def set_up_cycles(
    scene: bpy.types.Scene, samples: int, bounces: int = BOUNCES, seed: int = 0
) -> None:
    """Plain path tracing: nothing denoised, adapted or left to a threshold. Clamping, caustics and
    the pixel filter are the scene's own."""
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.seed = "CPU", samples, seed
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces, cycles.light_sampling_threshold = bounces, 0.0
    limit_paths(scene, bounces)


def set_up_eye_render(
    scene: bpy.types.Scene, samples: int, bounces: int = BOUNCES, seed: int = 0
) -> None:
    """An emmetrope who sees through a pinhole."""
    scene.render.engine = "EYE_RENDER"
    settings = scene.eye_render
    settings.quality, settings.samples = "CUSTOM", samples
    settings.max_bounces, settings.seed = bounces, seed
    limit_paths(scene, bounces)
    observer = scene.camera.data.eye_render
    observer.model, observer.pupil_mode = "PINHOLE", "MANUAL"
    observer.right.text = observer.left.text = "0.00DS"
    observer.correction, observer.focus_mode = "NONE", "RELAXED"


SET_UP = {"CYCLES": set_up_cycles, "EYE_RENDER": set_up_eye_render}


def limit_paths(scene: bpy.types.Scene, bounces: int) -> None:
    """What both engines read."""
    cycles = scene.cycles
    cycles.diffuse_bounces = cycles.glossy_bounces = bounces
    cycles.transmission_bounces = cycles.volume_bounces = bounces
    cycles.transparent_max_bounces = TRANSPARENT_BOUNCES
    cycles.blur_glossy = 0.0


def keep_all_light(scene: bpy.types.Scene) -> None:
    """Nothing is clamped, which cuts most where sampling is worst, and caustics count."""
    cycles = scene.cycles
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.caustics_reflective = cycles.caustics_refractive = True


def filter_as_usual(scene: bpy.types.Scene) -> None:
    """Blender's own default."""
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BLACKMAN_HARRIS", 1.5


def look_at_middles(scene: bpy.types.Scene) -> None:
    """Each pixel shows what lies behind its middle."""
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BLACKMAN_HARRIS", 0.01
