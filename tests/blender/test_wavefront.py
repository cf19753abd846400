"""Measured aberrations: files, the operator that reads them, and what the core is told."""

import json
import re
from pathlib import Path

import bpy
import pytest
from eye_render import wavefront
from eye_render.batch import Overrides
from eye_render.core import BadValueError, EyeRenderError
from eye_render.observer import eye_arguments
from test_render import file_info

CSV = """# from an aberrometer
pupil_mm,6.0
wavelength_nm, 780
j,coefficient_um
7,-0.12
12,0.2  # spherical aberration
"""
AS_JSON = {"pupil_mm": 6, "wavelength_nm": 780, "coefficients_um": {"7": -0.12, "12": 0.2}}


@pytest.fixture
def write(tmp_path):
    def to_file(text: str, name: str = "eye.csv") -> str:
        path = tmp_path / name
        path.write_text(text)
        return str(path)

    return to_file


def import_file(scene, path: str, eye: str = "RIGHT") -> None:
    bpy.ops.eye_render.import_wavefront(filepath=path, eye=eye, camera=scene.camera.data.name)


def test_csv_and_json_say_the_same(write):
    measured = wavefront.read(write(CSV))
    assert (measured.pupil_mm, measured.wavelength_nm, measured.side) == (6.0, 780.0, "")
    assert {j: c for j, c in enumerate(measured.coefficients_um) if c} == {7: -0.12, 12: 0.2}
    assert wavefront.read(write(json.dumps(AS_JSON), "eye.json")) == measured
    listed = {**AS_JSON, "coefficients_um": measured.coefficients_um}
    assert wavefront.read(write(json.dumps(listed), "eye.json")) == measured


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (CSV.replace("pupil_mm,6.0", ""), "eye.csv: pupil_mm is missing"),
        (CSV.replace("780", "red"), "wavelength_nm is 'red'; expected a number"),
        (CSV + "28,0.1\n", "j is 28; expected an OSA index from 0 to 27"),
        (CSV + "7,0.1\n", "j = 7 is there twice"),
        (CSV + "7;0.1\n", "line 7 is '7;0.1'; expected a name or index and a value"),
        (CSV + "8,0,1\n", "line 7 is '8,0,1'"),
        (CSV + "8,x\n", "the coefficient of j = 8 is 'x'; expected a number"),
        (CSV + "scheme,noll\n", "'scheme' is unknown; expected pupil_mm, wavelength_nm or eye"),
        (CSV + "eye,left\n", "eye is 'left'; expected OD or OS"),
        ("pupil_mm,6\nwavelength_nm,555\n", "there is no coefficient in it"),
        ("{", "eye.csv: Expecting property name"),
        ('{"pupil_mm": 6, "wavelength_nm": 555, "coefficients_um": 3}', "coefficients_um is 3"),
    ],
)
def test_what_is_wrong_with_a_file_is_said_with_its_name(write, text, sentence):
    with pytest.raises(ValueError, match="^eye.csv: ") as caught:
        wavefront.read(write(text))
    assert sentence in str(caught.value)


def test_the_readmes_files_are_read(write):
    readme = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    (csv,) = re.findall(r"^```\n(pupil_mm.*?)^```", readme, re.MULTILINE | re.DOTALL)
    measured = wavefront.read(write(csv))
    assert (measured.pupil_mm, measured.side) == (6.0, "OD")
    assert measured.coefficients_um[12] == 0.2
    (json,) = re.findall(r"^```json\n(.*?)^```", readme, re.MULTILINE | re.DOTALL)
    assert wavefront.read(write(json)) == measured


def test_a_file_that_is_no_text_is_refused(tmp_path):
    (tmp_path / "eye.csv").write_bytes(b"\xff\xfe\x80")
    with pytest.raises(ValueError, match="eye.csv cannot be read: it is no text"):
        wavefront.read(tmp_path / "eye.csv")


def test_an_imported_wavefront_is_what_the_core_is_told(scene, write):
    import_file(scene, write(CSV + "eye,OS\n"), "LEFT")
    observer = scene.camera.data.eye_render
    observer.model = "WAVEFRONT"
    told = eye_arguments(observer, Overrides(), "LEFT")["wavefront"]
    assert told.coefficients_um[12] == pytest.approx(0.2)
    assert (told.pupil_mm, told.wavelength_nm) == (6.0, 780.0)
    assert observer.left_wavefront.source == "eye.csv"
    with pytest.raises(EyeRenderError, match="No wavefront of the right eye has been imported"):
        eye_arguments(observer, Overrides(), "RIGHT")


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (CSV + "eye,OS\n", "the file is of the eye OS"),
        (CSV.replace("6.0", "60"), "pupil"),
        ("nothing", "line 1"),
    ],
)
def test_the_operator_refuses_what_the_core_would(scene, write, text, sentence):
    with pytest.raises(RuntimeError, match=sentence):
        import_file(scene, write(text))
    assert not scene.camera.data.eye_render.right_wavefront.is_there


def test_the_mean_eye_renders_and_is_the_default(scene, render):
    scene.camera.data.eye_render.model = "WAVEFRONT"
    render()
    assert 'eye_render:model: "wavefront"' in file_info(scene.render.filepath)


def test_a_wavefront_of_the_command_line_makes_the_eye_a_wavefront_eye(
    run_blender, picture, write
):
    ended = run_blender("--", "--eye-wavefront", write(CSV), "--eye-pupil", "4")
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert 'eye_render:model: "wavefront"' in file_info(str(picture))


def test_a_wavefront_of_the_other_eye_is_refused(scene, write):
    observer = scene.camera.data.eye_render
    of_left = wavefront.read(write(CSV + "eye,OS\n"))
    with pytest.raises(EyeRenderError, match="the wavefront is of the eye OS"):
        eye_arguments(observer, Overrides(wavefront=of_left), "RIGHT")
    assert eye_arguments(observer, Overrides(wavefront=of_left), "LEFT")["model"] == "wavefront"


@pytest.mark.parametrize(
    ("options", "eye", "sentence"),
    [
        (
            {"wavefront": ""},
            "LEFT",
            "the file of --eye-wavefront names no eye and so is of the right one, but this "
            "picture is seen with the left eye; expected --eye-wavefront-left FILE, or a line "
            "eye,OS in the file if it is of that eye",
        ),
        (
            {"wavefront": "eye,OD\n"},
            "LEFT",
            "the file of --eye-wavefront is of the eye OD, but this picture is seen with the left "
            "eye; expected --eye-wavefront-left FILE",
        ),
        (
            {"wavefront_left": ""},
            "RIGHT",
            "--eye-wavefront-left is of the left eye, but this picture is seen with the right eye",
        ),
        ({"wavefront": "", "wavefront_left": "eye,OD\n"}, "LEFT", "is of the eye OD"),
    ],
)
def test_no_wavefront_is_taken_for_that_of_the_other_eye(scene, write, options, eye, sentence):
    given = Overrides(**{name: wavefront.read(write(CSV + end)) for name, end in options.items()})
    observer = scene.camera.data.eye_render
    for model in ("PARAXIAL", "WAVEFRONT"):  # which of itself has the mean of healthy eyes
        observer.model = model
        with pytest.raises(BadValueError, match=re.escape(sentence)):
            eye_arguments(observer, given, eye)


def test_an_imported_wavefront_stands_beside_one_of_the_command_line(scene, write):
    import_file(scene, write(CSV.replace("0.2", "0.3")), "LEFT")
    observer = scene.camera.data.eye_render
    right = Overrides(wavefront=wavefront.read(write(CSV)))
    told = {
        eye: eye_arguments(observer, right, eye)["wavefront"].coefficients_um[12]
        for eye in ("RIGHT", "LEFT")
    }
    assert told == {"RIGHT": pytest.approx(0.2), "LEFT": pytest.approx(0.3)}


def test_in_stereo_one_wavefront_file_ends_blender_with_status_2(run_blender, picture, write):
    path = write(CSV)
    stereo = "scene.render.use_multiview = True\n"
    ended = run_blender("--", "--eye-wavefront", path, script=stereo)
    assert ended.returncode == 2
    assert f'--eye-wavefront is "{path}"; the file of --eye-wavefront names no eye' in ended.stderr
    assert "expected --eye-wavefront-left FILE" in ended.stderr


def test_each_eye_has_its_wavefront_of_the_command_line(scene, write):
    observer = scene.camera.data.eye_render
    both = Overrides(
        wavefront=wavefront.read(write(CSV + "eye,OD\n")),
        wavefront_left=wavefront.read(write(CSV.replace("0.2", "0.3") + "eye,OS\n")),
    )
    told = {
        eye: eye_arguments(observer, both, eye)["wavefront"].coefficients_um[12]
        for eye in ("RIGHT", "LEFT")
    }
    assert told == {"RIGHT": pytest.approx(0.2), "LEFT": pytest.approx(0.3)}
