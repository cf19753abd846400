"""Strands, balls and what moves, from plain Python."""

import eyecore
import numpy as np
import pytest
from materials import add_light

QUAD = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32)
TRIANGLES = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)
POLE = np.array([[0, -3, 0], [0, -1, 0], [0, 1, 0], [0, 3, 0]], np.float32)
WINDOW = (-0.25, 0.25, -0.25, 0.25)  # 5 units wide at a distance of 10
SIZE_PX = 20


def at(x: float = 0.0, y: float = 0.0, z: float = -10.0) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def seen(scene: eyecore.Scene, samples: int = 64, camera=None, **of_camera) -> np.ndarray:
    scene.set_camera(
        np.eye(4) if camera is None else camera, WINDOW, (SIZE_PX, SIZE_PX), **of_camera
    )
    settings = eyecore.Settings(samples=samples)
    return eyecore.render(scene, eyecore.Observer(model="pinhole"), settings)["Combined"][..., 0]


def shining(add, **placed) -> eyecore.Scene:
    """What `add` makes of a scene, shining with radiance 1 at a distance of 10."""
    scene = eyecore.Scene()
    paint = add_light(scene, "light")
    matrix = placed.pop("matrix", at())
    scene.add_instances(add(scene), matrix[None], [paint], **placed)
    return scene


def covered_units2(image: np.ndarray) -> float:
    return image.sum() * (5.0 / SIZE_PX) ** 2


def test_a_ball_covers_its_disk() -> None:
    scene = shining(lambda s: s.add_points("ball", np.zeros((1, 3)), np.ones(1)))
    # A ball of radius 1 at 10 is seen as a cone, whose disk at 10 has r^2 = 1 / (1 - 1 / 100).
    assert covered_units2(seen(scene)) == pytest.approx(np.pi / 0.99, rel=0.005)


@pytest.mark.parametrize("shape, distance", [("ROUND", 10.0), ("RIBBON", 10.0)])
def test_a_strand_covers_its_width(shape, distance) -> None:
    scene = shining(lambda s: s.add_curves("pole", POLE, np.full(4, 0.5), [0], shape=shape))
    assert covered_units2(seen(scene)) == pytest.approx(5.0, rel=0.01)


def test_broken_strands_and_points_are_refused() -> None:
    scene = eyecore.Scene()
    with pytest.raises(ValueError, match=r"radii has shape \(3\); expected \(4,\)"):
        scene.add_curves("pole", POLE, np.ones(3), [0])
    with pytest.raises(ValueError, match="strand 1 has less than 2 keys"):
        scene.add_curves("pole", POLE, np.ones(4), [0, 3])
    with pytest.raises(ValueError, match="shape is 'FLAT'; expected one of ROUND"):
        scene.add_curves("pole", POLE, np.ones(4), [0], shape="FLAT")
    with pytest.raises(ValueError, match="a radius is -1"):
        scene.add_points("ball", np.zeros((1, 3)), -np.ones(1))
    with pytest.raises(ValueError, match="motion has 1 step"):
        scene.add_points("ball", np.zeros((1, 3)), np.ones(1), motion_positions=[np.zeros((1, 3))])
    with pytest.raises(ValueError, match=r"motion has shape \(3, 4, 4\); expected \(1, steps"):
        ball = scene.add_points("ball", np.zeros((1, 3)), np.ones(1))
        scene.add_instances(ball, np.eye(4)[None], motion=np.zeros((3, 4, 4)))


def test_an_eye_that_moves_sees_what_moves_the_other_way() -> None:
    def quad(scene):
        return scene.add_mesh("quad", QUAD, TRIANGLES)

    path = [at(-1.0), at(0.0), at(1.0)]
    by_object = seen(shining(quad, motion=np.array(path)[None]))
    poses = [(at(-x, z=0.0), WINDOW) for x in (-1.0, 0.0, 1.0)]
    by_camera = seen(shining(quad), motion=poses)
    np.testing.assert_allclose(by_camera, by_object, atol=1e-5)
    # Half of the time at the still square's edges, all of it nowhere but in the middle.
    row = by_object[SIZE_PX // 2]
    assert row[SIZE_PX // 2] == pytest.approx(1.0, abs=0.1)
    assert row[SIZE_PX // 2 - 4] == pytest.approx(0.5, abs=0.15)
    assert (row > 0.0).sum() > 12


def test_an_eye_far_from_the_origin_moves_as_well() -> None:
    def quad(scene):
        return scene.add_mesh("quad", QUAD, TRIANGLES)

    far = np.zeros((4, 4))
    far[0, 3] = 1e7
    path = [at(-1.0), at(0.0), at(1.0)]
    near = seen(shining(quad, motion=np.array(path)[None]))
    there = seen(
        shining(quad, matrix=at() + far, motion=np.array([m + far for m in path])[None]),
        camera=np.eye(4) + far,
    )
    np.testing.assert_allclose(there, near, atol=1e-4)


def test_a_deforming_mesh_is_spread() -> None:
    steps = [QUAD + np.float32([x, 0, 0]) for x in (-1.0, 0.0, 1.0)]
    deforming = seen(
        shining(lambda s: s.add_mesh("quad", QUAD, TRIANGLES, motion_positions=steps))
    )
    moving = seen(
        shining(
            lambda s: s.add_mesh("quad", QUAD, TRIANGLES),
            motion=np.array([at(-1.0), at(0.0), at(1.0)])[None],
        )
    )
    np.testing.assert_allclose(deforming, moving, atol=1e-4)


def test_the_plan_says_what_moves() -> None:
    scene = shining(lambda s: s.add_mesh("quad", QUAD, TRIANGLES))
    scene.set_camera(np.eye(4), WINDOW, (4, 4))
    settings, observer = eyecore.Settings(samples=1), eyecore.Observer(model="pinhole")
    assert "motion: none\n" in eyecore.Session(scene, observer, settings).plan_text
    moving = shining(
        lambda s: s.add_mesh("quad", QUAD, TRIANGLES), motion=np.array([at(), at(1.0)])[None]
    )
    moving.set_camera(np.eye(4), WINDOW, (4, 4))
    assert "motion: 1 objects move, 0 meshes deform, 0 lamps move, camera still\n" in (
        eyecore.Session(moving, observer, settings).plan_text
    )
