"""Shared by the tests inside Blender: an empty scene, small renders, and Blender run anew."""

import os
import subprocess
from pathlib import Path

import bpy
import numpy as np
import pytest
from eye_render.cryptomatte import MatteNames
from eye_render.export.image import ImageTable
from eye_render.export.instances import export_instances
from eye_render.export.light import LightTable
from eye_render.export.material import MaterialTable
from scenes import RecordingScene, add_camera

BLENDER_TIMEOUT_S = 60


@pytest.fixture
def scene():
    """An empty scene with a camera at the origin that looks along -Z, black world, 16x8 pixels."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "EYE_RENDER"
    scene.render.resolution_x = 16
    scene.render.resolution_y = 8
    scene.eye_render.quality = "CUSTOM"
    scene.eye_render.samples = 4
    scene.camera = add_camera()
    return scene


@pytest.fixture
def depsgraph_of():
    """Gives the evaluated dependency graph of what is in the scene now."""

    def evaluate() -> bpy.types.Depsgraph:
        bpy.context.view_layer.update()
        return bpy.context.evaluated_depsgraph_get()

    return evaluate


@pytest.fixture
def export(depsgraph_of):
    """Exports the scene; gives the recording, with the warnings as `.warnings`."""

    def run() -> RecordingScene:
        core_scene = RecordingScene()
        core_scene.warnings = []
        warn = core_scene.warnings.append
        images = ImageTable(core_scene, 1, warn)
        materials = MaterialTable(core_scene, images, None, warn)
        lights = LightTable(core_scene, images, warn)
        names = MatteNames(set(), set(), set())
        export_instances(core_scene, depsgraph_of(), materials, lights, names, warn, lambda: None)
        return core_scene

    return run


@pytest.fixture
def render(scene, tmp_path):
    """Gives the combined picture, (height, width, 4), rows bottom-up; raises RuntimeError."""

    def run() -> np.ndarray:
        scene.render.image_settings.file_format = "OPEN_EXR"
        scene.render.image_settings.color_depth = "32"
        scene.render.filepath = str(tmp_path / "picture.exr")
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(scene.render.filepath)
        pixels = np.empty((image.size[1], image.size[0], 4), np.float32)
        image.pixels.foreach_get(pixels.ravel())
        bpy.data.images.remove(image)
        return pixels

    return run


@pytest.fixture
def run_blender(tmp_path):
    """Runs another Blender in the background; the picture, if any, is `tmp_path`/out_0001.exr."""

    def run(*arguments: str, script: str = "", **environment: str) -> subprocess.CompletedProcess:
        setup = tmp_path / "setup.py"
        setup.write_text(f"import bpy\nscene = bpy.context.scene\n{SMALL}{script}")
        command = [
            bpy.app.binary_path,
            *("-b", "--factory-startup", "--addons", "eye_render", "--python-exit-code", "7"),
            *("--python", str(setup), "-E", "EYE_RENDER"),
            *("-o", str(tmp_path / "out_####"), "-F", "OPEN_EXR", "-f", "1", *arguments),
        ]
        return subprocess.run(
            command,
            env={**os.environ, **environment},
            capture_output=True,
            text=True,
            timeout=BLENDER_TIMEOUT_S,
        )

    return run


SMALL = """
scene.render.resolution_x, scene.render.resolution_y = 16, 8
scene.eye_render.quality = "DRAFT"
camera = scene.camera.data
"""


@pytest.fixture
def picture(tmp_path) -> Path:
    """Where `run_blender` puts its picture."""
    return tmp_path / "out_0001.exr"
