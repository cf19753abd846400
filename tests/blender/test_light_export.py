import math
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from eye_render import core
from eye_render.export.image import ImageTable
from eye_render.export.light import LightTable
from mathutils import Matrix
from scenes import RecordingGraph, RecordingScene, add_node, add_object, link


@pytest.fixture
def export(scene, depsgraph_of):
    """Exports a new lamp of the kind, after `change` has set it up."""

    def run(kind: str, matrix: Matrix | None = None, **settings):
        light = bpy.data.lights.new("Lamp", kind)
        for name, value in settings.items():
            setattr(light, name, value)
        shown = add_object(light, "Lamp")
        shown.matrix_world = matrix or Matrix.Identity(4)
        evaluated = shown.evaluated_get(depsgraph_of())
        (exported,), warnings = exported_lamps(evaluated, evaluated.matrix_world)
        exported.warnings = warnings
        return exported

    return run


def exported_lamps(
    shown: bpy.types.Object, matrix: Matrix, hidden_from: tuple[str, ...] = ()
) -> tuple[list, list[str]]:
    recording, warnings = RecordingScene(), []
    table = LightTable(recording, ImageTable(recording, 1, warnings.append), warnings.append)
    table.add(shown, matrix, hidden_from)
    return recording.lights, warnings


@pytest.fixture
def tree_lamp(scene, export, monkeypatch):
    """A lamp of 10 watts with its nodes in use, and its Emission node."""
    monkeypatch.setattr(core.module, "NodeGraph", RecordingGraph)
    export("POINT", energy=10.0)
    light = bpy.data.lights[0]
    light.use_nodes = True
    emission = next(n for n in light.node_tree.nodes if n.bl_idname == "ShaderNodeEmission")
    return light, emission


def exported_tree(hidden_from: tuple[str, ...] = ()):
    (exported,), warnings = exported_lamps(
        bpy.data.objects["Lamp"], Matrix.Identity(4), hidden_from
    )
    return exported, warnings


def test_colour_is_multiplied_by_energy(export):
    lamp = export("POINT", color=(1.0, 0.5, 0.25), energy=100.0, shadow_soft_size=0.5)
    assert lamp.kind == "POINT"
    assert lamp.color == pytest.approx((100.0, 50.0, 25.0))
    assert lamp.radius == 0.5
    assert lamp.casts_shadow


def test_exposure_doubles_a_stop(export):
    if not hasattr(bpy.types.Light, "exposure"):
        pytest.skip("this Blender's lamps have no exposure")
    assert export("POINT", energy=100.0, exposure=1.0).color[0] == pytest.approx(200.0)


def test_a_sun_has_an_angle(export):
    lamp = export("SUN", angle=0.125, energy=3.0)
    assert (lamp.kind, lamp.angle_rad) == ("SUN", 0.125)
    assert lamp.color == pytest.approx((3.0, 3.0, 3.0))


def test_a_spot_has_a_cone(export):
    lamp = export("SPOT", spot_size=1.0, spot_blend=0.5)
    assert (lamp.kind, lamp.spot_angle_rad, lamp.spot_blend) == ("SPOT", 1.0, 0.5)


@pytest.mark.parametrize(
    ("blender_shape", "shape", "sizes"),
    [
        ("SQUARE", "RECTANGLE", (2.0, 2.0)),
        ("RECTANGLE", "RECTANGLE", (2.0, 3.0)),
        ("DISK", "DISK", (2.0, 2.0)),
        ("ELLIPSE", "DISK", (2.0, 3.0)),
    ],
)
def test_an_area_lamp_has_a_shape_and_two_sizes(export, blender_shape, shape, sizes):
    lamp = export("AREA", shape=blender_shape, size=2.0, size_y=3.0)
    assert (lamp.shape, (lamp.size_x, lamp.size_y)) == (shape, sizes)


def test_scale_stays_in_the_matrix(export):
    matrix = Matrix.Translation((1, 2, 3)) @ Matrix.Diagonal((2, 4, 5, 1))
    lamp = export("AREA", matrix, shape="RECTANGLE", size=1.0, size_y=1.5)
    assert (lamp.size_x, lamp.size_y) == (1.0, 1.5)
    assert np.allclose(lamp.world_from_light, matrix)


def test_a_mirrored_lamp_keeps_its_direction(export):
    turned = Matrix.Rotation(math.radians(30), 4, "X")
    lamp = export("SPOT", turned @ Matrix.Diagonal((-1, 1, 1, 1)))
    assert np.allclose(lamp.world_from_light[:3, 2], turned.col[2][:3], atol=1e-6)


def test_a_lamp_without_nodes_has_no_surface(export):
    lamp = export("POINT")
    if bpy.data.lights[0].use_nodes:
        pytest.skip("this Blender's lamps always use nodes")
    assert not hasattr(lamp, "surface")


def test_a_lamps_tree_is_its_surface(tree_lamp):
    light, emission = tree_lamp
    falloff = add_node(light, "ShaderNodeLightFalloff")
    link(light, falloff.outputs["Constant"], emission.inputs["Strength"])
    exported, warnings = exported_tree()
    node = exported.surface.node
    assert (node.kind, exported.surface.identifier) == ("EMISSION", "Emission")
    assert node.inputs["Strength"].node.kind == "LIGHT_FALLOFF"
    assert exported.color == pytest.approx((10.0, 10.0, 10.0))
    assert warnings == []


def test_a_tree_is_exported_once_for_all_lamps_that_share_it(tree_lamp):
    recording, warnings = RecordingScene(), []
    table = LightTable(recording, ImageTable(recording, 1, print), warnings.append)
    for _ in range(2):
        table.add(bpy.data.objects["Lamp"], Matrix.Identity(4), ())
    first, second = recording.lights
    assert first.surface is second.surface


def test_a_lamp_whose_tree_shines_not_is_left_out(tree_lamp):
    light, emission = tree_lamp
    light.node_tree.nodes.remove(emission)
    assert exported_lamps(bpy.data.objects["Lamp"], Matrix.Identity(4)) == ([], [])


def test_a_shader_that_a_lamp_cannot_have_is_named(tree_lamp):
    light, _ = tree_lamp
    shader = add_node(light, "ShaderNodeEeveeSpecular", name="Specular")
    output = next(n for n in light.node_tree.nodes if n.bl_idname == "ShaderNodeOutputLight")
    link(light, shader.outputs[0], output.inputs["Surface"])
    (warning,) = exported_tree()[1]
    assert "Specular" in warning


PROFILE = "IESNA91\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0 1 1 0\n0 45 90\n0\n300 200 0\n"


def test_a_profile_is_read_from_a_text_or_a_file(tree_lamp, tmp_path):
    light, emission = tree_lamp
    node = add_node(light, "ShaderNodeTexIES")
    link(light, node.outputs["Fac"], emission.inputs["Strength"])
    node.mode = "INTERNAL"
    node.ies = bpy.data.texts.new("profile.ies")
    node.ies.write(PROFILE)
    exported, warnings = exported_tree()
    assert exported.surface.node.inputs["Strength"].node.options["ies"].strip() == PROFILE.strip()
    path = tmp_path / "profile.ies"
    path.write_text(PROFILE)
    node.mode, node.filepath = "EXTERNAL", str(path)
    exported, more = exported_tree()
    assert exported.surface.node.inputs["Strength"].node.options == {"ies": PROFILE}
    assert warnings + more == []


def test_a_profile_is_found_by_the_path_of_another_system(tree_lamp, tmp_path):
    light, emission = tree_lamp
    node = add_node(light, "ShaderNodeTexIES")
    link(light, node.outputs["Fac"], emission.inputs["Strength"])
    (tmp_path / "lamps").mkdir()
    (tmp_path / "lamps" / "profile.ies").write_text(PROFILE)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    node.mode, node.filepath = "EXTERNAL", "//lamps\\profile.ies"
    exported, warnings = exported_tree()
    assert exported.surface.node.inputs["Strength"].node.options == {"ies": PROFILE}
    assert warnings == []


def test_a_missing_profile_is_named_and_shines_as_in_cycles(tree_lamp):
    light, emission = tree_lamp
    node = add_node(light, "ShaderNodeTexIES", name="Downlight")
    node.mode, node.filepath = "EXTERNAL", "/nowhere/profile.ies"
    node.inputs["Strength"].default_value = 0.5
    link(light, node.outputs["Fac"], emission.inputs["Strength"])
    exported, (warning,) = exported_tree()
    product = exported.surface.node.inputs["Strength"].node
    assert (product.kind, product.inputs) == ("MATH", {"Value": 0.5, "Value_001": 100.0})
    assert "Downlight" in warning


def test_a_broken_profile_is_named_with_what_is_wrong(tree_lamp, monkeypatch):
    monkeypatch.undo()  # the core's own graph
    light, emission = tree_lamp
    node = add_node(light, "ShaderNodeTexIES", name="Downlight")
    node.mode, node.ies = "INTERNAL", bpy.data.texts.new("note")
    node.ies.write("not a profile")
    link(light, node.outputs["Fac"], emission.inputs["Strength"])
    table_scene, warnings = core.require().Scene(), []
    table = LightTable(table_scene, ImageTable(table_scene, 1, print), warnings.append)
    table.add(bpy.data.objects["Lamp"], Matrix.Identity(4), ())
    (warning,) = warnings
    assert "Downlight" in warning
    assert "TILT=" in warning


def test_a_lamp_has_its_own_space_where_blender_gives_it_one(export):
    assert export("POINT").has_own_space == (bpy.app.version >= (4, 4, 0))


def test_what_rays_do_not_see_of_a_lamp_goes_along(tree_lamp):
    assert exported_tree(("CAMERA", "DIFFUSE"))[0].hidden_from == ("CAMERA", "DIFFUSE")


def test_a_portal_shines_not(scene, export):
    assert export("AREA").kind == "AREA"
    bpy.data.lights["Lamp"].cycles.is_portal = True
    assert exported_lamps(bpy.data.objects["Lamp"], Matrix.Identity(4)) == ([], [])


def test_a_lamp_throws_shadows_as_for_cycles(scene, export):
    export("POINT")
    light = bpy.data.lights["Lamp"]
    if hasattr(light.cycles, "cast_shadow"):  # before Blender 4.0
        light.cycles.cast_shadow = False
    else:
        light.use_shadow = False
    ((lamp,), _) = exported_lamps(bpy.data.objects["Lamp"], Matrix.Identity(4))
    assert not lamp.casts_shadow


def test_a_lamp_that_the_core_refuses_is_named_and_left_out(scene, export):
    export("POINT", energy=3e38, color=(10.0, 1.0, 1.0))
    core_scene, warnings = core.require().Scene(), []
    table = LightTable(core_scene, ImageTable(core_scene, 1, print), warnings.append)
    table.add(bpy.data.objects["Lamp"], Matrix.Identity(4), ())
    (warning,) = warnings
    assert warning.startswith("Light 'Lamp' is left out: ")


def test_a_lamp_of_a_kind_that_blender_does_not_know_is_named_and_left_out():
    lamp = SimpleNamespace(name="Hemi", type="")  # what Blender 3.4 makes of Collada's ambient
    lamps, (warning,) = exported_lamps(SimpleNamespace(data=lamp), Matrix.Identity(4))
    assert lamps == []
    assert "Hemi" in warning
