"""What a scene says for Cycles and what counts for Eye Render, too: the film, and what is left out
of the paths of light. A scene looks the same by either engine, and there is one place to set it.

Where the Cycles add-on is switched off a scene says nothing: then nothing is left out.
"""

import bpy

from . import core


def of(owner: bpy.types.bpy_struct) -> bpy.types.PropertyGroup | None:
    """What a scene, a view layer or a datablock says for Cycles."""
    return getattr(owner, "cycles", None)


def curves(scene: bpy.types.Scene) -> bpy.types.PropertyGroup | None:
    return getattr(scene, "cycles_curves", None)


RAYS_OF_WORLD = ("camera", "diffuse", "glossy", "transmission", "scatter")


def visibility(world: bpy.types.World) -> bpy.types.PropertyGroup | None:
    """Which of the `RAYS_OF_WORLD` see the world."""
    return getattr(world, "cycles_visibility", None)


def sees_world(world: bpy.types.World, rays: str) -> bool:
    return getattr(visibility(world), rays, True)


def is_portal(light: bpy.types.Light) -> bool:
    """Whether the area lamp only says where the light of the world comes in."""
    return light.type == "AREA" and getattr(of(light), "is_portal", False)


def film(scene: bpy.types.Scene) -> dict[str, object]:
    """Keywords of `eyecore.Settings`."""
    cycles = of(scene)
    if cycles is None:
        return {}
    shows_glass = cycles.film_transparent_glass
    return {
        "exposure": cycles.film_exposure,
        "pixel_filter": cycles.pixel_filter_type,
        "filter_width_px": cycles.filter_width,
        "film_glass_roughness": cycles.film_transparent_roughness if shows_glass else None,
    }


def limits(scene: bpy.types.Scene):
    """`eyecore.LightPathLimits`."""
    cycles = of(scene)
    with core.speaking() as eyecore:
        if cycles is None:
            return eyecore.LightPathLimits()
        return eyecore.LightPathLimits(
            diffuse_bounces=cycles.diffuse_bounces,
            glossy_bounces=cycles.glossy_bounces,
            transmission_bounces=cycles.transmission_bounces,
            volume_bounces=cycles.volume_bounces,
            transparent_bounces=cycles.transparent_max_bounces,
            reflective_caustics=cycles.caustics_reflective,
            refractive_caustics=cycles.caustics_refractive,
            filter_glossy=cycles.blur_glossy,
            clamp_direct=cycles.sample_clamp_direct,
            clamp_indirect=cycles.sample_clamp_indirect,
        )
