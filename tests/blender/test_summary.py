"""The panel's line on blur, far and near point: as the scene stands, without a render."""

import math
import re

import bpy
import pytest
from eye_render import reporting, summary
from scenes import add_object


@pytest.fixture
def observer(scene):
    """A right eye of -2 D at the pupil's own plane, which needs no vertex distance."""
    observer = scene.camera.data.eye_render
    observer.right.text = "-2.00"
    observer.age = 60.0
    observer.focus_mode = "DISTANCE"
    scene.camera.data.dof.focus_distance = 0.5
    return observer


def line(scene) -> str:
    (only,) = summary.summaries(bpy.context, scene.camera)
    return only.line


def test_the_line_has_blur_points_and_pupil(scene, observer):
    # The glasses would stand 15.05 mm before the pupil: at rest the eye is focused for 1.942 D,
    # or 0.515 m, with all of its 0.5 D for 2.442 D, or 0.41 m. Focused for the 2 D of 0.5 m, a
    # pupil of 4 mm blurs what is far away by 4e-3 * 2 rad.
    assert line(scene).startswith("Blur 0.0′ at 0.50 m, 27.5′ at infinity; far point 0.52 m, ")
    assert line(scene).endswith("near point 0.41 m; pupil 4.0 mm")


def test_the_line_follows_what_is_changed(scene, observer):
    before = line(scene)
    observer.correction = "GLASSES"
    with_glasses = line(scene)
    assert "far point infinity" in with_glasses
    observer.pupil_mm = 2.0
    assert "pupil 2.0 mm" in line(scene)
    observer.pupil_mm = 4.0
    observer.correction = "NONE"
    assert line(scene) == before


def test_the_line_looks_at_the_focus_object(scene, observer):
    target = add_object(None)
    target.location.z = -1.25
    scene.camera.data.dof.focus_object = target
    bpy.context.view_layer.update()
    assert " at 1.25 m" in line(scene)


def test_what_only_a_render_finds_is_said(scene, observer, render):
    observer.focus_mode = "CENTER"
    assert line(scene) == "Blur: the first render finds what is at the image centre"
    observer.pupil_mode = "AUTO"
    assert line(scene).endswith("finds the pupil and what is at the image centre")
    render()
    assert "at infinity" in line(scene)
    assert line(scene).endswith(
        " mm, as found in frame 1; image centre as the last render found it"
    )
    observer.pupil_mode, observer.focus_mode = "MANUAL", "DISTANCE"
    assert line(scene).endswith(" mm")


def test_the_image_centre_is_not_what_another_render_was_focused_at(scene, observer, render):
    render()  # looks at 0.5 m
    observer.focus_mode = "CENTER"
    assert line(scene) == "Blur: the first render finds what is at the image centre"


@pytest.mark.parametrize("model", ["PARAXIAL", "WAVEFRONT", "NAVARRO", "ARIZONA"])
def test_the_line_of_a_few_rays_has_the_reports_blur(scene, observer, model):
    """To half of the last digit that it shows, and 1e-3 of the blur for its few rays."""
    observer.model = model
    observer.right.text = "-2.00DS -0.75DC 160A"
    observer.pupil_mm = 6.0
    shown = map(float, re.findall(r"([\d.]+)′", line(scene)))
    eye = reporting.subjects_in(bpy.context, warn=print)["RIGHT"].eye
    for blur, distance_m in zip(shown, (0.5, math.inf), strict=True):
        exact = eye.spot_ellipse(distance_m).major_arcmin
        assert blur == pytest.approx(exact, abs=0.05 + 1e-3 * exact)


@pytest.mark.parametrize("model", ["NAVARRO", "LE_GRAND"])
def test_a_schematic_eye_is_traced_for_its_line_and_not_fitted(
    scene, observer, model, monkeypatch
):
    """Which takes as long as all the rest, and once for every state of the eye."""
    asked = []
    make_observer = summary.make_observer
    monkeypatch.setattr(
        summary, "make_observer", lambda told: asked.append(told) or make_observer(told)
    )
    observer.model = model
    line(scene)
    assert [told["exact_trace"] for told in asked] == [True]


def test_in_stereo_there_is_a_line_for_each_eye(scene, observer):
    scene.render.use_multiview = True
    observer.left.text = "-4.00"
    right, left = summary.summaries(bpy.context, scene.camera)
    assert right.line.startswith("Right eye: blur 0.0′ at 0.50 m")
    assert left.line.startswith("Left eye: blur ")
    assert "far point 0.52 m" in right.line and "far point 0.27 m" in left.line


def test_accommodation_is_what_both_age_and_model_allow(scene, observer):
    (of_age,) = summary.summaries(bpy.context, scene.camera)
    assert of_age.accommodation == "Accommodation up to 0.5 D at this age"
    observer.age = 8.0
    observer.model = "ARIZONA"
    (of_model,) = summary.summaries(bpy.context, scene.camera)
    assert of_model.accommodation == "Accommodation up to 8.0 D in this eye model"


def test_what_is_wrong_is_said_in_the_line(scene, observer):
    observer.right.text = "-2.00 -0.75"
    assert line(scene).startswith("Prescription of the right eye: the cylinder -0.75 needs")


def test_the_near_point_is_as_far_as_the_formula_for_the_amplitude_allows(scene, observer):
    assert "near point 0.41 m" in line(scene)
    observer.amplitude_formula = "ANDERSON"  # nothing is left at 60 years
    assert "far point 0.52 m, near point 0.52 m" in line(scene)


def test_a_cameras_scale_does_not_count_for_its_distances(scene, observer):
    parent, target = add_object(None), add_object(None)
    parent.scale = (2.0, 2.0, 2.0)
    scene.camera.parent = parent
    target.location = (0.0, 0.0, -4.0)
    observer.focus_mode = "DISTANCE"
    scene.camera.data.dof.focus_object = target
    bpy.context.view_layer.update()
    told = line(scene)
    assert "at 4.00 m" in told
    subjects = reporting.subjects_in(bpy.context, print)
    assert subjects["RIGHT"].description["focus_m"] == pytest.approx(4.0)
