import json
import math

import bpy
import pytest
from eye_render import batch, found, reporting
from scenes import add_object, node_material, quad_mesh, surface


@pytest.fixture
def observer(scene):
    """A right eye of -2 D, refracted at the cornea, through 3 mm."""
    settings = scene.camera.data.eye_render
    settings.right.text = "-2.00DS"
    settings.vertex_mm = 0.0
    settings.pupil_mm = 3.0
    return settings


def report_of(path, **how) -> dict:
    bpy.ops.eye_render.report(filepath=str(path), **how)
    return json.loads(path.read_text(encoding="utf-8"))


def test_the_operator_reports_on_the_scenes_observer(observer, tmp_path):
    numbers = report_of(tmp_path / "eye.json")
    told = numbers["observer"]
    assert told["rx"].endswith("-2.00DS")
    assert (told["eye"], told["model"], told["focus"]) == ("right", "paraxial", "relaxed")
    assert numbers["pupil_mm"] == pytest.approx(3.0)
    assert numbers["far_point_m"] == pytest.approx(0.5, abs=0.01)
    assert [row["distance_m"] for row in numbers["distances"]] == [0.4, 1.0, 6.0, None]
    # 3 mm x 2 D, less by the cornea's distance from the pupil.
    assert numbers["distances"][-1]["blur_major_arcmin"] == pytest.approx(20.5, abs=0.1)
    assert (tmp_path / "eye.png").read_bytes().startswith(b"\x89PNG")


def test_a_report_says_of_which_eye_it_is_so_that_it_can_be_built_again(observer, tmp_path):
    observer.model = "NAVARRO"
    observer.refraction_zero = "MINIMUM_RMS_SPOT"
    told = report_of(tmp_path / "eye.json")["observer"]
    assert (told["refraction_zero"], told["exact_trace"]) == ("minimum_rms_spot", "no")
    assert 0.0 < told["fit_residual_arcmin"] < 0.1  # of the map, in place of tracing
    assert told["amplitude_formula"] == "HOFSTETTER_MEAN"
    observer.model = "WAVEFRONT"
    told = report_of(tmp_path / "eye.json")["observer"]
    assert told["wavefront"] == "population mean"
    assert "refraction_zero" not in told


def test_a_report_says_what_of_the_render_it_leaves_out(scene, observer, tmp_path):
    from eye_render.report.figure import _left_out

    add_object(quad_mesh(size=1.0)).location.z = -1.0  # nothing shows no colours
    for how in (report_of, as_rendered):
        scene.eye_render.stiles_crawford, scene.eye_render.chromatic = "OFF", False
        plain = how(tmp_path / "eye.json")
        assert not {"stiles_crawford", "chromatic"} & plain.keys()
        assert _left_out(plain) == []
        scene.eye_render.stiles_crawford, scene.eye_render.chromatic = "BRIGHTNESS", True
        told = how(tmp_path / "eye.json")
        assert told["stiles_crawford"] == told["chromatic"] == "not included"
        assert told["wavelength_nm"] == 555
        assert _left_out(told) == ["not included: Stiles-Crawford and chromatic (all at 555 nm)"]


def test_the_slide_says_which_zero_a_schematic_eye_was_refracted_to():
    from eye_render.report.figure import _model

    told = {"model": "navarro", "refraction_zero": "minimum_rms_spot"}
    assert _model(told) == "navarro model, 0 D: minimum rms spot"
    assert _model({"model": "paraxial"}) == "paraxial model"


def test_an_eye_that_focuses_is_reported_as_it_accommodates(scene, observer, tmp_path):
    observer.focus_mode = "DISTANCE"
    scene.camera.data.dof.focus_distance = 0.25
    numbers = report_of(tmp_path / "eye.json")
    assert numbers["observer"]["focus_m"] == 0.25
    assert numbers["accommodation_d"] == pytest.approx(2.0, abs=0.05)
    nearest = numbers["distances"][0]
    assert nearest["distance_m"] == 0.25
    assert nearest["is_diffraction_limited"]


def test_the_distances_of_a_report_can_be_chosen(observer, tmp_path):
    numbers = report_of(tmp_path / "eye.json", distances="6, 0.3, inf, 0.6")
    assert [row["distance_m"] for row in numbers["distances"]] == [0.3, 0.6, 6.0, None]
    curve = numbers["through_focus"]
    assert curve["object_vergence_d"][-1] > 1 / 0.3
    with pytest.raises(RuntimeError, match="Distances are '6 m'; expected 1 to 8 distances"):
        report_of(tmp_path / "eye.json", distances="6 m")


def as_rendered(path) -> dict:
    """The report that a render of the scene writes."""
    batch.overrides.report = path
    try:
        bpy.ops.render.render()
    finally:
        batch.overrides.report = None
    return json.loads(path.read_text(encoding="utf-8"))


def test_what_the_eye_looks_at_is_found_as_a_render_finds_it(
    scene, observer, depsgraph_of, tmp_path
):
    """A shifted lens looks past a sheet in front of the camera, through a clear one, to a wall."""
    scene.unit_settings.scale_length = 0.5
    observer.focus_mode = "CENTER"
    scene.camera.data.shift_x = 0.5  # the middle of the picture is 10 degrees to the right
    add_object(quad_mesh(size=0.1)).location = (0.0, 0.0, -0.2)
    clear = quad_mesh(size=2.0)
    clear.materials.append(node_material("Clear"))
    surface(clear.materials[0], "ShaderNodeBsdfTransparent")
    add_object(clear).location = (0.0, 0.0, -0.3)
    add_object(quad_mesh(size=2.0)).location = (0.0, 0.0, -0.5)
    depsgraph_of()
    reported = report_of(tmp_path / "reported.json")["observer"]["focus_m"]
    assert reported == as_rendered(tmp_path / "rendered.json")["observer"]["focus_m"]
    assert reported == pytest.approx(0.25, rel=1e-4)  # the ray sets out anew behind the sheet


def test_an_automatic_pupil_is_found_as_a_render_finds_it(scene, observer, tmp_path):
    observer.pupil_mode = "AUTO"
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes = True
    reported = report_of(tmp_path / "reported.json")
    told = reported["observer"]
    assert told["luminance_cd_m2"] > 1.0
    assert (told["cd_m2_per_unit"], told["luminance_sigma"], told["eyes"]) == (179.0, 0.5, "2")
    assert told["field_area_deg2"] > 1.0
    rendered = as_rendered(tmp_path / "rendered.json")
    assert (
        reported["pupil_mm"]
        == rendered["pupil_mm"]
        == pytest.approx(found.last_pupil(scene.camera.data).diameter_mm, rel=1e-6)
    )


def test_in_stereo_each_eye_has_its_report(scene, observer, tmp_path):
    scene.render.use_multiview = True
    observer.left.text = "-5.00DS"
    bpy.ops.eye_render.report(filepath=str(tmp_path / "eye.json"))
    far = {
        eye: json.loads((tmp_path / f"eye.{eye}.json").read_text())["far_point_m"]
        for eye in ("left", "right")
    }
    assert far["left"] < 0.25 < far["right"]


def test_a_pinhole_or_a_missing_folder_is_answered_with_a_sentence(observer, tmp_path):
    with pytest.raises(
        RuntimeError, match="The report .*/nowhere/eye.json cannot be written: No such file"
    ):
        bpy.ops.eye_render.report(filepath=str(tmp_path / "nowhere" / "eye.json"))
    observer.model = "PINHOLE"
    with pytest.raises(RuntimeError, match="There is no report: .*pupil_mm is 0"):
        bpy.ops.eye_render.report(filepath=str(tmp_path / "eye.json"))


def test_the_summary_is_of_the_scenes_observer(observer):
    from eye_render.report import summary_line

    line = summary_line(reporting.subjects_in(bpy.context, warn=print)["RIGHT"], math.inf)
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


def test_each_frame_of_an_animation_has_its_report(run_blender, tmp_path):
    script = """
scene.frame_start, scene.frame_end = 3, 4
scene.render.use_multiview = True
camera.eye_render.pupil_mode = "MANUAL"
for frame, pupil_mm in ((3, 2.0), (4, 6.0)):
    camera.eye_render.pupil_mm = pupil_mm
    camera.keyframe_insert("eye_render.pupil_mm", frame=frame)
"""
    # Blender's arguments are done in their order: both `-f 1` and the animation are rendered.
    ended = run_blender("-a", "--", "--eye-report", str(tmp_path / "eye.json"), script=script)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    pupils = {
        file.name: json.loads(file.read_text())["pupil_mm"] for file in tmp_path.glob("eye.*.json")
    }
    assert pupils == {
        f"eye.{frame}.{view}.json": pytest.approx(pupil_mm)
        for frame, pupil_mm in (("0001", 2.0), ("0003", 2.0), ("0004", 6.0))
        for view in ("left", "right")
    }


@pytest.mark.parametrize(
    ("blenders", "is_one"),
    [
        (["-f", "1"], True),
        (["--render-frame", "+12"], True),
        (["-f", "1", "--", "-a"], True),
        (["-f", "1..3"], False),
        (["-f", "1,3"], False),
        (["-f", "1", "-f", "2"], False),
        (["-f", "1", "-a"], False),
        (["-a"], False),
        (["-P", "render.py"], False),
    ],
)
def test_one_frame_is_told_from_several(blenders, is_one):
    assert batch.asks_for_one_frame(["blender", "-b", *blenders]) == is_one


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (("--eye-report", "eye.txt"), '--eye-report is "eye.txt"; expected FILE.json'),
        (
            ("--eye-report", "/nowhere/eye.json"),
            '--eye-report is "/nowhere/eye.json"; expected a file in a folder that exists',
        ),
        (("--eye-report-distances", "6"), "--eye-report-distances is given without --eye-report"),
        (
            ("--eye-report-distances", "6,near"),
            '--eye-report-distances is "6,near"; expected 1 to 8 distances in metres',
        ),
    ],
)
def test_a_report_that_cannot_be_ends_blender_with_status_2(
    run_blender, picture, options, sentence
):
    ended = run_blender("--", *options)
    assert ended.returncode == 2
    assert sentence in ended.stderr
    assert not picture.exists()


def test_a_report_in_batch_needs_a_picture_to_report_on(tmp_path):
    wanted = batch.Overrides(report=tmp_path / "eye.json")
    batch.check_report(wanted, ["blender", "-b", "scene.blend", "-f", "1"])
    batch.check_report(wanted, ["blender", "-b", "-P", "render.py"])
    with pytest.raises(batch.OptionError, match="nothing is rendered to report on; expected -f"):
        batch.check_report(wanted, ["blender", "-b", "scene.blend"])


def test_the_distances_of_a_batch_report_can_be_chosen(run_blender, tmp_path):
    path = tmp_path / "eye.json"
    ended = run_blender("--", "--eye-report", str(path), "--eye-report-distances", "inf,0.3")
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert [row["distance_m"] for row in json.loads(path.read_text())["distances"]] == [0.3, None]
