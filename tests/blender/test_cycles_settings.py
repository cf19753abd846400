"""What a scene says for Cycles counts for Eye Render, too."""

import numpy as np
import pytest
from eye_render import cycles_settings
from scenes import add_object, node_material, quad_mesh, surface


@pytest.fixture
def shining_wall(scene):
    """A wall of radiance 2 that fills the picture."""
    material = node_material()
    emission = surface(material, "ShaderNodeEmission")
    emission.inputs["Color"].default_value = (1, 1, 1, 1)
    emission.inputs["Strength"].default_value = 2.0
    wall = add_object(quad_mesh(size=20))
    wall.location.z = -3
    wall.data.materials.append(material)
    return scene


def test_the_films_exposure_is_a_factor(shining_wall, render):
    shining_wall.cycles.film_exposure = 0.25
    assert np.allclose(render()[..., :3], 0.5)


def test_light_is_clamped_as_for_cycles(shining_wall, render):
    shining_wall.cycles.sample_clamp_direct = 1.0
    assert np.allclose(render()[..., :3], 1.0)


def test_glass_counts_for_a_transparent_film_only_if_it_shall(scene):
    assert cycles_settings.film(scene)["film_glass_roughness"] is None
    scene.cycles.film_transparent_glass = True
    scene.cycles.film_transparent_roughness = 0.5
    assert cycles_settings.film(scene)["film_glass_roughness"] == 0.5


def test_all_that_cycles_allows_is_allowed(scene):
    cycles = scene.cycles
    largest = {}
    for name in (
        *("diffuse_bounces", "glossy_bounces", "transmission_bounces", "volume_bounces"),
        *("transparent_max_bounces", "blur_glossy"),
        *("sample_clamp_direct", "sample_clamp_indirect"),
    ):
        largest[name] = cycles.bl_rna.properties[name].hard_max
        setattr(cycles, name, largest[name])
    cycles_settings.limits(scene)
    for name in largest:
        setattr(cycles, name, 0)
    cycles_settings.limits(scene)


WITHOUT_CYCLES = """
import addon_utils
addon_utils.disable("cycles")
assert not hasattr(scene, "cycles")
bpy.ops.object.light_add(type="AREA", location=(3, 0, 3))
bpy.ops.object.add(type="CURVES" if hasattr(bpy.data, "hair_curves") else "EMPTY")
bpy.ops.mesh.primitive_plane_add(location=(0, 0, -2))
bpy.ops.object.particle_system_add()
bpy.context.object.particle_systems[0].settings.type = "HAIR"
scene.render.use_motion_blur = True
for name in bpy.context.view_layer.bl_rna.properties.keys():
    if name.startswith("use_pass_"):
        setattr(bpy.context.view_layer, name, True)
bpy.context.view_layer.use_pass_uv = False
"""


def test_without_the_cycles_add_on_a_scene_is_rendered_all_the_same(run_blender, picture):
    ended = run_blender(script=WITHOUT_CYCLES)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert picture.exists()
