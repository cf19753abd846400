import re
from pathlib import Path

import eye_render
import pytest


@pytest.fixture
def prescription(scene):
    return scene.camera.data.eye_render.right


def test_typed_text_sets_the_numbers(prescription):
    prescription.text = "-2.00DS -0.75DC 160A"
    assert prescription.sphere == -2.0
    assert prescription.cylinder == -0.75
    assert prescription.axis == 160.0
    assert prescription.text == "-2.00DS -0.75DC 160A"  # as typed, not as the core would write


def test_a_changed_number_rewrites_the_text(prescription):
    prescription.text = "-2.00 / -0.75 x 160"
    prescription.sphere = -3.0
    assert prescription.text == "-3.00DS -0.75DC 160A"
    assert prescription.as_core().sphere_d == -3.0
    assert prescription.cylinder == -0.75


def test_numbers_do_not_show_their_single_precision(prescription):
    prescription.sphere = -2.1
    assert prescription.text == "-2.10DS"


def test_text_that_is_no_prescription_is_explained_and_leaves_the_numbers(prescription):
    prescription.text = "-2.00DS -0.75DC 160A"
    prescription.text = "-2.00 -0.75"
    assert "axis" in prescription.problem()
    assert (prescription.sphere, prescription.cylinder) == (-2.0, -0.75)


def test_a_valid_text_has_no_problem(prescription):
    assert prescription.problem() == ""


def test_text_that_is_no_prescription_fails_the_render_with_the_parsers_sentence(
    prescription, render
):
    prescription.text = "-2.00 -0.75"
    with pytest.raises(RuntimeError, match="Prescription of the right eye: .*axis"):
        render()


def test_each_eye_keeps_its_own_prescription(scene):
    observer = scene.camera.data.eye_render
    observer.right.text = "-1.00"
    observer.left.text = "+2.00"
    assert (observer.right.sphere, observer.left.sphere) == (-1.0, 2.0)


def test_animated_numbers_lead(scene, prescription):
    for frame, sphere in ((1, -1.0), (2, -4.0)):
        prescription.sphere = sphere
        prescription.keyframe_insert("sphere", frame=frame)
    scene.frame_set(1)
    assert prescription.as_core().sphere_d == -1.0
    assert prescription.problem() == ""


def test_the_other_eyes_prescription_is_refused_in_each_box(scene, render):
    observer = scene.camera.data.eye_render
    observer.right.text = "OS -2.00"
    assert observer.right.problem() == (
        "OS means the left eye, but this is the prescription of the right eye"
    )
    assert observer.right.sphere == 0.0
    with pytest.raises(RuntimeError, match="Prescription of the right eye: OS means the left eye"):
        render()
    observer.left.text = "OD -2.00"
    assert "OD means the right eye" in observer.left.problem()


@pytest.mark.parametrize("text", ["OD -2.00", "OU -2.00", "-2.00"])
def test_the_eye_may_be_named_where_it_is_the_right_one(scene, text):
    right = scene.camera.data.eye_render.right
    right.text = text
    assert (right.problem(), right.sphere) == ("", -2.0)


def test_animated_numbers_that_leave_the_text_behind_are_said_to_rule(scene, prescription):
    prescription.text = "OD -2.00 -0.75 x 160"
    for frame, sphere in ((1, -2.0), (2, -4.0)):
        prescription.sphere = sphere
        prescription.keyframe_insert("sphere", frame=frame)
    scene.frame_set(2)
    assert prescription.disagreement() == ""  # the text was written from the last number set
    scene.frame_set(1)
    assert prescription.disagreement() == "The numbers rule, not the text: -2.00DS -0.75DC 160A"


def test_axis_0_typed_and_animated_axis_180_do_not_disagree(prescription):
    prescription.text = "-2.00 -0.75 x 0"
    prescription.axis = 0.0
    assert prescription.disagreement() == ""


def test_the_readmes_prescriptions_are_read():
    readme = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    (told,) = re.findall(r"^Prescriptions are read as people.*?\n\n", readme, re.M | re.S)
    texts = [" ".join(text.split()) for text in re.findall("`([^`]+)`", told)]
    assert len(texts) == 5
    for text in texts:
        eye_render.prescription.parse(text, "RIGHT")
