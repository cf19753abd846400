"""Glasses and contact lenses: what the core is told of them, and who overrides whom."""

import pytest
from eye_render.batch import Overrides
from eye_render.core import EyeRenderError
from eye_render.observer import eye_arguments
from test_render import file_info


@pytest.fixture
def observer(scene):
    observer = scene.camera.data.eye_render
    observer.right.text = "-4.00"
    observer.left.text = "-6.00"
    return observer


def told(observer, eye="RIGHT", **overrides) -> dict[str, object]:
    return eye_arguments(observer, Overrides(**overrides), eye)


def test_the_naked_eye_is_the_default(observer):
    assert not told(observer).keys() & {"correction", "worn", "near_part"}


def test_glasses_without_a_text_are_what_the_eye_needs(observer):
    observer.correction = "GLASSES"
    arguments = told(observer)
    assert (arguments["correction"], arguments["worn"]) == ("glasses", None)
    assert arguments["near_part"] is False


def test_each_eye_wears_its_own(observer):
    observer.correction = "CONTACTS"
    observer.right_worn.text = "-3.50"
    observer.left_worn.text = "-5.50"
    assert told(observer, "RIGHT")["worn"].sphere_d == -3.5
    assert told(observer, "LEFT")["worn"].sphere_d == -5.5


def test_a_text_that_is_taken_away_brings_back_what_the_eye_needs(observer):
    observer.correction = "GLASSES"
    observer.right_worn.text = "-3.50"
    observer.right_worn.text = ""
    assert observer.right_worn.problem() == observer.right_worn.disagreement() == ""
    assert told(observer)["worn"] is None


def test_only_glasses_have_a_near_part(observer):
    observer.worn_add = True
    observer.correction = "CONTACTS"
    assert told(observer)["near_part"] is False
    observer.correction = "GLASSES"
    assert told(observer)["near_part"] is True


def test_a_worn_text_that_is_no_prescription_is_refused_only_when_worn(observer):
    observer.right_worn.text = "OS -3.50"
    told(observer)
    observer.correction = "GLASSES"
    with pytest.raises(EyeRenderError, match="What the right eye wears: OS means the left eye"):
        told(observer)


@pytest.mark.parametrize(
    ("correction", "option", "expected"),
    [
        ("CONTACTS", "none", None),
        ("NONE", "-2.00", ("glasses", -2.0)),
        ("CONTACTS", "-2.00", ("contacts", -2.0)),
        ("NONE", "own", ("glasses", None)),
    ],
)
def test_the_command_line_rules_what_is_worn(observer, correction, option, expected):
    observer.correction = correction
    observer.right_worn.text = "-3.50"
    arguments = told(observer, worn=option)
    if expected is None:
        assert "correction" not in arguments
    else:
        worn = arguments.get("worn")
        assert (arguments["correction"], worn and worn.sphere_d) == expected


def test_each_eye_of_the_command_line_wears_its_own(observer):
    both = {"worn": "-3.00", "worn_left": "-5.00"}
    assert told(observer, "RIGHT", **both)["worn"].sphere_d == -3.0
    assert told(observer, "LEFT", **both)["worn"].sphere_d == -5.0
    assert told(observer, "LEFT", worn="-3.00")["worn"].sphere_d == -3.0
    one_lens = {"correction": "CONTACTS", "worn": "none", "worn_left": "own"}
    assert "correction" not in told(observer, "RIGHT", **one_lens)
    assert told(observer, "LEFT", **one_lens)["correction"] == "contacts"


def test_the_command_line_says_how_it_is_worn(observer):
    observer.correction = "CONTACTS"
    arguments = told(observer, correction="GLASSES", worn_part="NEAR", vertex=14.0)
    assert (arguments["correction"], arguments["near_part"]) == ("glasses", True)
    assert arguments["vertex_mm"] == 14.0
    observer.worn_add = True
    assert not told(observer, correction="GLASSES", worn_part="FAR")["near_part"]
    assert "correction" not in told(observer, correction="NONE")


def test_full_correction_is_in_the_files_metadata(scene, observer, render):
    observer.correction = "GLASSES"
    render()
    info = file_info(scene.render.filepath)
    assert 'eye_render:correction: "glasses"' in info
    assert 'eye_render:worn: "full correction"' in info


def test_prism_of_the_text_reaches_the_core_with_its_eye(observer):
    observer.correction = "GLASSES"
    observer.left_worn.text = "-5.50 3\u0394 BI 1\u0394 BD"
    worn = told(observer, "LEFT")["worn"]
    assert (worn.base_in_pd, worn.base_up_pd, worn.eye) == (3.0, -1.0, "OS")
    observer.left_worn.sphere = -5.0
    assert observer.left_worn.as_core().base_in_pd == 3.0
    assert "OS" not in observer.left_worn.text
