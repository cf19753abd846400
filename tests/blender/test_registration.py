import addon_utils
import bpy
import eye_render
from eye_render import choices, core

EXPECTED_PANELS = {
    "DATA_PT_lens",
    "EEVEE_MATERIAL_PT_context_material",
    "EEVEE_MATERIAL_PT_surface",
    "EEVEE_MATERIAL_PT_volume",
    "EEVEE_WORLD_PT_mist",
    "EEVEE_WORLD_PT_surface",
    "EEVEE_WORLD_PT_volume",
    "RENDER_PT_format",
    "RENDER_PT_output",
}
DEAD_PANELS = {"DATA_PT_camera_dof", "RENDER_PT_freestyle", "RENDER_PT_simplify", "DATA_PT_light"}


def opened_panels() -> set[str]:
    return {
        panel.__name__
        for panel in bpy.types.Panel.__subclasses__()
        if "EYE_RENDER" in getattr(panel, "COMPAT_ENGINES", ()) and "EYE_" not in panel.__name__
    }


def test_blenders_own_panels_are_open_to_the_engine():
    panels = opened_panels()
    assert panels >= EXPECTED_PANELS
    assert not panels & DEAD_PANELS


def test_there_is_a_panel_for_each_setting_that_blender_shows_by_engine():
    settings = {
        "motion_blur": "render",
        "curves": "render",
        "performance": "render",
        "simplify": "render",
        "filter": "view_layer",
        "ray_visibility": "object",
        "object_motion_blur": "object",
        "world_ray_visibility": "world",
        "occlusion": "world",
    }
    for name, tab in settings.items():
        assert getattr(bpy.types, f"EYE_RENDER_PT_{name}").bl_context == tab


def test_unregistering_leaves_nothing_behind_and_registering_brings_all_back():
    before = opened_panels()
    eye_render.unregister()
    try:
        assert opened_panels() == set()
        assert not hasattr(bpy.types.Scene, "eye_render")
        assert not hasattr(bpy.types.Camera, "eye_render")
        assert not hasattr(bpy.types, "EYE_RENDER_PT_sampling")
    finally:
        eye_render.register()
    assert opened_panels() == before
    assert hasattr(bpy.types, "EYE_RENDER_PT_sampling")


def test_the_add_on_is_enabled_under_its_name():
    assert addon_utils.check("eye_render")[1]


def test_every_choice_is_one_the_core_knows():
    assert [item[0].lower() for item in choices.EYE_MODELS] == list(core.module.EYE_MODELS)
    assert [item[0] for item in choices.PUPIL_FORMULAS] == list(core.module.PUPIL_FORMULAS)
    amplitudes = [item[0] for item in choices.AMPLITUDE_FORMULAS]
    assert amplitudes == list(core.module.AMPLITUDE_FORMULAS)
    zeros = [item[0].lower() for item in choices.REFRACTION_ZEROS]
    assert zeros == list(core.module.REFRACTION_ZEROS)
    modes = [item[0] for item in choices.STILES_CRAWFORD_MODES]
    assert modes == list(core.module.STILES_CRAWFORD_MODES)
    assert [item[0] for item in choices.PUPIL_PATTERNS] == list(core.module.PUPIL_PATTERNS)


def test_scripts_import_the_same_native_module():
    import eyecore

    assert eyecore is core.module
