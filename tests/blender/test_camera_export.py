import math

import bpy
import numpy as np
import pytest
from eye_render.core import EyeRenderError
from eye_render.export.camera import check_camera, focus_distance_m, frame_of, set_camera
from scenes import RecordingScene, add_object


class EngineWithoutStereo:
    """What a render engine says of the camera while it renders."""

    def camera_model_matrix(self, camera):
        return camera.matrix_world

    def camera_shift_x(self, camera):
        return camera.data.shift_x + self.stereo_shift

    stereo_shift = 0.0


@pytest.fixture
def export(scene, depsgraph_of):
    def run(engine: EngineWithoutStereo | None = None):
        depsgraph = depsgraph_of()
        recording = RecordingScene()
        camera = scene.camera.evaluated_get(depsgraph)
        frame = frame_of(scene.render)
        set_camera(recording, engine or EngineWithoutStereo(), depsgraph, camera, frame)
        return recording.camera

    return run


def slopes_seen(depsgraph: bpy.types.Depsgraph, camera: bpy.types.Object):
    """The window that Blender draws around what the camera sees, as slopes."""
    corners = np.array(camera.data.view_frame(scene=depsgraph.scene_eval))
    slopes = corners[:, :2] / -corners[:, 2:]
    return (*np.sort(slopes[:, 0])[[0, -1]], *np.sort(slopes[:, 1])[[0, -1]])


@pytest.mark.parametrize("fit", ["AUTO", "HORIZONTAL", "VERTICAL"])
@pytest.mark.parametrize("shift", [(0.0, 0.0), (0.25, -0.125)])
@pytest.mark.parametrize("size", [(16, 8), (8, 16)])
@pytest.mark.parametrize("pixel_aspect", [1.0, 2.0])
def test_slopes_are_those_of_blenders_camera_frame(
    scene, export, depsgraph_of, fit, shift, size, pixel_aspect
):
    camera = scene.camera.data
    camera.sensor_fit = fit
    camera.shift_x, camera.shift_y = shift
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.pixel_aspect_x = pixel_aspect
    expected = slopes_seen(depsgraph_of(), scene.camera)
    assert export().slope_bounds == pytest.approx(expected, abs=1e-5)


def test_a_stereo_shift_moves_the_window_as_the_cameras_own_would(scene, export):
    scene.camera.data.shift_x = 0.25
    expected = export().slope_bounds
    scene.camera.data.shift_x = 0.0
    engine = EngineWithoutStereo()
    engine.stereo_shift = 0.25
    assert export(engine).slope_bounds == pytest.approx(expected)


def test_resolution_percentage_and_border(scene, export):
    scene.render.resolution_percentage = 50
    scene.render.use_border = True
    scene.render.border_min_x, scene.render.border_max_x = 0.25, 0.75
    scene.render.border_min_y, scene.render.border_max_y = 0.5, 1.0
    camera = export()
    assert camera.resolution == (8, 4)
    assert camera.border == (2, 2, 6, 4)


class BorderProbe(bpy.types.RenderEngine):
    """Renders nothing; notes how wide Blender wants the picture, and how wide the border is."""

    bl_idname = "BORDER_PROBE"
    bl_label = "Border Probe"
    widths: list[tuple[int, int]] = []

    def render(self, depsgraph):
        frame = frame_of(depsgraph.scene_eval.render)
        result = self.begin_result(0, 0, frame.width, frame.height)
        self.widths.append((result.resolution_x, frame.border[2] - frame.border[0]))
        self.end_result(result)


@pytest.fixture
def border_probe():
    bpy.utils.register_class(BorderProbe)
    yield BorderProbe
    bpy.utils.unregister_class(BorderProbe)
    BorderProbe.widths.clear()


@pytest.mark.parametrize("width", [1920, 1080, 1000])
def test_a_border_at_any_pixel_is_as_wide_as_blender_has_it(scene, border_probe, width):
    scene.render.engine = border_probe.bl_idname
    scene.render.use_border = True
    scene.render.use_compositing = scene.render.use_sequencer = False
    scene.render.resolution_x, scene.render.resolution_y = width, 4
    for pixel in range(width - 1):
        scene.render.border_min_x = pixel / width
        bpy.ops.render.render()
    wanted, given = zip(*border_probe.widths, strict=True)
    assert len(wanted) == width - 1
    assert wanted == given


def test_unit_scale_counts_unless_there_are_no_units(scene, export):
    scene.unit_settings.scale_length = 0.01
    assert export().metres_per_unit == pytest.approx(0.01)
    scene.unit_settings.system = "NONE"
    assert export().metres_per_unit == 1.0


def test_the_focus_distance_is_in_metres(scene, depsgraph_of):
    scene.unit_settings.scale_length = 0.5
    scene.camera.data.dof.focus_distance = 3.0
    distance = focus_distance_m(depsgraph_of(), scene.camera, np.eye(4))
    assert distance == pytest.approx(1.5)


def test_a_focus_object_counts_by_its_depth(scene, depsgraph_of):
    target = add_object(None)
    target.location = (3.0, 0.0, -4.0)
    scene.camera.data.dof.focus_object = target
    assert focus_distance_m(depsgraph_of(), scene.camera, np.eye(4)) == pytest.approx(4.0)


@pytest.mark.parametrize("kind", ["ORTHO", "PANO"])
def test_cameras_that_are_no_eye_are_refused(scene, kind):
    scene.camera.data.type = kind
    with pytest.raises(EyeRenderError, match="an eye needs a perspective camera"):
        check_camera(scene.camera)


def test_a_field_of_view_of_90_degrees_has_slopes_of_one(scene, export):
    scene.camera.data.angle = math.radians(90)
    assert export().slope_bounds == pytest.approx((-1.0, 1.0, -0.5, 0.5), abs=1e-5)
