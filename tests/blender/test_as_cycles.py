"""One lamp or one material at a time, beside Cycles of the same Blender: mean brightness.

Noise of the means is below 0.1 %; the bars leave room for Cycles' own approximations.
"""

import math

import bpy
import numpy as np
import pytest
from mathutils import Matrix
from scenes import add_node, add_object, node_material, quad_mesh, surface
from tools.engines import SET_UP, keep_all_light
from tools.meshes import cube_mesh

LAMP_TOLERANCE = 0.003
MATERIAL_TOLERANCE = 0.005
SUBSURFACE_TOLERANCE = 0.01  # walks are cut off after many flights


@pytest.fixture
def brightness_ratio(scene, render):
    """Renders the scene by both engines; gives Eye Render's mean over Cycles'."""

    def run(samples: int = 256) -> float:
        scene.render.resolution_x = scene.render.resolution_y = 16
        keep_all_light(scene)
        means = {}
        for engine, set_up in SET_UP.items():
            set_up(scene, samples)
            means[engine] = float(render()[..., :3].mean(dtype=np.float64))
        assert means["CYCLES"] > 1e-4, "a black picture compares nothing"
        return means["EYE_RENDER"] / means["CYCLES"]

    return run


@pytest.fixture
def floor(scene):
    """A square of 20 m, 3 m below the camera, seen slantwise; gives it the material."""
    scene.camera.matrix_world = Matrix.Rotation(math.radians(40), 4, "X")
    shown = add_object(quad_mesh(size=20))
    shown.location = (0, 3, -3)

    def dress(material: bpy.types.Material) -> None:
        shown.data.materials.append(material)

    return dress


LAMPS = {
    "point": ("POINT", {"shadow_soft_size": 0.3}),
    "point without extent": ("POINT", {"shadow_soft_size": 0.0}),
    "sun": ("SUN", {"angle": 0.1}),
    "spot": ("SPOT", {"spot_size": 1.2, "spot_blend": 0.3, "shadow_soft_size": 0.1}),
    "square": ("AREA", {"shape": "SQUARE", "size": 0.7}),
    "rectangle": ("AREA", {"shape": "RECTANGLE", "size": 0.7, "size_y": 0.2}),
    "disk": ("AREA", {"shape": "DISK", "size": 0.7}),
    "ellipse": ("AREA", {"shape": "ELLIPSE", "size": 0.7, "size_y": 0.4}),
    "narrow spread": ("AREA", {"shape": "SQUARE", "size": 0.7, "spread": 1.5}),
}


@pytest.mark.parametrize("lamp", LAMPS)
def test_lamp_is_as_bright(floor, brightness_ratio, lamp):
    kind, settings = LAMPS[lamp]
    light = bpy.data.lights.new("Lamp", kind)
    light.energy = 3.0 if kind == "SUN" else 100.0
    for name, value in settings.items():
        setattr(light, name, value)
    shown = add_object(light, "Lamp")
    shown.location = (0.3, 3.0, 0.5)
    shown.rotation_euler = (0.2, 0.1, 0.0)
    material = node_material()
    surface(material, "ShaderNodeBsdfDiffuse")
    floor(material)
    assert brightness_ratio() == pytest.approx(1.0, abs=LAMP_TOLERANCE)


PRINCIPLED = {
    "plastic": {"Roughness": 0.2},
    "rough plastic": {"Roughness": 0.7, "IOR": 1.8},
    "metal": {"Roughness": 0.3, "Metallic": 1.0},
    "half metal": {"Roughness": 0.5, "Metallic": 0.5},
}


@pytest.mark.skipif(
    bpy.app.version < (4, 0, 0), reason="before Blender 4 Principled BSDF layers otherwise"
)
@pytest.mark.parametrize("light", ["world", "sun"])
@pytest.mark.parametrize("look", PRINCIPLED)
def test_principled_is_as_bright(scene, floor, brightness_ratio, look, light):
    material = node_material()
    node = surface(material, "ShaderNodeBsdfPrincipled")
    node.inputs["Base Color"].default_value = (0.5, 0.4, 0.3, 1.0)
    for name, value in PRINCIPLED[look].items():
        node.inputs[name].default_value = value
    floor(material)
    if light == "sun":
        sun = add_object(bpy.data.lights.new("Sun", "SUN"), "Sun")
        sun.data.energy, sun.data.angle = 3.0, 0.2
        sun.rotation_euler = (math.radians(50), 0, 0)
    else:
        scene.world = bpy.data.worlds.new("World")
        scene.world.use_nodes = True
        scene.world.node_tree.nodes.clear()
        background = add_node(scene.world, "ShaderNodeBackground")
        output = add_node(scene.world, "ShaderNodeOutputWorld")
        scene.world.node_tree.links.new(background.outputs[0], output.inputs["Surface"])
        background.inputs["Color"].default_value = (0.7, 0.8, 1.0, 1.0)
    assert brightness_ratio() == pytest.approx(1.0, abs=MATERIAL_TOLERANCE)


SUBSURFACE = bpy.types.ShaderNodeSubsurfaceScattering.bl_rna.properties["falloff"]


@pytest.mark.skipif(
    bpy.app.version < (4, 0, 0), reason="before Blender 4 light enters surfaces otherwise"
)
@pytest.mark.parametrize("anisotropy", [0.0, 0.5, 0.95])
@pytest.mark.parametrize("method", [item.identifier for item in SUBSURFACE.enum_items])
def test_subsurface_scattering_is_as_bright(scene, brightness_ratio, method, anisotropy):
    shown = add_object(cube_mesh(size=4.0), "Cube")
    shown.location = (0.0, 0.0, -6.0)
    scene.camera.data.angle = 0.1  # far from edges, and light goes farther than a pixel
    material = node_material()
    node = surface(material, "ShaderNodeSubsurfaceScattering", falloff=method)
    node.inputs["Color"].default_value = (0.8, 0.5, 0.2, 1.0)
    node.inputs["Radius"].default_value = (1.0, 1.0, 1.0)
    node.inputs["Scale"].default_value = 0.05
    if "Anisotropy" in node.inputs:
        node.inputs["Anisotropy"].default_value = anisotropy
    shown.data.materials.append(material)
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    assert brightness_ratio() == pytest.approx(1.0, abs=SUBSURFACE_TOLERANCE)
