import bpy
import pytest
from eye_render import core
from eye_render.export.image import ImageTable
from eye_render.export.world import export_world
from scenes import RecordingGraph, RecordingScene, add_node, link, surface


@pytest.fixture
def export(scene, depsgraph_of, monkeypatch):
    monkeypatch.setattr(core.module, "NodeGraph", RecordingGraph)

    def run() -> RecordingScene:
        recording = RecordingScene()
        recording.warnings = []
        warn = recording.warnings.append
        export_world(recording, depsgraph_of(), ImageTable(recording, 1, warn), warn)
        return recording

    return run


@pytest.fixture
def world(scene) -> bpy.types.World:
    """The scene's world, with only an output node."""
    scene.world = bpy.data.worlds.new("Sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes.clear()
    scene.world.node_tree.nodes.new("ShaderNodeOutputWorld")
    return scene.world


def test_no_world_is_black(export):
    assert export().world == (0.0, 0.0, 0.0)


def test_a_layer_without_environment_is_black(scene, export, world):
    surface(world, "ShaderNodeBackground")
    scene.view_layers[0].use_sky = False
    assert export().world == (0.0, 0.0, 0.0)


def test_a_world_without_surface_is_black(export, world):
    assert export().world == (0.0, 0.0, 0.0)


def test_background_colour_and_strength(export, world):
    background = surface(world, "ShaderNodeBackground")
    background.inputs["Color"].default_value = (0.5, 0.25, 1.0, 1.0)
    background.inputs["Strength"].default_value = 2.0
    exported = export()
    shader, output = exported.world
    assert (shader.kind, output) == ("BACKGROUND", "Background")
    assert shader.inputs["Color"] == (0.5, 0.25, 1.0)
    assert shader.inputs["Strength"] == 2.0
    assert exported.warnings == []


def test_an_environment_texture_behind_a_mapping(export, world):
    background = surface(world, "ShaderNodeBackground")
    image = bpy.data.images.new("Sky", 4, 2, float_buffer=True)
    texture = add_node(world, "ShaderNodeTexEnvironment", image=image)
    mapping = add_node(world, "ShaderNodeMapping")
    mapping.inputs["Rotation"].default_value = (0.0, 0.0, 1.0)
    coordinates = add_node(world, "ShaderNodeTexCoord")
    link(world, coordinates.outputs["Generated"], mapping.inputs["Vector"])
    link(world, mapping.outputs["Vector"], texture.inputs["Vector"])
    link(world, texture.outputs["Color"], background.inputs["Color"])
    exported = export()
    picture, _ = exported.world.node.inputs["Color"]
    assert picture.options["texture"] == 0
    mapped, _ = picture.inputs["Vector"]
    assert mapped.inputs["Rotation"] == (0.0, 0.0, 1.0)
    assert mapped.inputs["Vector"].node.kind == "TEX_COORD"
    assert exported.warnings == []


def test_a_volume_fills_the_scene(export, world):
    surface(world, "ShaderNodeBackground")
    scatter = add_node(world, "ShaderNodeVolumeScatter", name="Haze")
    scatter.inputs["Density"].default_value = 0.25
    output = world.node_tree.get_output_node("CYCLES")
    link(world, scatter.outputs[0], output.inputs["Volume"])
    exported = export()
    assert exported.world.node.kind == "BACKGROUND"
    assert exported.world_volume.node.kind == "VOLUME_SCATTER"
    assert exported.world_volume.node.inputs["Density"] == 0.25
    assert exported.warnings == []


def test_a_world_hides_from_kinds_of_rays(export, world):
    surface(world, "ShaderNodeBackground")
    world.cycles_visibility.glossy = world.cycles_visibility.camera = False
    exported = export()
    assert exported.world.node.kind == "BACKGROUND"
    assert exported.world_hidden_from == ["CAMERA", "GLOSSY"]
