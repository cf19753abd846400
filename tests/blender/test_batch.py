import math
import re
from pathlib import Path

import pytest
from eye_render import batch, options


def test_values_are_read_with_either_way_of_writing_them():
    read = batch.parse(["--eye-rx", "-2.00DS -0.75DC 160A", "--eye-samples=64"])
    assert read.rx == "-2.00DS -0.75DC 160A"
    assert read.samples == 64


def test_all_options_are_read():
    options = (
        "--eye-rx -1 --eye-rx-left +1 --eye-side left --eye-pupil 3.5 --eye-focus 0.4 "
        "--eye-age 45 --eye-model pinhole --eye-quality draft --eye-samples 8 --eye-seed 7 "
        "--eye-sample-range 4:8 --eye-worn NONE"
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
    )


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
        ("--eye-focus", "0", "expected 0.01 to 1 000 000 000 000 metres, relaxed, center, inf or"),
        ("--eye-samples", "99999999", "expected 1 to 16 777 216"),
        ("--eye-samples", "1,5", "expected 1 to"),
        ("--eye-age", "-3", "expected 0 to 120 years"),
        ("--eye-model", "glass", "expected pinhole, paper, paraxial"),
        ("--eye-samples", "0", "expected 1 to"),
        ("--eye-samples", "1.5", "expected 1 to"),
        ("--eye-sample-range", "8:4", "expected A:B"),
        ("--eye-sample-range", "8", "expected A:B"),
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
