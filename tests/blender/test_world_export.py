import math

import bpy
import numpy as np
import pytest
from eye_render.export.image import ImageTable
from eye_render.export.world import export_world
from scenes import RecordingScene, add_node, link, surface


@pytest.fixture
def export(scene, depsgraph_of):
    def run() -> RecordingScene:
        recording = RecordingScene()
        recording.warnings = []
        warn = recording.warnings.append
        export_world(recording, depsgraph_of(), ImageTable(recording, warn), warn)
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


def environment(world: bpy.types.World) -> bpy.types.Node:
    """Shines through a new environment texture, whose node is given."""
    background = surface(world, "ShaderNodeBackground")
    image = bpy.data.images.new("Sky", 4, 2, float_buffer=True)
    texture = add_node(world, "ShaderNodeTexEnvironment", image=image)
    link(world, texture.outputs["Color"], background.inputs["Color"])
    return texture


def test_no_world_is_black(export):
    assert export().world.color == (0.0, 0.0, 0.0)


def test_background_colour_and_strength(export, world):
    background = surface(world, "ShaderNodeBackground")
    background.inputs["Color"].default_value = (0.5, 0.25, 1.0, 1.0)
    background.inputs["Strength"].default_value = 2.0
    exported = export()
    assert exported.world.color == (0.5, 0.25, 1.0)
    assert exported.world.strength == 2.0
    assert exported.warnings == []


def test_an_environment_texture(export, world):
    environment(world)
    exported = export()
    assert exported.world.texture == 0
    assert np.allclose(exported.world.texture_from_world, np.eye(3))
    assert exported.warnings == []


def test_a_mapping_turns_directions_as_blender_does(export, world):
    texture = environment(world)
    mapping = add_node(world, "ShaderNodeMapping")
    mapping.inputs["Rotation"].default_value = (0.0, 0.0, math.radians(90))
    coordinates = add_node(world, "ShaderNodeTexCoord")
    link(world, coordinates.outputs["Generated"], mapping.inputs["Vector"])
    link(world, mapping.outputs["Vector"], texture.inputs["Vector"])
    exported = export()
    # A point mapping rotates the direction itself: +X is looked up at +Y.
    looked_up = exported.world.texture_from_world @ (1, 0, 0)
    assert np.allclose(looked_up, (0, 1, 0), atol=1e-6)
    assert exported.warnings == []


def test_a_mapping_that_scales_is_named(export, world):
    texture = environment(world)
    mapping = add_node(world, "ShaderNodeMapping")
    mapping.inputs["Scale"].default_value = (1.0, 2.0, 1.0)
    link(world, mapping.outputs["Vector"], texture.inputs["Vector"])
    assert "all but constant Rotation" in export().warnings[0]


def test_another_sky_is_named_and_its_socket_colour_stays(export, world):
    background = surface(world, "ShaderNodeBackground")
    background.inputs["Color"].default_value = (0.0, 0.5, 1.0, 1.0)
    noise = add_node(world, "ShaderNodeTexNoise", name="Clouds")
    link(world, noise.outputs["Color"], background.inputs["Color"])
    exported = export()
    assert exported.world.color == (0.0, 0.5, 1.0)
    assert "Clouds" in exported.warnings[0]
