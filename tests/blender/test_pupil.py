"""The automatic pupil: what it answers to, what is told of it, and who shares it."""

import json
import math
import re

import bpy
import pytest
from eye_render import final, found
from eye_render.batch import Overrides
from eye_render.observer import holds_pupil, observer_arguments
from scenes import add_camera
from test_render import file_info, wall

PUPIL_LINE = re.compile(r"Eye Render: pupil: ([\d.]+) mm(.*)")


@pytest.fixture
def automatic(scene):
    """A camera with an automatic pupil in a white world."""
    scene.camera.data.eye_render.pupil_mode = "AUTO"
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    return scene


def pupil_of(scene) -> found.Pupil:
    return found.last_pupil(scene.camera.data)


def pupil_in(info: str, view: str = "") -> float:
    """The diameter in millimetres that a file's metadata tell of."""
    return float(re.search(rf'eye_render:pupil_mm{view}: "(.*)"', info).group(1))


def test_a_wider_lens_narrows_the_pupil_unless_the_field_is_fixed(automatic, render):
    def diameter(lens_mm: float) -> float:
        automatic.camera.data.lens = lens_mm
        render()
        return pupil_of(automatic).diameter_mm

    assert diameter(18.0) < diameter(85.0) - 0.5
    automatic.camera.data.eye_render.pupil_field = "FIXED"
    assert diameter(18.0) == diameter(85.0)


def test_a_fixed_field_is_a_disc_of_the_diameter_given(automatic, render):
    observer = automatic.camera.data.eye_render
    observer.pupil_field = "FIXED"
    observer.pupil_field_deg = 10.0
    render()
    assert pupil_of(automatic).facts["field_area_deg2"] == pytest.approx(math.pi * 5.0**2)


def test_a_covered_eye_widens_the_pupil(automatic, render):
    render()
    both = pupil_of(automatic).diameter_mm
    automatic.camera.data.eye_render.pupil_eyes = 1
    render()
    assert pupil_of(automatic).diameter_mm > both + 0.3


def test_the_pupil_is_told_on_the_console_and_in_the_file(automatic, render, capfd):
    automatic.camera.data.eye_render.age = 10.0
    render()
    printed = capfd.readouterr().out
    report = PUPIL_LINE.search(printed).group(0)
    assert report.endswith(pupil_of(automatic).report)
    assert "WATSON_YELLOTT, 179 cd/m2 over" in report
    assert "Eye Render: warning: pupil: age 10 years taken as 20 years" in printed
    assert pupil_of(automatic).clamps == "age 10 years taken as 20 years"
    info = file_info(automatic.render.filepath)
    assert 'eye_render:pupil_clamps: "age 10 years taken as 20 years"' in info
    assert 'eye_render:luminance_cd_m2: "179"' in info
    assert 'eye_render:pupil_found_in: "frame 1"' in info


def test_what_a_render_found_is_forgotten_with_the_file_and_never_saved(automatic, render):
    render()
    name = automatic.camera.data.name
    assert pupil_of(automatic) is not None
    bpy.ops.wm.read_homefile(use_factory_startup=True)
    assert found.last_pupil(bpy.data.cameras[name]) is None


BRIGHTENING = """
camera.eye_render.pupil_mode = "AUTO"
strength = scene.world.node_tree.nodes["Background"].inputs["Strength"]
for frame, value in ((1, 0.01), (3, 100.0)):
    strength.default_value = value
    strength.keyframe_insert("default_value", frame=frame)
scene.frame_start, scene.frame_end = 1, 3
"""


def pupils_of(ended) -> list[tuple[str, str]]:
    assert ended.returncode == 0, ended.stdout + ended.stderr
    return PUPIL_LINE.findall(ended.stdout)


def test_the_pupil_follows_an_animations_light(run_blender):
    diameters = [float(mm) for mm, _ in pupils_of(run_blender("-a", script=BRIGHTENING))[1:]]
    assert diameters[0] > diameters[1] > diameters[2]


def test_a_held_pupil_stays_as_the_first_frame_of_the_render_found_it(run_blender, tmp_path):
    script = BRIGHTENING + "camera.eye_render.pupil_hold = True\nscene.frame_start = 2\n"
    still, *frames = pupils_of(run_blender("-a", script=script))
    assert float(frames[0][0]) < float(still[0]), "a new render finds its own first pupil"
    assert frames[1][1].endswith(", as in frame 2")
    info = file_info(str(tmp_path / "out_0003.exr"))
    assert pupil_in(info) == pupil_in(file_info(str(tmp_path / "out_0002.exr")))
    assert 'eye_render:pupil_found_in: "frame 2"' in info
    assert "eye_render:luminance_cd_m2" in info


def test_stereo_views_share_the_pupil_of_the_first(automatic, tmp_path, capfd):
    automatic.render.use_multiview = True
    automatic.render.image_settings.file_format = "OPEN_EXR"
    automatic.render.image_settings.views_format = "INDIVIDUAL"
    automatic.render.filepath = str(tmp_path / "stereo.exr")
    automatic.camera.data.stereo.interocular_distance = 1.0
    wall(
        (100.0, 100.0, 100.0), x=-1.0, size=1.0
    )  # more in the left view's middle than the right's
    bpy.ops.render.render(write_still=True)
    _, second = PUPIL_LINE.findall(capfd.readouterr().out)
    assert second[1].endswith(", as in frame 1, view left")
    info = file_info(str(tmp_path / "stereo_R.exr"))
    assert pupil_in(info, ".left") == pupil_in(info, ".right")


TWO_LAYERS = """
camera.eye_render.pupil_mode, camera.eye_render.focus_mode = "AUTO", "CENTER"
near = bpy.data.collections.new("Near")
scene.collection.children.link(near)
bpy.ops.mesh.primitive_plane_add(size=20, align="WORLD", rotation=camera_object.rotation_euler)
wall = bpy.context.object
wall.matrix_world = camera_object.matrix_world @ Matrix.Translation((0, 0, -0.5))
for holder in wall.users_collection:
    holder.objects.unlink(wall)
near.objects.link(wall)
scene.view_layers.new("Far").layer_collection.children["Near"].exclude = True
scene.view_layers["Far"].use_sky = False
"""


def test_view_layers_are_seen_with_the_pupil_and_the_focus_of_the_first(run_blender, tmp_path):
    script = "from mathutils import Matrix\ncamera_object = scene.camera\n" + TWO_LAYERS
    path = tmp_path / "eye.json"
    ended = run_blender("--", "--eye-report", str(path), script=script)
    first, second = pupils_of(ended)
    assert second[0] == first[0]
    assert second[1].endswith(", as in frame 1")
    info = file_info(str(tmp_path / "out_0001.exr"))
    assert pupil_in(info) == float(first[0])
    assert 'eye_render:focus: "center"' in info
    focus_m = re.search('eye_render:focus_m: "(.*)"', info).group(1)
    assert float(focus_m) == pytest.approx(0.5, abs=1e-3)
    report = json.loads(path.read_text())["observer"]
    assert report["focus_m"] == pytest.approx(0.5, abs=1e-3)
    assert ended.stdout.count("Eye Render: report: ") == 1


def test_progress_runs_once_through_all_views_and_layers(automatic, monkeypatch):
    automatic.render.use_multiview = True
    automatic.view_layers.new("Second")
    shares = []
    show = final._show_until_finished

    def note(*arguments):
        shares.append(arguments[-1])
        show(*arguments)

    monkeypatch.setattr(final, "_show_until_finished", note)
    bpy.ops.render.render()
    assert [share.progress(0.0) for share in shares] == [0.0, 0.25, 0.5, 0.75]
    assert shares[-1].progress(1.0) == 1.0


def test_both_eyes_look_at_what_the_first_found_at_the_centre(automatic, monkeypatch):
    automatic.render.use_multiview = True
    automatic.camera.data.eye_render.focus_mode = "CENTER"
    automatic.camera.data.stereo.interocular_distance = 1.0
    wall((1.0, 1.0, 1.0), size=1.0)  # in the left view's middle
    told = []
    make = final.make_observer
    monkeypatch.setattr(final, "make_observer", lambda said: told.append(said) or make(said))
    bpy.ops.render.render()
    assert [said["focus"] for said in told] == ["center", pytest.approx(2.0, abs=0.01)]


def test_views_of_named_cameras_are_each_seen_with_its_cameras_eye(automatic, tmp_path):
    automatic.render.use_multiview = True
    automatic.render.views_format = "MULTIVIEW"
    automatic.render.image_settings.file_format = "OPEN_EXR"
    automatic.render.image_settings.views_format = "INDIVIDUAL"
    automatic.render.filepath = str(tmp_path / "views.exr")
    automatic.camera.name = "Observer_L"
    other = add_camera()
    other.name = "Observer_R"
    automatic.camera.data.eye_render.eye, other.data.eye_render.eye = "RIGHT", "LEFT"
    other.data.eye_render.pupil_mm = 7.0
    bpy.ops.render.render(write_still=True)
    info = file_info(str(tmp_path / "views_L.exr"))
    assert 'eye_render:eye.left: "right"' in info
    assert 'eye_render:eye.right: "left"' in info
    assert pupil_in(info, ".right") == 7.0 != pupil_in(info, ".left")


def test_a_manual_pupil_is_no_ones_else(automatic):
    settings = automatic.camera.data.eye_render
    settings.pupil_mode = "MANUAL"
    told = observer_arguments(settings, automatic.eye_render, Overrides(), "RIGHT", 1.0, 7.0)
    assert told["pupil"] == 4.0


def test_the_command_line_says_what_the_pupil_answers_to(automatic):
    settings = automatic.camera.data.eye_render

    def told(**said) -> dict[str, object]:
        overrides = Overrides(**said)
        return observer_arguments(settings, automatic.eye_render, overrides, "RIGHT", 1.0, None)

    assert told()["field_area_deg2"] is None
    assert told(pupil_field=20.0)["field_area_deg2"] == pytest.approx(math.pi * 10.0**2)
    settings.pupil_field = "FIXED"
    assert told(pupil_field="picture")["field_area_deg2"] is None
    assert told(focus="camera")["focus"] == 1.0
    assert holds_pupil(settings, Overrides(pupil_hold=True))
    assert not holds_pupil(settings, Overrides(pupil_hold=True, pupil=4.0))
