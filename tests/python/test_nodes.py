"""Graphs of shader nodes in plain Python: what there is, what is refused, and what they show."""

import eyecore
import numpy as np
import pytest
from materials import add_plain

QUAD = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32)
TRIANGLES = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)
CORNERS = QUAD[TRIANGLES.ravel()]


def picture(scene: eyecore.Scene, size: int = 8) -> np.ndarray:
    """Of a window that shows the quad at 2 m edge to edge, rows bottom-up."""
    scene.set_camera(np.eye(4), (-0.5, 0.5, -0.5, 0.5), (size, size))
    settings = eyecore.Settings(samples=4, filter_width_px=0.1)
    return eyecore.render(scene, eyecore.Observer(model="pinhole"), settings)["Combined"]


def quad_of(scene: eyecore.Scene, material: int, **mesh) -> None:
    at = np.eye(4)
    at[2, 3] = -2.0
    scene.add_instances(scene.add_mesh("quad", QUAD, TRIANGLES, **mesh), at[None], [material])


def shown(socket_of, **mesh) -> np.ndarray:
    """The colour of an output on the quad, (8, 8, 3)."""
    scene = eyecore.Scene()
    graph = eyecore.NodeGraph()
    light = graph.add("EMISSION", {"Color": socket_of(graph)})
    quad_of(scene, scene.add_material("m", light["Emission"]), **mesh)
    return picture(scene)[:, :, :3]


def test_node_types_tell_sockets_and_options_by_blenders_names() -> None:
    kinds = eyecore.NODE_TYPES
    assert kinds["MIX_SHADER"] == {
        "inputs": ["Fac", "Shader", "Shader_001"],
        "outputs": ["Shader"],
        "options": [],
    }
    assert kinds["UVMAP"] == {"inputs": [], "outputs": ["UV"], "options": ["uv_map"]}
    assert {"BSDF_PRINCIPLED", "EMISSION", "BACKGROUND", "TEX_IMAGE", "NORMAL_MAP"} <= set(kinds)
    for kind, row in kinds.items():
        assert set(row) == {"inputs", "outputs", "options"}, kind


def test_graph_is_set_and_linked_by_identifiers() -> None:
    scene = eyecore.Scene()
    graph = eyecore.NodeGraph()
    dark = graph.add("EMISSION")
    dark.set("Strength", 0.0)
    light = graph.add("EMISSION", {"Strength": 2.0})
    light.set("Color", (0.25, 0.5, 1.0, 0.7))  # alpha is not read
    mix = graph.add("MIX_SHADER", {"Fac": 0.5, "Shader": dark["Emission"]})
    mix.set("Shader_001", light["Emission"])
    quad_of(scene, scene.add_material("m", mix["Shader"]))
    assert picture(scene)[4, 4, :3] == pytest.approx([0.25, 0.5, 1.0])


# Eight pixels over a quad from -1 to 1.
MIDDLES = (np.arange(8) + 0.5) / 8.0
# Rays are aimed a little beside the middle of a pixel: by its filter, a tenth of it.
ASIDE = 0.05 / 8.0 + 1e-4


def test_uv_layers_are_read_by_name_and_by_the_active_one() -> None:
    uvs = {
        "a": CORNERS[:, :2] * 0.5 + 0.5,
        "b": 1.0 - (CORNERS[:, :2] * 0.5 + 0.5),
    }
    right = np.broadcast_to(MIDDLES, (8, 8))
    for name, active, expected in (("a", "", right), ("b", "", 1 - right), ("", "b", 1 - right)):
        image = shown(
            lambda graph, name=name: graph.add("UVMAP", uv_map=name)["UV"],
            uvs=uvs,
            active_uv=active,
        )
        assert image[:, :, 0] == pytest.approx(expected, abs=ASIDE), (name, active)


def test_attributes_are_interpolated_and_zero_where_they_are_not() -> None:
    values = np.concatenate([np.abs(CORNERS), np.full((6, 1), 0.5)], axis=1).astype(np.float32)
    image = shown(
        lambda graph: graph.add("ATTRIBUTE", attribute_name="a")["Alpha"],
        attributes={"a": values},
    )
    assert image == pytest.approx(0.5)
    image = shown(
        lambda graph: graph.add("ATTRIBUTE", attribute_name="absent")["Color"],
        attributes={"a": values},
    )
    assert (image == 0.0).all()


def test_generated_follows_the_texture_space() -> None:
    def generated(graph):
        return graph.add("TEX_COORD")["Generated"]

    across = np.broadcast_to(MIDDLES, (8, 8))
    assert shown(generated)[:, :, 0] == pytest.approx(across, abs=ASIDE)
    image = shown(generated, texture_space=((-1.0, 0.0, 0.0), (4.0, 1.0, 1.0)))
    assert image[:, :, 0] == pytest.approx(0.5 * across, abs=ASIDE)


def test_object_info_tells_instances_apart() -> None:
    scene = eyecore.Scene()
    graph = eyecore.NodeGraph()
    facts = graph.add("OBJECT_INFO")
    light = graph.add("EMISSION", {"Color": facts["Color"], "Strength": facts["Random"]})
    material = scene.add_material("m", light["Emission"])
    half = QUAD * [0.5, 1.0, 1.0]
    mesh = scene.add_mesh("half", half.astype(np.float32), TRIANGLES)
    at = np.stack([np.eye(4), np.eye(4)])
    at[:, :3, 3] = [[-0.5, 0.0, -2.0], [0.5, 0.0, -2.0]]
    colors = np.array([[1, 0, 0, 1], [0, 1, 0, 1]], np.float32)
    randoms = np.array([0.5, 0.25], np.float32)
    scene.add_instances(mesh, at, [material], colors=colors, randoms=randoms)
    image = picture(scene)
    assert image[4, 1, :3] == pytest.approx([0.5, 0.0, 0.0])
    assert image[4, 6, :3] == pytest.approx([0.0, 0.25, 0.0])


def test_displacement_bends_what_is_lit() -> None:
    def brightness(height) -> float:
        scene = eyecore.Scene()
        graph = eyecore.NodeGraph()
        diffuse = graph.add("BSDF_DIFFUSE", {"Color": 1.0})
        displacement = None
        if height is not None:
            displacement = graph.add("DISPLACEMENT", {"Height": height(graph)})["Displacement"]
        quad_of(scene, scene.add_material("m", diffuse["BSDF"], displacement=displacement))
        scene.add_light("sun", "SUN", np.eye(4), (1.0, 1.0, 1.0))
        return float(picture(scene)[4, 4, 0])

    flat = brightness(None)
    # The mean of the coordinates rises by a third along x and y: normal (-1, -1, 3).
    tilted = brightness(lambda graph: graph.add("TEX_COORD")["Object"])
    assert flat > 0.0
    assert tilted / flat == pytest.approx(3.0 / 11.0**0.5, rel=1e-3)


def test_world_is_a_colour_or_a_graph() -> None:
    scene = eyecore.Scene()
    scene.set_world((0.25, 0.5, 1.0))
    assert picture(scene)[4, 4, :3] == pytest.approx([0.25, 0.5, 1.0])
    graph = eyecore.NodeGraph()
    direction = graph.add("TEX_COORD")["Generated"]
    background = graph.add("BACKGROUND", {"Color": direction, "Strength": 2.0})
    scene.set_world(background["Background"])
    up = np.eye(4)
    up[:3, :3] = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]  # looks along +Z
    scene.set_camera(up, (-0.01, 0.01, -0.01, 0.01), (2, 2))
    image = eyecore.render(scene, eyecore.Observer(model="pinhole"), eyecore.Settings(samples=1))[
        "Combined"
    ]
    assert image[:, :, 2] == pytest.approx(2.0, rel=1e-3)


def test_materials_tell_what_they_read() -> None:
    scene = eyecore.Scene()
    graph = eyecore.NodeGraph()
    texture = scene.add_texture_pixels("p", np.ones((1, 1, 4), np.float32))
    layer = graph.add("UVMAP", uv_map="b")["UV"]
    image = graph.add("TEX_IMAGE", {"Vector": layer}, texture=texture)
    wear = graph.add("ATTRIBUTE", attribute_name="wear")
    light = graph.add("EMISSION", {"Color": image["Color"], "Strength": wear["Fac"]})
    number = scene.add_material("m", light["Emission"])
    plain = add_plain(scene, "plain", "BSDF_DIFFUSE")
    assert scene.uv_layers_read([number, plain]) == ["b"]
    assert scene.attributes_read([number]) == ["wear"]
    assert scene.uv_layers_read([plain]) == scene.attributes_read([plain]) == []


def circle() -> None:
    graph = eyecore.NodeGraph()
    mix = graph.add("MIX_SHADER")
    mix.set("Shader", mix["Shader"])
    eyecore.Scene().add_material("m", mix["Shader"])


def two_graphs() -> None:
    first, second = eyecore.NodeGraph(), eyecore.NodeGraph()
    eyecore.Scene().add_material(
        "m",
        first.add("BSDF_DIFFUSE")["BSDF"],
        displacement=second.add("DISPLACEMENT")["Displacement"],
    )


def link_across() -> None:
    source = eyecore.NodeGraph().add("TEX_COORD")["UV"]
    eyecore.NodeGraph().add("EMISSION", {"Color": source})


def absent_texture() -> None:
    graph = eyecore.NodeGraph()
    eyecore.Scene().add_material("m", graph.add("TEX_IMAGE", texture=3)["Color"])


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: eyecore.NodeGraph().add("WOOL"), r"node kind 'WOOL' is not supported"),
        (
            lambda: eyecore.NodeGraph().add("UVMAP", layer="a"),
            r"option 'layer' of UVMAP does not exist; expected one of uv_map",
        ),
        (
            lambda: eyecore.NodeGraph().add("EMISSION", {"Hue": 1.0}),
            r"input 'Hue' of EMISSION does not exist; expected one of Color, Strength",
        ),
        (
            lambda: eyecore.NodeGraph().add("EMISSION")["Color"],
            r"output 'Color' of EMISSION does not exist; expected one of Emission",
        ),
        (
            lambda: eyecore.NodeGraph().add("EMISSION", {"Color": "red"}),
            r"input 'Color' is 'red'; expected a number, three or four numbers, or a socket",
        ),
        (
            lambda: eyecore.NodeGraph().add("EMISSION", {"Color": (1.0, 2.0)}),
            r"input 'Color' is \(1.0, 2.0\); expected a number, three or four numbers",
        ),
        (
            lambda: eyecore.NodeGraph().add("EMISSION", {"Strength": float("nan")}),
            r"input 'Strength' of EMISSION is not finite",
        ),
        (
            lambda: eyecore.NodeGraph().add("UVMAP", uv_map=object),
            r"uv_map is .*; expected a text, a number or a list of numbers",
        ),
        (
            lambda: add_plain(eyecore.Scene(), "m", "BSDF_GLOSSY", distribution="WARD"),
            r"distribution is WARD; expected one of",
        ),
        (circle, r"the links of node 0 \(MIX_SHADER\) run in a circle"),
        (two_graphs, r"the outputs of material 'm' are of two graphs"),
        (link_across, r"input 'Color' is linked to another graph"),
        (absent_texture, r"texture 3 does not exist; there are 0"),
    ],
)
def test_refusals_name_what_is_wrong_and_what_is_allowed(call, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        call()


def test_properties_of_instances_are_attributes_that_the_mesh_lacks() -> None:
    scene = eyecore.Scene()
    graph = eyecore.NodeGraph()
    tone = graph.add("ATTRIBUTE", attribute_name="tone")
    light = graph.add("EMISSION", {"Color": tone["Color"]})
    material = scene.add_material("m", light["Emission"])
    half = QUAD * [0.5, 1.0, 1.0]
    mesh = scene.add_mesh("half", half.astype(np.float32), TRIANGLES)
    at = np.stack([np.eye(4), np.eye(4)])
    at[:, :3, 3] = [[-0.5, 0.0, -2.0], [0.5, 0.0, -2.0]]
    tones = np.array([[0.5, 0.5, 0.5, 1], [0.25, 0.5, 1.0, 1]], np.float32)
    scene.add_instances(mesh, at, [material], attributes={"tone": tones, "unread": tones})
    image = picture(scene)
    assert image[4, 1, :3] == pytest.approx([0.5, 0.5, 0.5])
    assert image[4, 6, :3] == pytest.approx([0.25, 0.5, 1.0])
    with pytest.raises(ValueError, match="attribute 'tone' has shape"):
        scene.add_instances(mesh, at, [material], attributes={"tone": tones[:1]})


def test_values_that_an_option_cannot_have_are_refused_by_the_node() -> None:
    graph = eyecore.NodeGraph()
    with pytest.raises(ValueError, match="operation is FLY"):
        graph.add("MATH", operation="FLY")
    with pytest.raises(ValueError, match="TILT="):
        graph.add("TEX_IES", ies="not a profile")
