"""The launcher's own promises, and the package that it makes."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
BUILD = Path(os.environ.get("EYE_BUILD_DIR", ROOT / "build"))
BLENDER = os.environ.get("BLENDER", "blender")

INSTALL_AND_RENDER = """
import os, sys, bpy
if bpy.app.version < (4, 2, 0):
    bpy.ops.preferences.addon_install(filepath=sys.argv[-1])
    module = "eye_render"
else:
    bpy.ops.extensions.package_install_files(filepath=sys.argv[-1], repo="user_default")
    module = "bl_ext.user_default.eye_render"
bpy.ops.preferences.addon_enable(module=module)
import eyecore
print("module:" + eyecore.__file__, flush=True)
scene = bpy.context.scene
scene.render.engine = "EYE_RENDER"
scene.render.resolution_x = scene.render.resolution_y = 8
scene.render.filepath = os.path.join(os.path.dirname(sys.argv[-1]), "picture.png")
bpy.ops.render.render(write_still=True)
"""


def run(*command, **options) -> subprocess.CompletedProcess:
    return subprocess.run(command, capture_output=True, text=True, **options)


def test_help_lists_every_command(tmp_path):
    """From another directory, and through a link."""
    (tmp_path / "link").symlink_to(ROOT / "run")
    listed = run(tmp_path / "link", "help", cwd=tmp_path)
    assert listed.returncode == 0
    cases = re.search(r"^case \$command in$(.*)^esac", (ROOT / "run").read_text(), re.M | re.S)
    commands = re.findall(r"^    ([a-z-]+)[ |)]", cases.group(1), re.M)
    assert "demo" in commands
    assert [name for name in commands if not re.search(rf"^  {name}\b", listed.stdout, re.M)] == []


def test_an_unknown_command_fails_and_says_so():
    result = run(ROOT / "run", "dmeo")
    assert result.returncode == 1
    assert "no command 'dmeo'" in result.stderr


# Stand-ins that leave a line for each call in $CALLS.
BUILD_TOOLS = {
    "dpkg-query": "echo installed",
    "blender": """case "$*" in
        --version) echo "Blender $BLENDER_VERSION" ;;
        *) echo "eye-render-python:$PYTHON" ;;
    esac""",
    "cmake": """case $1 in
        --build) echo build >>"$CALLS" ;;
        *) mkdir -p "$EYE_BUILD_DIR/release"
            : >"$EYE_BUILD_DIR/release/build.ninja"
            echo "configure $*" >>"$CALLS" ;;
    esac""",
}


class Bench:
    """The launcher among the stand-ins, with a build folder of its own."""

    def __init__(self, folder: Path):
        (folder / "bin").mkdir()
        for name, script in BUILD_TOOLS.items():
            (folder / "bin" / name).write_text(f"#!/bin/sh\n{script}\n")
            (folder / "bin" / name).chmod(0o755)
        self.folder, self.build_folder = folder, folder / "build"
        self.change_blender("3.4.1", "python3.11")

    def change_blender(self, version: str, python: str) -> None:
        path = self.folder / python
        path.symlink_to(sys.executable)
        self.environment = os.environ | {
            "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}",
            "CALLS": str(self.folder / "calls"),
            "EYE_BUILD_DIR": str(self.build_folder),
            "BLENDER": "blender",
            "BLENDER_VERSION": version,
            "PYTHON": str(path),
        }

    def build(self) -> list[str]:
        """What CMake is called for."""
        calls = self.folder / "calls"
        calls.unlink(missing_ok=True)
        result = run(ROOT / "run", "build", env=self.environment)
        assert result.returncode == 0, result.stdout + result.stderr
        return calls.read_text().splitlines()


@pytest.fixture
def bench(tmp_path) -> Bench:
    return Bench(tmp_path)


def test_it_is_configured_once(bench):
    first, second = bench.build()
    assert first.startswith("configure ") and second == "build"
    assert bench.build() == ["build"]


def test_it_is_configured_again_when_its_folder_is_gone(bench):
    bench.build()
    shutil.rmtree(bench.build_folder / "release")
    assert bench.build()[0].startswith("configure ")


def test_another_blender_of_the_same_name_is_asked_for_its_python(bench):
    bench.build()
    bench.change_blender("4.3.2", "python3.13")
    assert "python3.13" in bench.build()[0]


def test_no_module_leaves_no_link_behind(bench):
    modules = bench.build_folder / "blender/scripts/addons/modules"
    run(ROOT / "run", "blender", "--version", env=bench.environment)
    assert list(modules.iterdir()) == []


def test_the_package_installs_and_renders_in_a_blender_without_settings(tmp_path):
    environment = {
        key: value
        for key, value in os.environ.items()
        if not key.startswith("BLENDER_USER_") and key != "PYTHONPATH"
    }
    environment |= {
        "HOME": str(tmp_path),
        "BLENDER_USER_CONFIG": str(tmp_path / "config"),
        "BLENDER_USER_SCRIPTS": str(tmp_path / "scripts"),
        "BLENDER_USER_EXTENSIONS": str(tmp_path / "extensions"),
        "BLENDER_USER_RESOURCES": str(tmp_path),
    }
    made = run(sys.executable, ROOT / "tests/package.py")
    assert made.returncode == 0, made.stderr
    package = tmp_path / "eye_render.zip"
    shutil.copy(made.stdout.strip(), package)
    command = [BLENDER, "-b", "--factory-startup", "--python-exit-code", "1"]
    command += ["--python-expr", INSTALL_AND_RENDER, "--", str(package)]
    result = run(*command, env=environment)
    assert result.returncode == 0, result.stdout + result.stderr
    assert (tmp_path / "picture.png").exists()
    loaded_from = re.search(r"module:(.+)", result.stdout).group(1)
    assert loaded_from.startswith(str(tmp_path)), loaded_from
