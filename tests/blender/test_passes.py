"""Passes: what the compositor is offered, and what arrives in files."""

import json
import re
import subprocess
from collections.abc import Callable

import bpy
import numpy as np
import pytest
from eye_render import core, passes
from scenes import (
    add_group_socket,
    add_object,
    emitter,
    layer_pixels,
    node_material,
    quad_mesh,
    surface,
    write_multilayer,
)
from tools.meshes import cube_mesh

BLENDER_S_SWITCHES = [
    *("use_pass_z", "use_pass_mist", "use_pass_position", "use_pass_normal", "use_pass_uv"),
    *("use_pass_object_index", "use_pass_material_index", "use_pass_emit"),
    *("use_pass_environment", "use_pass_ambient_occlusion", "use_pass_vector", "use_pass_shadow"),
    *(
        f"use_pass_{lobe}_{part}"
        for lobe in ("diffuse", "glossy", "transmission")
        for part in ("direct", "indirect", "color")
    ),
    *(f"use_pass_cryptomatte_{kind}" for kind in ("object", "material", "asset")),
]
CYCLES_SWITCHES = [
    *("use_pass_volume_direct", "use_pass_volume_indirect"),
    *("use_pass_shadow_catcher", "denoising_store_passes"),
]
# What Cycles registers besides, and Eye Render does not have.
ONLY_IN_CYCLES = {"Denoising Depth", "Denoising Specular Albedo", "Denoising Roughness"}


class RecordingEngine:
    def __init__(self):
        self.rows = []

    def register_pass(self, _scene, _view_layer, name, channels, channel_ids, kind):
        self.rows.append((name, channels, channel_ids, kind))


@pytest.fixture
def all_passes(scene):
    view_layer = scene.view_layers[0]
    for switch in BLENDER_S_SWITCHES:
        setattr(view_layer, switch, True)
    for switch in CYCLES_SWITCHES:
        setattr(view_layer.cycles, switch, True)
    return view_layer


def registered(scene, view_layer) -> list[tuple]:
    engine = RecordingEngine()
    passes.register(engine, scene, view_layer)
    return engine.rows


def test_passes_have_the_names_and_channels_that_cycles_gives_them(scene, all_passes):
    from cycles.engine import list_render_passes

    scene.cycles.use_denoising = False
    in_cycles = {
        (name, len(ids), ids, kind) for name, ids, kind in list_render_passes(scene, all_passes)
    }
    missing = {row for row in in_cycles if row[0] not in ONLY_IN_CYCLES} - set(
        registered(scene, all_passes)
    )
    assert missing == set()


def test_every_pass_of_the_core_has_a_switch_and_none_is_on_by_itself(scene):
    assert passes.SWITCHES.keys() == {name for name, _, _ in core.module.PASSES} - {"Combined"}
    assert [name for name, *_ in registered(scene, scene.view_layers[0])] == ["Combined"]


def test_cryptomatte_has_a_picture_for_two_things(scene):
    view_layer = scene.view_layers[0]
    view_layer.use_pass_cryptomatte_object = True
    for levels, pictures in ((2, 1), (6, 3), (16, 8)):
        view_layer.pass_cryptomatte_depth = levels
        assert len(registered(scene, view_layer)) == 1 + pictures


def test_the_sum_of_passes_is_the_picture(scene, all_passes, tmp_path):
    """Colour times light of each kind, and what nothing scattered."""
    _still_life(scene)
    layer = _render(scene, tmp_path)
    total = layer("Emission") + layer("Environment")
    total = total + layer("Volume Direct") + layer("Volume Indirect")
    for lobe in ("Diffuse", "Glossy", "Transmission"):
        total = total + layer(f"{lobe} Color") * (
            layer(f"{lobe} Direct") + layer(f"{lobe} Indirect")
        )
    combined = layer("Combined")[..., :3]
    assert combined.min(axis=2).max() > 0.1
    # Three passes of single precision a kind, and their quotients.
    assert np.allclose(total, combined, rtol=1e-5, atol=1e-6)


def test_mist_is_by_blender_s_formula(scene, tmp_path):
    view_layer = scene.view_layers[0]
    view_layer.use_pass_mist = True
    wall = add_object(quad_mesh(size=10.0))
    wall.location = (0.0, 0.0, -2.0)
    mist = _world(scene).mist_settings
    mist.start, mist.depth, mist.falloff = 1.0, 4.0, "QUADRATIC"
    scene.camera.data.lens = 500.0  # so that all of the wall is two metres away
    assert _render(scene, tmp_path)("Mist") == pytest.approx(0.25**2, rel=1e-2)


def test_cryptomatte_s_names_are_in_the_file(scene, tmp_path):
    view_layer = scene.view_layers[0]
    view_layer.use_pass_cryptomatte_object = True
    wall = add_object(quad_mesh(size=10.0), "Wall é")
    wall.location = (0.0, 0.0, -2.0)
    layer = _render(scene, tmp_path)
    command = ["oiiotool", "--info", "-v", scene.render.filepath]
    facts = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    matte = f"{view_layer.name}.CryptoObject"
    key = f"cryptomatte/{core.module.murmur3_32(matte):08x}"[:19]
    assert f'{key}/name: "{matte}"' in facts
    (manifest,) = re.findall(rf"{key}/manifest: \"(.*)\"\n", facts)
    number = json.loads(manifest.replace('\\"', '"'))["Wall é"]
    assert np.frombuffer(bytes.fromhex(number), ">f4")[0] == np.float32(
        core.module.matte_id("Wall é")
    )
    pixel = layer("CryptoObject00")[0, 0]
    assert pixel[0] == np.float32(core.module.matte_id("Wall é"))
    assert pixel[1] == pytest.approx(1.0)


def test_a_material_writes_out_what_the_view_layer_asks_for(scene, tmp_path):
    view_layer = scene.view_layers[0]
    for name, kind in (("Tone", "COLOR"), ("Weight", "VALUE"), ("Unwritten", "VALUE")):
        aov = view_layer.aovs.add()
        aov.name, aov.type = name, kind
    wall = add_object(quad_mesh(size=10.0))
    wall.location = (0.0, 0.0, -2.0)
    material = emitter((1.0, 1.0, 1.0))
    wall.data.materials.append(material)
    _write_out(material.node_tree, "Tone", Color=(0.25, 0.5, 2.0, 1.0))
    _write_out(material.node_tree, "Weight", Value=0.5)
    _write_out(material.node_tree, "Not asked for", Value=0.5)
    layer = _render(scene, tmp_path)
    assert layer("Tone")[0, 0] == pytest.approx([0.25, 0.5, 2.0, 1.0])
    assert layer("Weight")[0, 0] == pytest.approx(0.5)
    assert layer("Unwritten")[0, 0] == 0.0


def test_what_a_group_writes_out_is_of_each_place_it_stands_at(scene, tmp_path):
    aov = scene.view_layers[0].aovs.add()
    aov.name, aov.type = "Weight", "VALUE"
    wall = add_object(quad_mesh(size=10.0))
    wall.location = (0.0, 0.0, -2.0)
    material = emitter((1.0, 1.0, 1.0))
    wall.data.materials.append(material)
    inner = bpy.data.node_groups.new("Inner", "ShaderNodeTree")
    add_group_socket(inner, "INPUT", "NodeSocketFloat", "Given")
    written = _write_out(inner, "Weight")
    inner.links.new(inner.nodes.new("NodeGroupInput").outputs["Given"], written.inputs["Value"])
    group = material.node_tree.nodes.new("ShaderNodeGroup")
    group.node_tree = inner
    group.inputs["Given"].default_value = 0.75
    assert _render(scene, tmp_path)("Weight")[0, 0] == pytest.approx(0.75)


def test_light_groups_add_up_to_what_is_in_them(scene, tmp_path):
    view_layer = scene.view_layers[0]
    for name in ("objects", "sky"):
        view_layer.lightgroups.add(name=name)
    _still_life(scene)
    scene.world.lightgroup = "sky"
    for shown in scene.objects:
        shown.lightgroup = "objects"
    layer = _render(scene, tmp_path)
    total = layer("Combined_objects") + layer("Combined_sky")
    assert layer("Combined_sky").max() > 0.1
    assert np.allclose(total, layer("Combined")[..., :3], rtol=1e-5, atol=1e-6)


def test_vectors_are_pixels_from_the_frame_before_and_to_the_frame_after(scene, tmp_path):
    scene.view_layers[0].use_pass_vector = True
    wall = _moving_wall(scene)
    vector = _render(scene, tmp_path)("Vector")
    # 36 mm of film for 50 mm of focal length at a distance of two.
    px_per_unit = scene.render.resolution_x / 0.72 / 2.0
    assert vector[0, 0] == pytest.approx(np.array([-0.1, 0.0, -0.3, 0.0]) * px_per_unit, abs=1e-3)
    assert wall.location.x == pytest.approx(0.0)  # and the picture is that of its own frame
    scene.render.use_motion_blur = True
    assert _render(scene, tmp_path)("Vector").max() == 0.0


def test_a_camera_that_goes_along_leaves_no_vectors(scene, tmp_path):
    scene.view_layers[0].use_pass_vector = True
    scene.camera.parent = _moving_wall(scene)
    scene.camera.location.z = 2.0
    assert np.abs(_render(scene, tmp_path)("Vector")).max() < 1e-3


def _moving_wall(scene) -> bpy.types.Object:
    """Ahead of the camera, at frame 5; comes by 0.1 and goes by 0.3 to the right in a frame."""
    wall = add_object(quad_mesh(size=10.0))
    for frame, x in ((4, -0.1), (5, 0.0), (6, 0.3)):
        wall.location = (x, 0.0, -2.0)
        wall.keyframe_insert("location", frame=frame)
    scene.frame_set(5)
    return wall


@pytest.mark.skipif(bpy.app.version >= (4, 0, 0), reason="Cycles has no such pass")
def test_shadows_of_lamps_are_those_of_cycles(scene, tmp_path):
    scene.view_layers[0].use_pass_shadow = True
    wall = add_object(quad_mesh(size=10.0))
    wall.location = (0.0, 0.0, -4.0)
    wall.data.materials.append(node_material())
    surface(wall.data.materials[0], "ShaderNodeBsdfDiffuse")
    cube = add_object(cube_mesh())
    cube.location, cube.scale = (0.0, 0.0, -3.5), (0.3, 0.3, 0.3)
    for x, kind in ((-2.0, "POINT"), (1.5, "AREA")):
        light = bpy.data.lights.new("Lamp", kind)
        light.energy = 100.0
        add_object(light, "Lamp").location = (x, 0.5, 0.0)
    _world(scene).color = (0.2, 0.3, 0.4)
    pictures = {}
    scene.eye_render.samples = scene.cycles.samples = 512
    scene.camera.data.eye_render.model = "PINHOLE"
    scene.cycles.use_adaptive_sampling = scene.cycles.use_denoising = False
    scene.cycles.light_sampling_threshold = 0.0
    for engine in ("CYCLES", "EYE_RENDER"):
        scene.render.engine = engine
        pictures[engine] = _render(scene, tmp_path)("Shadow")
    assert pictures["CYCLES"].min() < 0.6 < 0.9 < pictures["CYCLES"].max()
    assert np.abs(pictures["EYE_RENDER"] - pictures["CYCLES"]).mean() < 0.02


def _write_out(tree: bpy.types.NodeTree, name: str, **value) -> bpy.types.Node:
    node = tree.nodes.new("ShaderNodeOutputAOV")
    if hasattr(node, "aov_name"):
        node.aov_name = name
    else:  # before Blender 4.0
        node.name = name
    for socket, number in value.items():
        node.inputs[socket].default_value = number
    return node


def _world(scene) -> bpy.types.World:
    scene.world = bpy.data.worlds.new("World")
    return scene.world


def _still_life(scene) -> None:
    wall = add_object(quad_mesh(size=10.0))
    wall.location = (0.0, 0.0, -4.0)
    for x, kind in ((-0.6, "ShaderNodeBsdfPrincipled"), (0.6, "ShaderNodeBsdfGlass")):
        mesh = cube_mesh()
        mesh.materials.append(node_material())
        surface(mesh.materials[0], kind)
        box = add_object(mesh)
        box.location, box.scale = (x, 0.0, -2.0), (0.3, 0.3, 0.3)
    lamp = quad_mesh(size=0.4)
    lamp.materials.append(emitter((1.0, 0.5, 0.2)))
    add_object(lamp).location = (0.0, 0.5, -1.5)
    world = _world(scene)
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.2, 0.3, 0.4, 1.0)


def _render(scene, tmp_path) -> Callable[[str], np.ndarray]:
    """What gives the pixels of a pass by its name in the core."""
    path = str(tmp_path / "passes.exr")
    write_multilayer(scene, path)
    scene.render.image_settings.color_depth = "32"
    bpy.ops.render.render(write_still=True)
    rows = {row.name: row for row in passes.enabled(scene.view_layers[0])}
    return lambda name: layer_pixels(path, rows[name].shown, rows[name].channel_ids)
