import json
import math

import bpy
import pytest
from eye_render import found, reporting
from scenes import add_object, quad_mesh


@pytest.fixture
def observer(scene):
    """A right eye of -2 D, refracted at the cornea, through 3 mm."""
    settings = scene.camera.data.eye_render
    settings.right.text = "-2.00DS"
    settings.vertex_mm = 0.0
    settings.pupil_mm = 3.0
    return settings


def report_of(path) -> dict:
    bpy.ops.eye_render.report(filepath=str(path))
    return json.loads(path.read_text(encoding="utf-8"))


def test_the_operator_reports_on_the_scenes_observer(observer, tmp_path):
    numbers = report_of(tmp_path / "eye.json")
    told = numbers["observer"]
    assert told["rx"].endswith("-2.00DS")
    assert (told["eye"], told["model"], told["focus"]) == ("right", "paraxial", "relaxed")
    assert told["pupil_source"] == "set"
    assert numbers["pupil_mm"] == pytest.approx(3.0)
    assert numbers["far_point_m"] == pytest.approx(0.5, abs=0.01)
    assert [row["distance_m"] for row in numbers["distances"]] == [0.4, 1.0, 6.0, None]
    # 3 mm x 2 D, less by the cornea's distance from the pupil.
    assert numbers["distances"][-1]["blur_major_arcmin"] == pytest.approx(20.5, abs=0.1)
    assert (tmp_path / "eye.png").read_bytes().startswith(b"\x89PNG")


def test_an_eye_that_focuses_is_reported_as_it_accommodates(scene, observer, tmp_path):
    observer.focus_mode = "DISTANCE"
    scene.camera.data.dof.focus_distance = 0.25
    numbers = report_of(tmp_path / "eye.json")
    assert numbers["observer"]["focus_m"] == 0.25
    assert numbers["accommodation_d"] == pytest.approx(2.0, abs=0.05)
    nearest = numbers["distances"][0]
    assert nearest["distance_m"] == 0.25
    assert nearest["is_diffraction_limited"]


def test_an_eye_that_looks_at_the_middle_accommodates_to_what_is_there(
    scene, observer, depsgraph_of, tmp_path
):
    scene.unit_settings.scale_length = 0.5
    observer.focus_mode = "CENTER"
    add_object(quad_mesh()).location = (0.0, 0.0, -0.5)
    depsgraph_of()
    assert report_of(tmp_path / "eye.json")["observer"]["focus_m"] == pytest.approx(0.25, rel=1e-5)


def test_an_automatic_pupil_is_the_last_renders_or_said_to_be_assumed(
    scene, observer, render, tmp_path
):
    observer.pupil_mode = "AUTO"
    numbers = report_of(tmp_path / "before.json")
    assert numbers["observer"]["pupil_source"].startswith("assumed")
    assert numbers["pupil_mm"] == pytest.approx(3.0)
    render()
    numbers = report_of(tmp_path / "after.json")
    assert numbers["observer"]["pupil_source"] == "found in frame 1"
    assert numbers["pupil_mm"] == pytest.approx(
        found.last_pupil(scene.camera.data).diameter_mm, rel=1e-5
    )


def test_a_pinhole_or_a_missing_folder_is_answered_with_a_sentence(observer, tmp_path):
    with pytest.raises(RuntimeError, match="The report cannot be written: .*nowhere"):
        bpy.ops.eye_render.report(filepath=str(tmp_path / "nowhere" / "eye.json"))
    observer.model = "PINHOLE"
    with pytest.raises(RuntimeError, match="There is no report: .*pupil_mm is 0"):
        bpy.ops.eye_render.report(filepath=str(tmp_path / "eye.json"))


def test_the_summary_is_of_the_scenes_observer(observer):
    from eye_render.report import summary_line

    line = summary_line(reporting.subject_in(bpy.context), math.inf)
    assert line.startswith("Blur 20.5′ at infinity; far point 0.50 m")


def test_a_batch_render_writes_the_report_of_its_picture(run_blender, picture, tmp_path):
    path = tmp_path / "eye.json"
    options = ("--eye-rx", "-3.00DS", "--eye-pupil", "auto", "--eye-report", str(path))
    ended = run_blender("--", *options)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert picture.exists()
    assert f"Eye Render: report: {path}" in ended.stdout
    told = json.loads(path.read_text(encoding="utf-8"))["observer"]
    assert told["rx"].endswith("-3.00DS")
    assert told["pupil_found_in"] == "frame 1"
    assert path.with_suffix(".png").exists()


def test_stereo_views_have_a_report_each(run_blender, tmp_path):
    script = """
scene.render.use_multiview = True
camera.eye_render.right.text = "-1.00DS"
camera.eye_render.left.text = "-5.00DS"
"""
    ended = run_blender("--", "--eye-report", str(tmp_path / "eye.json"), script=script)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    far = {
        view: json.loads((tmp_path / f"eye.{view}.json").read_text())["far_point_m"]
        for view in ("left", "right")
    }
    assert far["left"] < 0.25 < far["right"]


def test_a_report_that_cannot_be_written_ends_the_render_with_status_1(
    run_blender, picture, tmp_path
):
    ended = run_blender("--", "--eye-report", str(tmp_path / "nowhere" / "eye.json"))
    assert ended.returncode == 1
    assert "The report cannot be written" in ended.stdout + ended.stderr
    assert not picture.exists()


def test_a_report_needs_its_kind_of_file(run_blender):
    ended = run_blender("--", "--eye-report", "eye.txt")
    assert ended.returncode == 2
    assert '--eye-report is "eye.txt"; expected FILE.json' in ended.stderr
