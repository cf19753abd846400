import math
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from eye_render.export.light import export_light
from mathutils import Matrix
from scenes import RecordingScene, add_node, add_object, link


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
        recording, warnings = RecordingScene(), []
        export_light(recording, evaluated, evaluated.matrix_world, warnings.append)
        (exported,) = recording.lights
        exported.warnings = warnings
        return exported

    return run


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


def test_scale_goes_into_the_sizes_and_out_of_the_matrix(export):
    matrix = Matrix.Translation((1, 2, 3)) @ Matrix.Diagonal((2, 4, 5, 1))
    lamp = export("AREA", matrix, shape="RECTANGLE", size=1.0, size_y=1.0)
    assert (lamp.size_x, lamp.size_y) == pytest.approx((2.0, 4.0))
    assert np.allclose(lamp.world_from_light, Matrix.Translation((1, 2, 3)))


def test_a_mirrored_lamp_keeps_its_direction(export):
    turned = Matrix.Rotation(math.radians(30), 4, "X")
    lamp = export("SPOT", turned @ Matrix.Diagonal((-1, 1, 1, 1)))
    assert np.allclose(lamp.world_from_light[:3, 2], turned.col[2][:3], atol=1e-6)


def test_a_lamps_emission_node_multiplies_its_colour(scene, export):
    plain = export("POINT", energy=10.0).color
    light = bpy.data.lights[0]
    light.use_nodes = True
    emission = next(n for n in light.node_tree.nodes if n.bl_idname == "ShaderNodeEmission")
    emission.inputs["Color"].default_value = (1.0, 0.5, 0.0, 1.0)
    emission.inputs["Strength"].default_value = 2.0
    recording = RecordingScene()
    export_light(recording, bpy.data.objects["Lamp"], Matrix.Identity(4), print)
    assert recording.lights[0].color == pytest.approx((plain[0] * 2, plain[1], 0.0))


def test_a_node_that_a_lamp_cannot_show_is_named(scene, export):
    plain = export("POINT", energy=10.0).color
    light = bpy.data.lights[0]
    light.use_nodes = True
    emission = next(n for n in light.node_tree.nodes if n.bl_idname == "ShaderNodeEmission")
    emission.inputs["Strength"].default_value = 2.0
    falloff = add_node(light, "ShaderNodeLightFalloff", name="Even")
    link(light, falloff.outputs["Constant"], emission.inputs["Strength"])
    recording, warnings = RecordingScene(), []
    export_light(recording, bpy.data.objects["Lamp"], Matrix.Identity(4), warnings.append)
    assert recording.lights[0].color == pytest.approx(tuple(2.0 * c for c in plain))
    (warning,) = warnings
    assert "Even" in warning


def test_a_lamp_of_a_kind_that_blender_does_not_know_is_named_and_left_out():
    lamp = SimpleNamespace(name="Hemi", type="")  # what Blender 3.4 makes of Collada's ambient
    recording, warnings = RecordingScene(), []
    export_light(recording, SimpleNamespace(data=lamp), Matrix.Identity(4), warnings.append)
    assert recording.lights == []
    (warning,) = warnings
    assert "Hemi" in warning
