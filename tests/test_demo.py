"""The demo hall is what its description says, in whatever Blender this is."""

import json
import math
import os
import subprocess
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
BLENDER = os.environ.get("BLENDER", "blender")

# Prints what the test asks about. Distances are along the view, from the eye at the origin.
INSPECT = """
import bpy, json
eye = bpy.context.scene.camera
triangles = 0
letters = []
for instance in bpy.context.evaluated_depsgraph_get().object_instances:
    thing = instance.object
    if thing.type == "MESH":
        thing.data.calc_loop_triangles()
        triangles += len(thing.data.loop_triangles)
    elif thing.type == "FONT":
        letters.append((thing.data.body, thing.matrix_world.translation.y, thing.dimensions.y))
shaders = {node.bl_idname for material in bpy.data.materials
           for node in material.node_tree.nodes}
depth_m = [corner[1] for corner in bpy.data.objects["floor"].bound_box]
print("\\nfound:" + json.dumps({
    "triangles": triangles, "letters": letters, "shaders": sorted(shaders),
    "depth_m": max(depth_m) - min(depth_m), "lights": sorted({l.type for l in bpy.data.lights}),
    "images": sum(1 for image in bpy.data.images if image.packed_file),
    "eye_height_m": eye.location.z}), flush=True)
"""

BASIC_SURFACES = {
    "ShaderNodeBsdfDiffuse",
    "ShaderNodeBsdfGlossy",
    "ShaderNodeBsdfAnisotropic",  # Glossy's name since Blender 4
    "ShaderNodeBsdfGlass",
    "ShaderNodeEmission",
}


def make(folder: Path, variant: str) -> dict:
    scene = folder / f"{variant}.blend"
    script = ROOT / "tests/demo/make_scene.py"
    command = [BLENDER, "-b", "--factory-startup", "--python-exit-code", "1"]
    command += ["--python", str(script), "--python-expr", INSPECT, "--", str(scene), variant]
    start = time.monotonic()
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr
    assert scene.exists()
    (found,) = (line for line in result.stdout.splitlines() if line.startswith("found:"))
    return json.loads(found.removeprefix("found:")) | {"seconds": time.monotonic() - start}


@pytest.fixture(scope="module")
def hall(tmp_path_factory):
    return make(tmp_path_factory.mktemp("hall"), "principled")


def test_the_hall_is_deep_and_detailed(hall):
    assert hall["depth_m"] == pytest.approx(40)
    assert 0.9e6 < hall["triangles"] < 1.5e6
    assert hall["images"] >= 6
    assert hall["lights"] == ["AREA", "POINT", "SPOT", "SUN"]


def test_the_hall_is_built_in_seconds(hall):
    assert hall["seconds"] < 20


@pytest.mark.parametrize("distance_m", [0.4, 1.0, 3.0, 10.0, 30.0])
def test_letters_of_every_chart_subtend_the_same_angles(hall, distance_m):
    arcmin = sorted(
        60 * math.degrees(math.atan(height_m / y_m))
        for body, y_m, height_m in hall["letters"]
        if body in "NKHZ" and y_m == pytest.approx(distance_m, rel=0.01)
    )
    # N, K, H and Z have straight tops, so they are exactly as high as their row's letters: rows of
    # 100, 70, (none of them in 50,) 35 and 25 arcmin.
    assert arcmin == pytest.approx([25, 35, 35, 35, 70, 70, 100, 100], rel=0.02)


def test_the_basic_hall_has_one_basic_surface_a_material(tmp_path):
    surfaces = {name for name in make(tmp_path, "basic")["shaders"] if "Bsdf" in name}
    assert surfaces <= BASIC_SURFACES
