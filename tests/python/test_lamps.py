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


FACES = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)


def linked_wall(lamp: dict, wall: dict, blocker: dict | None = None) -> float:
    """What a white wall two units ahead shows of a point lamp beside the eye; the blocker, which
    the camera does not see, stands before the lamp."""
    scene = eyecore.Scene()
    graph = eyecore.NodeGraph()
    white = scene.add_material("white", graph.add("BSDF_DIFFUSE", {"Color": 1.0})["BSDF"])
    square = scene.add_mesh("square", WALL, FACES)
    at = np.eye(4)
    at[2, 3] = -2.0
    scene.add_instances(square, at[None], [white], **wall)
    if blocker is not None:
        at = np.diag([0.1, 0.1, 1.0, 1.0])
        at[:3, 3] = 0.5, 0.0, -0.5
        scene.add_instances(square, at[None], [white], hidden_from=["CAMERA"], **blocker)
    beside = np.eye(4)
    beside[:3, 3] = 0.5, 0.0, -0.25
    scene.add_light("lamp", "POINT", beside, (50.0, 50.0, 50.0), **lamp)
    return float(middle_pixel(scene)[0])


def test_a_lamp_lights_the_classes_that_it_is_linked_to() -> None:
    everything = linked_wall({}, {})
    assert everything > 0.0
    assert linked_wall({"lit_classes": 0b100}, {"light_class": 2}) == everything
    assert linked_wall({"lit_classes": 0b100}, {"light_class": 1}) == 0.0
    assert linked_wall({"lit_classes": 0b100}, {}) == 0.0


def test_a_shining_object_lights_the_classes_that_it_is_linked_to() -> None:
    def lit(classes: int, samples: int = 64) -> float:
        scene = eyecore.Scene()
        graph = eyecore.NodeGraph()
        white = scene.add_material("white", graph.add("BSDF_DIFFUSE", {"Color": 1.0})["BSDF"])
        glow = scene.add_material("glow", graph.add("EMISSION", {"Strength": 1.0})["Emission"])
        square = scene.add_mesh("square", WALL, FACES)
        ahead, behind = np.eye(4), np.eye(4)
        ahead[2, 3], behind[2, 3] = -2.0, 1.0
        scene.add_instances(square, ahead[None], [white], light_class=3)
        scene.add_instances(square, behind[None], [glow], lit_classes=classes)
        scene.set_camera(np.eye(4), (-0.01, 0.01, -0.01, 0.01), (1, 1))
        settings = eyecore.Settings(samples=samples, filter_width_px=0.1)
        picture = eyecore.render(scene, eyecore.Observer(model="pinhole"), settings)["Combined"]
        return float(picture[0, 0, 0])

    assert lit(0b1000) > 0.05
    assert lit(0b0111) == 0.0


def test_shadows_are_thrown_by_the_blockers_of_the_lamp_alone() -> None:
    bright = linked_wall({}, {})
    assert linked_wall({}, {}, {}) < bright / 2
    assert linked_wall({"blocker_set": 2}, {}, {"blocker_sets": 0b01}) == pytest.approx(bright)
    blocked = linked_wall({"blocker_set": 2}, {}, {"blocker_sets": 0b10})
    assert blocked == pytest.approx(linked_wall({}, {}, {}))


def test_links_out_of_range_are_refused() -> None:
    with pytest.raises(ValueError, match="blocker_set is 21; expected 0 to 20"):
        linked_wall({"blocker_set": 21}, {})
    with pytest.raises(ValueError, match="light_class is 64; expected 0 to 63"):
        linked_wall({}, {"light_class": 64})
