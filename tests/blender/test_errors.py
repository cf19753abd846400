"""No error ever ends in a picture and exit status 0."""

import shutil
from pathlib import Path

import bpy
import numpy as np
import pytest
from eye_render import core
from scenes import add_node, add_object, link, node_material, quad_mesh, surface

MAGENTA = (1.0, 0.0, 1.0)


@pytest.fixture
def scripts_without_module(tmp_path) -> Path:
    """A scripts folder with the add-on and no native module."""
    scripts = tmp_path / "scripts"
    package = Path(core.__file__).resolve().parent
    shutil.copytree(package, scripts / "addons" / "eye_render")
    return scripts


def test_a_missing_module_is_said_in_a_sentence_and_fails_the_render(
    run_blender, picture, scripts_without_module
):
    ended = run_blender(BLENDER_USER_SCRIPTS=str(scripts_without_module))
    output = ended.stdout + ended.stderr
    assert ended.returncode == 1
    assert "native module eyecore is missing" in output
    assert "eye_render/" not in output, "a traceback through the add-on"
    assert not picture.exists()


def test_a_module_for_another_python_is_said_with_both_versions(
    run_blender, picture, scripts_without_module
):
    package = scripts_without_module / "addons" / "eye_render"
    (package / "eyecore.cpython-39-x86_64-linux-gnu.so").touch()
    ended = run_blender(BLENDER_USER_SCRIPTS=str(scripts_without_module))
    output = ended.stdout + ended.stderr
    assert ended.returncode == 1
    assert "built for Python 3.9, but this Blender runs Python 3.1" in output
    assert not picture.exists()


@pytest.mark.parametrize(
    ("script", "sentence"),
    [
        ('camera.eye_render.right.text = "-2.00 -0.75"', "Prescription of the right eye: "),
        ('camera.type = "ORTHO"', "an eye needs a perspective camera"),
        ('camera.type = "PANO"', "an eye needs a perspective camera"),
        ("camera.clip_start, camera.clip_end = 2, 1", "Camera 'Camera': clip"),
    ],
)
def test_what_cannot_be_rendered_exits_with_status_1_and_no_picture(
    run_blender, picture, script, sentence
):
    ended = run_blender(script=script)
    assert ended.returncode == 1
    assert sentence in ended.stdout + ended.stderr
    assert "Traceback" not in ended.stdout + ended.stderr
    assert not picture.exists()


@pytest.mark.parametrize(
    ("error", "sentence"),
    [
        ("KeyError('broken on purpose')", "broken on purpose"),
        ("FileNotFoundError(2, 'No such file', '/gone.txt')", "/gone.txt: No such file"),
    ],
)
def test_an_exception_inside_the_render_exits_with_status_1_and_no_picture(
    run_blender, picture, error, sentence
):
    script = (
        "import eye_render.export\n"
        f"def broken(*_): raise {error}\n"
        "eye_render.export.export_scene = broken\n"
    )
    ended = run_blender(script=script)
    assert ended.returncode == 1
    assert sentence in ended.stdout + ended.stderr
    assert not picture.exists()


def test_a_missing_texture_is_magenta_and_is_named(scene, render, tmp_path, capfd):
    image = bpy.data.images.new("gone", 4, 4)
    image.filepath_raw = str(tmp_path / "gone.png")
    image.source = "FILE"
    material = node_material()
    texture = add_node(material, "ShaderNodeTexImage", image=image)
    glow = surface(material, "ShaderNodeEmission")
    link(material, texture.outputs["Color"], glow.inputs["Color"])
    wall = quad_mesh(size=10.0)
    wall.materials.append(material)
    add_object(wall).location.z = -2.0

    pixels = render()
    assert np.allclose(pixels[..., :3], MAGENTA, atol=1e-4)
    said = [line for line in capfd.readouterr().out.splitlines() if "gone.png" in line]
    assert len(said) == 1
    assert "shows magenta" in said[0]
