"""Small renders at the ends of what an eye and a scene can be: every pixel is a finite number, and
bright where the scene is."""

import itertools

import eyecore
import numpy as np
import pytest
from materials import add_light

QUAD = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float64)
TRIANGLES = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)

HALF_SLOPE = 0.2
# The radius of the widest pupil, and the slope by which 42 D bend a ray there.
PUPIL_RADIUS_M = 4.5e-3
BLUR_SLOPE = 0.2

DISTANCES_M = (0.01, 1.0, 1e7)
UNITS_M = (1e-3, 1.0, 1e3)
PRESCRIPTIONS = ("-30.00DS", "+30.00DS", "-30.00DS -12.00DC 30A", "+18.00DS +12.00DC 150A")


def wall(distance_m, metres_per_unit=1.0, at_units=0.0, left_m=None, radiance=1.0):
    """A wall across the view, that shines evenly, seen by a camera at (`at_units`, ...). With
    `left_m` it ends there instead of going on beyond the left of the picture."""
    scene = eyecore.Scene()
    paint = add_light(scene, "wall", radiance)
    half_m = 2.0 * (PUPIL_RADIUS_M + distance_m * (HALF_SLOPE + BLUR_SLOPE))
    corners = QUAD * half_m
    if left_m is not None:
        corners[[0, 3], 0] = left_m
    mesh = scene.add_mesh("wall", (corners / metres_per_unit).astype(np.float32), TRIANGLES)
    world_from_wall = np.eye(4)
    world_from_wall[:3, 3] = at_units
    world_from_wall[2, 3] -= distance_m / metres_per_unit
    scene.add_instances(mesh, world_from_wall[None], [paint])
    world_from_camera = np.eye(4)
    world_from_camera[:3, 3] = at_units
    scene.set_camera(
        world_from_camera,
        (-HALF_SLOPE, HALF_SLOPE, -HALF_SLOPE, HALF_SLOPE),
        (8, 8),
        clip=(0.005 / metres_per_unit, 1e8 / metres_per_unit),
        metres_per_unit=metres_per_unit,
    )
    return scene


def picture(scene, observer, samples=4):
    names = [name for name, _, _ in eyecore.PASSES]
    return eyecore.render(scene, observer, eyecore.Settings(samples=samples, passes=names, seed=3))


def check_bright(images, what) -> None:
    for name, image in images.items():
        assert np.isfinite(image).all(), f"{name} of {what}"
    # The light of one sample has no noise; the filter's weights add up to 1 but for rounding.
    assert images["Combined"][:, :, :3] == pytest.approx(1.0, abs=1e-5), what


def extreme_observer(model: str, rx: str, **more) -> eyecore.Observer:
    return eyecore.Observer(
        model=model,
        rx=rx,
        rx_plane="entrance_pupil",
        pupil=9,
        exact_trace=True,
        wavefront=eyecore.Wavefront(6 * [0.0] + 10 * [0.2], pupil_mm=9.0),
        **more,
    )


@pytest.mark.parametrize("rx", PRESCRIPTIONS)
@pytest.mark.parametrize("model", ["pinhole", "paper", "paraxial", "wavefront"])
def test_a_bright_wall_is_bright_for_every_eye_at_any_distance_in_any_unit(model, rx) -> None:
    for distance_m, unit_m, at_units in itertools.product(DISTANCES_M, UNITS_M, (0.0, 1e6)):
        images = picture(wall(distance_m, unit_m, at_units), extreme_observer(model, rx))
        check_bright(images, (model, rx, distance_m, unit_m, at_units))


@pytest.mark.parametrize("rx", ["-30.00DS", "+30.00DS"])
@pytest.mark.parametrize("model", ["navarro", "arizona", "le_grand"])
def test_eyes_with_surfaces_see_it_through_the_pupil_that_they_have(model, rx) -> None:
    """What the iris or the cornea's edge holds back makes the picture darker, not black."""
    for distance_m, unit_m, at_units in itertools.product(DISTANCES_M, UNITS_M, (0.0, 1e6)):
        images = picture(wall(distance_m, unit_m, at_units), extreme_observer(model, rx))
        what = (model, rx, distance_m, unit_m, at_units)
        for name, image in images.items():
            assert np.isfinite(image).all(), f"{name} of {what}"
        light = images["Combined"][:, :, :3]
        assert light.max() < 1.0 + 1e-5, what
        assert light[3:5, 3:5] == pytest.approx(1.0, abs=1e-5), what


@pytest.mark.parametrize("rx", PRESCRIPTIONS)
def test_the_strongest_glasses_show_it_too(rx) -> None:
    for distance_m, unit_m in itertools.product((0.03, 1.0, 1e7), UNITS_M):
        observer = extreme_observer("paraxial", "plano", correction="glasses", worn=rx)
        check_bright(picture(wall(distance_m, unit_m), observer), (rx, distance_m, unit_m))


@pytest.mark.parametrize("model", eyecore.EYE_MODELS)
def test_a_picture_does_not_know_the_worlds_origin_or_unit(model) -> None:
    """Shifting and scaling by powers of two rounds nothing: the same bits."""
    observer = extreme_observer(model, "-12.00DS -4.00DC 30A")
    expected = picture(wall(2.0, left_m=0.0), observer, samples=256)["Combined"]
    assert expected.min() == 0.0 and expected[:, :, 0].max() > 0.9
    for unit_m, at_units in itertools.product((2.0**-10, 1.0, 2.0**10), (0.0, 2.0**20)):
        scene = wall(2.0, unit_m, at_units, left_m=0.0)
        found = picture(scene, observer, samples=256)["Combined"]
        assert (found == expected).all(), (unit_m, at_units)


@pytest.mark.parametrize("strength", [1e-30, 1e-6, 1.0, 1e6, 1e30])
@pytest.mark.parametrize("formula", eyecore.PUPIL_FORMULAS)
def test_the_pupil_answers_any_light_with_a_size_it_can_have(formula, strength) -> None:
    observer = eyecore.Observer(pupil="auto", pupil_formula=formula)
    scene = wall(1.0, radiance=strength)
    session = eyecore.Session(scene, observer, eyecore.Settings(samples=1))
    assert 1.5 <= session.pupil_mm <= 9.0
    session.start()
    assert session.wait(10.0)
    assert session.error is None
    light = session.snapshot()["Combined"][:, :, :3]
    # Materials shine with 1e8 at most, and a picture of them stays within floats.
    assert light / np.float32(min(strength, 1e8)) == pytest.approx(1.0, abs=1e-5)
