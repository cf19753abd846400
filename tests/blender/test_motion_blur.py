"""Motion blur as Blender's settings ask for it, in small renders of things that shine."""

import bpy
import numpy as np
import pytest
from scenes import add_object, emitter, quad_mesh

WIDTH_PX = 16
# The camera's default field is 36 mm wide at 50 mm, so 0.72 units at a distance of 1.
PX_PER_UNIT = WIDTH_PX / 0.72 / 10.0


@pytest.fixture
def shutter(scene):
    """An open shutter of one frame around frame 10, and a dark scene."""
    scene.render.use_motion_blur = True
    scene.render.motion_blur_shutter = 1.0
    scene.frame_set(10)
    scene.eye_render.samples = 256
    return scene


def shining(size: float = 0.5) -> bpy.types.Object:
    """A shining square at a distance of 10."""
    mesh = quad_mesh(size=size)
    mesh.materials.append(emitter((1.0, 1.0, 1.0)))
    shown = add_object(mesh)
    shown.location.z = -10.0
    return shown


def moved(owner, path: str, index: int, before: float, after: float) -> None:
    """Linear between frames 9 and 11."""
    for frame, value in ((9, before), (11, after)):
        values = getattr(owner, path)
        if index >= 0:
            values[index] = value
        else:
            setattr(owner, path, value)
        owner.keyframe_insert(path, index=index, frame=frame)
    action = owner.id_data.animation_data.action
    curves = (
        action.fcurves
        if hasattr(action, "fcurves")
        else action.layers[0].strips[0].channelbags[0].fcurves
    )
    for curve in curves:
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"
    bpy.context.scene.frame_set(10)


def middle_px(pixels: np.ndarray) -> float:
    """Where the light is in x, from the picture's middle."""
    columns = pixels[:, :, 0].sum(axis=0)
    return float(columns @ (np.arange(WIDTH_PX) + 0.5) / columns.sum()) - WIDTH_PX / 2


def spread_px(pixels: np.ndarray) -> float:
    """Standard deviation of the light in x."""
    columns = pixels[:, :, 0].sum(axis=0)
    places = np.arange(WIDTH_PX) + 0.5
    mean = columns @ places / columns.sum()
    return float(np.sqrt(columns @ (places - mean) ** 2 / columns.sum()))


def test_a_moving_object_is_spread_along_its_way(shutter, render):
    still = shining()
    unblurred = spread_px(render())
    moved(still, "location", 0, -2.0, 2.0)  # 2 units while the shutter is open
    pixels = render()
    expected = np.hypot(unblurred, 2.0 * PX_PER_UNIT / np.sqrt(12.0))
    assert spread_px(pixels) == pytest.approx(expected, rel=0.03)
    assert middle_px(pixels) == pytest.approx(0.0, abs=0.1)


@pytest.mark.parametrize("position, middle", [("START", 1.0), ("CENTER", 0.0), ("END", -1.0)])
def test_the_shutter_opens_where_the_frame_is_asked_to_lie(shutter, render, position, middle):
    owner = shutter.render if hasattr(shutter.render, "motion_blur_position") else shutter.cycles
    owner.motion_blur_position = position
    moved(shining(), "location", 0, -2.0, 2.0)
    assert middle_px(render()) == pytest.approx(middle * PX_PER_UNIT, abs=0.1)
    assert (shutter.frame_current, shutter.frame_subframe) == (10, 0.0)


def test_a_moving_camera_spreads_what_is_still(shutter, render):
    shining()
    unblurred = spread_px(render())
    moved(shutter.camera, "location", 0, -2.0, 2.0)
    expected = np.hypot(unblurred, 2.0 * PX_PER_UNIT / np.sqrt(12.0))
    assert spread_px(render()) == pytest.approx(expected, rel=0.03)


def test_a_camera_that_goes_along_keeps_the_picture_sharp(shutter, render):
    shown = shining()
    unblurred = render()
    moved(shown, "location", 0, -2.0, 2.0)
    moved(shutter.camera, "location", 0, -2.0, 2.0)
    np.testing.assert_allclose(spread_px(render()), spread_px(unblurred), rtol=0.02)


def test_a_shape_key_blurs(shutter, render):
    shown = shining()
    shown.shape_key_add(name="Basis")
    aside = shown.shape_key_add(name="Aside")
    for point in aside.data:
        point.co.x += 2.0
    unblurred = spread_px(render())
    moved(aside, "value", -1, 0.0, 1.0)  # a unit while the shutter is open
    expected = np.hypot(unblurred, PX_PER_UNIT / np.sqrt(12.0))
    assert spread_px(render()) == pytest.approx(expected, rel=0.03)


def test_what_says_so_is_not_blurred(shutter, render):
    shown = shining()
    if not hasattr(shown, "cycles"):
        pytest.skip("this Blender has no Cycles")
    unblurred = spread_px(render())
    moved(shown, "location", 0, -2.0, 2.0)
    shown.cycles.use_motion_blur = False
    assert spread_px(render()) == pytest.approx(unblurred, rel=1e-3)


def test_instances_move_with_what_places_them(shutter, render):
    inner = bpy.data.collections.new("Inner")
    shown = shining()
    shutter.collection.objects.unlink(shown)
    inner.objects.link(shown)
    placer = add_object(None)
    placer.instance_type, placer.instance_collection = "COLLECTION", inner
    unblurred = spread_px(render())
    moved(placer, "location", 0, -2.0, 2.0)
    expected = np.hypot(unblurred, 2.0 * PX_PER_UNIT / np.sqrt(12.0))
    assert spread_px(render()) == pytest.approx(expected, rel=0.03)


def test_a_mesh_with_other_vertices_at_other_times_is_shown_as_it_is(shutter, render):
    shown = shining()
    unblurred = render()
    array = shown.modifiers.new("Array", "ARRAY")
    array.count, array.use_relative_offset = 1, False
    array.use_constant_offset, array.constant_offset_displace = True, (0.0, 0.0, -0.01)
    wave = shown.modifiers.new("Wave", "WAVE")  # deforms, so that vertices are compared
    wave.height = 0.0
    moved(array, "count", -1, 1, 3)
    assert spread_px(render()) == pytest.approx(spread_px(unblurred), rel=0.02)


def test_the_shutter_s_curve_weighs_the_way(shutter, render):
    moved(shining(), "location", 0, -2.0, 2.0)
    curve = shutter.render.motion_blur_shutter_curve
    curve.initialize()
    for point, place in zip(curve.curves[0].points, ((0.0, 1.0), (1.0, 0.0)), strict=False):
        point.location = place
        point.handle_type = "VECTOR"
    curve.update()
    # The mean of the density 2 (1 - t) is a third: a sixth of two units before the middle.
    assert middle_px(render()) == pytest.approx(-PX_PER_UNIT / 3.0, abs=0.1)


def test_a_lamp_is_spread_along_its_way(shutter, render):
    light = bpy.data.lights.new("Lamp", "AREA")
    light.size = 0.5
    lamp = add_object(light, "Lamp")
    lamp.location.z = -10.0
    lamp.rotation_euler.x = np.pi
    lamp.visible_camera = True
    unblurred = spread_px(render())
    moved(lamp, "location", 0, -2.0, 2.0)
    expected = np.hypot(unblurred, 2.0 * PX_PER_UNIT / np.sqrt(12.0))
    assert spread_px(render()) == pytest.approx(expected, rel=0.03)


def test_a_rolling_shutter_is_said_to_be_left_out(shutter, render, capfd):
    shining()
    if not hasattr(shutter, "cycles"):
        pytest.skip("this Blender has no Cycles")
    shutter.cycles.rolling_shutter_type = "TOP"
    render()
    assert "A rolling shutter is not supported" in capfd.readouterr().out
