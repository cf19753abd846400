import math
import re
from pathlib import Path

import pytest
from eye_render import batch, options
from test_render import file_info


def test_values_are_read_with_either_way_of_writing_them():
    read = batch.parse(["--eye-rx", "-2.00DS -0.75DC 160A", "--eye-samples=64"])
    assert read.rx == "-2.00DS -0.75DC 160A"
    assert read.samples == 64


def test_all_options_are_read():
    options = (
        "--eye-rx -1 --eye-rx-left +1 --eye-side left --eye-pupil 3.5 --eye-focus 0.4 "
        "--eye-age 45 --eye-model pinhole --eye-quality draft --eye-samples 8 --eye-seed 7 "
        "--eye-sample-range 4:8 --eye-worn NONE --eye-worn-left -1 --eye-worn-part near "
        "--eye-correction contacts --eye-vertex 14 --eye-pupil-field 60 --eye-pupil-hold on "
        "--eye-refraction-zero minimum_rms_spot --eye-exact-trace OFF --eye-chromatic on "
        "--eye-stiles-crawford energy --eye-report eye.json --eye-report-distances inf,0.3,6"
    )
    assert batch.parse(options.split()) == batch.Overrides(
        rx="-1",
        rx_left="+1",
        side="LEFT",
        pupil=3.5,
        focus=0.4,
        age=45.0,
        model="PINHOLE",
        quality="DRAFT",
        samples=8,
        seed=7,
        sample_range=(4, 8),
        worn="none",
        worn_left="-1",
        worn_part="NEAR",
        correction="CONTACTS",
        vertex=14.0,
        pupil_field=60.0,
        pupil_hold=True,
        refraction_zero="MINIMUM_RMS_SPOT",
        exact_trace=False,
        chromatic=True,
        stiles_crawford="ENERGY",
        report=Path("eye.json"),
        report_distances=(0.3, 6.0, math.inf),
    )


def test_every_option_has_its_field():
    for option in options.OPTIONS:
        assert hasattr(batch.Overrides(), option.removeprefix("--eye-").replace("-", "_")), option


def test_words_stand_for_numbers_where_they_may():
    read = batch.parse(["--eye-pupil", "AUTO", "--eye-focus", "center"])
    assert (read.pupil, read.focus) == ("auto", "center")


def test_a_decimal_comma_is_a_point():
    read = batch.parse(["--eye-pupil", "3,5", "--eye-focus=0,4"])
    assert (read.pupil, read.focus) == (3.5, 0.4)


@pytest.mark.parametrize("word", ["inf", "Infinity"])
def test_far_away_has_a_word(word):
    assert batch.parse(["--eye-focus", word]).focus == math.inf


def test_options_of_others_are_passed_over():
    assert batch.parse(["--cycles-device", "CPU", "--keep-eye", "2"]) == batch.Overrides()


@pytest.mark.parametrize(
    ("option", "value", "allowed"),
    [
        ("--eye-rx", "-2.00 -0.75", "axis"),
        ("--eye-side", "both", "expected right, left"),
        ("--eye-pupil", "wide", "expected 0 to 9 mm or auto"),
        ("--eye-pupil", "nan", "expected 0 to 9 mm or auto"),
        ("--eye-pupil", "3,5,1", "expected 0 to 9 mm or auto"),
        ("--eye-worn", "spectacles", "cannot read 'spectacles' as a sphere"),
        ("--eye-wavefront", "/nowhere.csv", "/nowhere.csv cannot be read: No such file"),
        (
            "--eye-rx",
            "OS -2.00",
            "OS means the left eye, but this is the prescription of the right",
        ),
        (
            "--eye-rx-left",
            "OD -2.00",
            "OD means the right eye, but this is the prescription of the",
        ),
        ("--eye-focus", "0", "expected 0.01 to 1 000 000 000 000 metres, relaxed, camera"),
        ("--eye-samples", "99999999", "expected 1 to 16 777 216"),
        ("--eye-samples", "1,5", "expected 1 to"),
        ("--eye-age", "-3", "expected 0 to 120 years"),
        ("--eye-model", "glass", "expected pinhole, paper, paraxial"),
        ("--eye-samples", "0", "expected 1 to"),
        ("--eye-samples", "1.5", "expected 1 to"),
        ("--eye-sample-range", "8:4", "expected A:B"),
        ("--eye-sample-range", "8", "expected A:B"),
        ("--eye-correction", "monocle", "expected none, glasses, contacts"),
        ("--eye-vertex", "21", "expected 0 to 20 mm"),
        ("--eye-worn-part", "middle", "expected far, near"),
        ("--eye-chromatic", "yes", "expected on or off"),
        ("--eye-stiles-crawford", "on", "expected off, brightness, energy"),
        ("--eye-refraction-zero", "0", "expected paraxial, minimum_rms_spot"),
        ("--eye-pupil-field", "0", "expected 0.1 to 180 degrees or picture"),
        ("--eye-report-distances", "1;2", "expected 1 to 8 distances in metres"),
        ("--eye-report-distances", "0.001", "each 0.01 to 1 000 000 000 000 or inf"),
        ("--eye-report-distances", "1,2,3,4,5,6,7,8,9", "expected 1 to 8 distances"),
        ("--eye-report-distances", "nan", "expected 1 to 8 distances"),
    ],
)
def test_a_bad_value_is_answered_with_option_value_and_what_is_allowed(option, value, allowed):
    with pytest.raises(batch.OptionError) as caught:
        batch.parse([option, value])
    sentence = str(caught.value)
    assert sentence.startswith(f'{option} is "{value}"; ')
    assert allowed in sentence
    assert "\n" not in sentence


def test_an_unknown_eye_option_is_an_error():
    with pytest.raises(batch.OptionError, match="--eye-colour is unknown; expected one of"):
        batch.parse(["--eye-colour", "blue"])


@pytest.mark.parametrize("misspelled", ["--eyerx", "--eye_rx", "--eyerx=-2"])
def test_a_misspelled_option_is_an_error_that_names_the_one_meant(misspelled):
    with pytest.raises(batch.OptionError, match=r"is unknown \(did you mean --eye-rx\?\)"):
        batch.parse([misspelled])


@pytest.mark.parametrize("arguments", [["--eye-rx"], ["--eye-rx", "--eye-samples", "4"]])
def test_an_option_without_its_value_is_an_error(arguments):
    with pytest.raises(batch.OptionError, match="--eye-rx has no value; expected such as -2.00DS"):
        batch.parse(arguments)


def test_the_readme_has_the_table_of_help():
    readme = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(--eye-[a-z-]+)` \| (.*) \| (.*) \|$", readme, re.MULTILINE)
    assert [tuple(cell.strip() for cell in row) for row in rows] == options.help_rows()


def test_help_is_printed_and_ends_blender_with_status_0(run_blender, picture):
    ended = run_blender("--", "--eye-rx", "nonsense", "--eye-help")
    assert ended.returncode == 0, ended.stderr
    for row in options.help_rows():
        assert re.search(
            r"^ +" + r" +".join(map(re.escape, filter(None, row))), ended.stdout, re.M
        )
    assert not picture.exists()


def test_a_prescription_without_quotes_is_refused(run_blender, picture):
    ended = run_blender("--", "--eye-rx", "-2.00DS", "-0.75DC", "160A", "--eye-pupil", "4")
    assert ended.returncode == 2
    assert '"-0.75DC" follows a prescription; put all of it in quotes' in ended.stderr
    assert not picture.exists()


def test_a_bad_option_ends_blender_with_status_2_and_no_picture(run_blender, picture):
    ended = run_blender("--", "--eye-pupil", "wide")
    assert ended.returncode == 2
    assert '--eye-pupil is "wide"; expected' in ended.stderr
    assert not picture.exists()


def test_options_rule_the_run_and_are_not_saved(run_blender, picture, tmp_path):
    saved = tmp_path / "saved.blend"
    script = (
        'camera.eye_render.right.text = "+1.00"\n'
        "bpy.app.handlers.render_complete.append("
        f'lambda *_: bpy.ops.wm.save_as_mainfile(filepath="{saved}"))\n'
    )
    ended = run_blender("--", "--eye-rx", "-4.00DS", "--eye-samples", "2", script=script)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert picture.exists()
    assert "Sample 2/2" in ended.stdout
    show = (
        'c = scene.camera.data.eye_render; print("saved", c.right.text, scene.eye_render.quality)'
    )
    shown = run_blender(
        str(saved), "--python-expr", f"import bpy; scene = bpy.context.scene; {show}"
    )
    assert "saved +1.00 DRAFT" in shown.stdout


def test_rays_that_the_eye_loses_are_told(run_blender, picture):
    """An iris 8 mm wide cannot be seen whole from 66 degrees aside."""
    script = "camera.lens = 8.0\n"
    ended = run_blender("--", "--eye-model", "navarro", "--eye-pupil", "8", script=script)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert picture.exists()
    assert "of the rays are lost in the eye: " in ended.stdout


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (
            ("--eye-correction", "none", "--eye-worn", "-2.00DS"),
            '--eye-correction is "none", --eye-worn is "-2.00DS"; expected --eye-correction',
        ),
        (
            ("--eye-correction", "contacts", "--eye-worn", "none"),
            '--eye-correction is "contacts", --eye-worn is "none"; expected --eye-worn own or',
        ),
        (
            ("--eye-worn-part", "near"),
            '--eye-worn-part is "near", but no glasses are worn; expected --eye-correction',
        ),
        (
            ("--eye-worn-part", "near", "--eye-correction", "contacts"),
            '--eye-worn-part is "near", --eye-correction is "contacts", but no glasses are worn',
        ),
        (
            ("--eye-wavefront", "{wavefront}", "--eye-model", "navarro"),
            '--eye-wavefront is "{wavefront}", --eye-model is "navarro"; expected --eye-model',
        ),
        (
            ("--eye-exact-trace", "on"),
            '--eye-exact-trace is "on", but the eye\'s model is paraxial; expected --eye-model',
        ),
        (
            ("--eye-report", "{report}", "--eye-pupil", "0"),
            '--eye-report is "{report}", --eye-pupil is "0", but an eye without a pupil\'s width',
        ),
        # What the core refuses, once it knows the file, too.
        (
            ("--eye-wavefront", "{wavefront}", "--eye-pupil", "8"),
            '--eye-pupil is "8", --eye-wavefront is "{wavefront}"; pupil_mm is 8 mm; expected',
        ),
        (
            ("--eye-wavefront", "{wavefront}", "--eye-side", "left"),
            '--eye-side is "left", --eye-wavefront is "{wavefront}"; the file of --eye-wavefront',
        ),
        (("--eye-worn", "OS -2.00"), '--eye-worn is "OS -2.00"; OS means the left eye'),
        (
            ("--eye-rx", "+30 +15 x 90", "--eye-vertex", "20", "--eye-model", "paper"),
            '--eye-rx is "+30 +15 x 90", --eye-vertex is "20", --eye-model is "paper"; a lens of',
        ),
    ],
)
def test_options_that_do_not_go_together_end_blender_with_status_2_and_no_picture(
    run_blender, picture, tmp_path, arguments, sentence
):
    wavefront = tmp_path / "eye.csv"
    wavefront.write_text("pupil_mm,6\nwavelength_nm,555\neye,OD\nj,coefficient_um\n7,0.1\n")
    files = {"wavefront": str(wavefront), "report": str(tmp_path / "eye.json")}
    ended = run_blender("--", *(argument.format(**files) for argument in arguments))
    assert ended.returncode == 2, ended.stdout + ended.stderr
    assert f"Eye Render: {sentence.format(**files)}" in ended.stderr
    assert not picture.exists()


def test_what_the_light_does_in_the_eye_can_be_chosen(run_blender, picture):
    chosen = ("--eye-chromatic", "on", "--eye-stiles-crawford", "energy")
    eye = ("--eye-model", "navarro", "--eye-exact-trace", "on", "--eye-rx", "-20.00DS")
    ended = run_blender("--", *chosen, *eye, "--eye-pupil", "6")  # blur that pixels can show
    assert ended.returncode == 0, ended.stdout + ended.stderr
    info = file_info(str(picture))
    assert 'eye_render:chromatic: "yes"' in info
    assert 'eye_render:stiles_crawford: "energy"' in info.lower()
    assert 'eye_render:exact_trace: "yes"' in info


def test_a_prescription_for_the_eye_that_does_not_look_is_told(run_blender):
    ended = run_blender("--", "--eye-rx-left", "-2.00DS")
    assert "warning: --eye-rx-left is not for the right eye, which this" in ended.stdout


def test_a_folder_is_no_file_for_a_report(tmp_path):
    (tmp_path / "eye.json").mkdir()
    with pytest.raises(batch.OptionError, match="expected FILE.json"):
        batch.parse(["--eye-report", str(tmp_path / "eye.json")])
