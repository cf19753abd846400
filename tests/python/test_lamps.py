"""Lamps in plain Python: their nodes, and who sees them."""

import eyecore
import numpy as np
import pytest

WALL = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32)


def middle_pixel(scene: eyecore.Scene) -> np.ndarray:
    scene.set_camera(np.eye(4), (-0.01, 0.01, -0.01, 0.01), (1, 1))
    settings = eyecore.Settings(samples=4, filter_width_px=0.1)
    picture = eyecore.render(scene, eyecore.Observer(model="pinhole"), settings)["Combined"]
    return picture[0, 0, :3]


def lit_wall(**lamp) -> np.ndarray:
    """A white wall two units ahead, lit from the eye by a point lamp."""
    scene = eyecore.Scene()
    graph = eyecore.NodeGraph()
    white = scene.add_material("white", graph.add("BSDF_DIFFUSE", {"Color": 1.0})["BSDF"])
    at = np.eye(4)
    at[2, 3] = -2.0
    wall = scene.add_mesh("wall", WALL, np.array([[0, 1, 2], [0, 2, 3]], np.uint32))
    scene.add_instances(wall, at[None], [white])
    scene.add_light("lamp", "POINT", np.eye(4), (50.0, 50.0, 50.0), **lamp)
    return middle_pixel(scene)


def test_nodes_of_a_lamp_multiply_its_light() -> None:
    plain = lit_wall()
    graph = eyecore.NodeGraph()
    constant = graph.add("EMISSION", {"Color": (1.0, 0.5, 0.0), "Strength": 4.0})
    assert lit_wall(surface=constant["Emission"]) == pytest.approx(plain * [4.0, 2.0, 0.0])
    falloff = graph.add("LIGHT_FALLOFF", {"Strength": 1.0})
    even = graph.add("EMISSION", {"Strength": falloff["Constant"]})
    # The length of the ray squared, to the wall two units away.
    assert lit_wall(surface=even["Emission"]) == pytest.approx(plain * 4.0, rel=0.05)


def test_a_negative_lamp_takes_light_away() -> None:
    plain = lit_wall()
    graph = eyecore.NodeGraph()
    negative = graph.add("EMISSION", {"Color": (1.0, 0.5, 0.0), "Strength": -1.0})
    assert lit_wall(surface=negative["Emission"]) == pytest.approx(plain * [-1.0, -0.5, 0.0])
    falloff = graph.add("LIGHT_FALLOFF", {"Strength": -1.0})
    even = graph.add("EMISSION", {"Strength": falloff["Constant"]})
    assert lit_wall(surface=even["Emission"]) == pytest.approx(plain * -4.0, rel=0.05)
    # A wide one, which the camera's rays meet: of the wall and of itself nothing is lost.
    seen = lit_wall(surface=negative["Emission"], radius=0.5, hidden_from=[])
    assert seen[0] == pytest.approx(-lit_wall(radius=0.5, hidden_from=[])[0], rel=0.02)


def test_a_lamp_hidden_from_diffuse_lights_no_wall() -> None:
    assert lit_wall(hidden_from=["DIFFUSE"]) == pytest.approx(0.0)
    assert lit_wall(hidden_from=["GLOSSY", "TRANSMISSION"]) == pytest.approx(lit_wall())
    with pytest.raises(ValueError, match="hidden_from"):
        lit_wall(hidden_from=["EVERYBODY"])


def test_a_lamp_is_seen_by_the_camera_on_request() -> None:
    def middle(**lamp) -> float:
        scene = eyecore.Scene()
        at = np.eye(4)
        at[2, 3] = -2.0
        scene.add_light("lamp", "POINT", at, (50.0, 50.0, 50.0), radius=1.5, **lamp)
        return float(middle_pixel(scene)[0])

    assert middle() == 0.0
    # A sphere of radius r radiates P / (4 pi^2 r^2).
    assert middle(hidden_from=[]) == pytest.approx(50.0 / (4.0 * np.pi**2 * 1.5**2), rel=1e-3)
