"""What the README tells people to type works: cheap commands are run, dear ones must exist."""

import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
BUILD = Path(os.environ.get("EYE_BUILD_DIR", ROOT / "build"))
BLENDER = os.environ.get("BLENDER", "blender")

# Where a build is there already.
CHEAP = {"build", "help", "package"}
# What takes minutes, opens a window or runs these tests: only looked up in `run help`.
DEAR = {
    "demo",
    "large",
    "test",
    "blender",
    "cycles",
    "compare",
    "compat",
    "eyes",
    "figures",
    "tradeoff",
}


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", README, re.MULTILINE | re.DOTALL)


def shell_commands() -> list[str]:
    text = "".join(blocks("sh")).replace("\\\n", " ")
    return [re.sub(r"\s+#.*", "", line) for line in text.splitlines()]


def run(command: str) -> str:
    """What the launcher prints."""
    return subprocess.run(
        [ROOT / "run", command], stdout=subprocess.PIPE, text=True, check=True
    ).stdout


def test_run_commands_exist():
    offered = run("help")
    named = set(re.findall(r"\./run ([a-z-]+)", README))
    assert named == CHEAP | DEAR
    assert [name for name in sorted(named) if not re.search(rf"^  {name}\b", offered, re.M)] == []


@pytest.mark.skipif(not (BUILD / "configured").exists(), reason="`run test` builds first")
@pytest.mark.parametrize("command", sorted(CHEAP))
def test_a_cheap_command_runs(command):
    printed = run(command)
    if command == "package":
        assert zipfile.is_zipfile(printed.splitlines()[-1])


def test_presets_exist():
    presets = subprocess.run(
        ["cmake", "--list-presets"], cwd=ROOT, capture_output=True, text=True
    ).stdout
    assert [name for name in ("dev", "asan") if f'"{name}"' not in presets] == []


def test_paths_exist():
    paths = re.findall(r"\]\(([^):]+)\)", README) + ["bindings/eyecore.pyi", "addon/eye_render"]
    assert [path for path in paths if not (ROOT / path).exists()] == []


def test_the_batch_command_renders(tmp_path):
    if "BLENDER_USER_SCRIPTS" not in os.environ:
        pytest.skip("the add-on is not where Blender looks; `run test` sees to that")
    save = """
import os, bpy
bpy.context.scene.render.engine = "EYE_RENDER"
bpy.context.scene.render.resolution_x = bpy.context.scene.render.resolution_y = 32
bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath("scene.blend"))
"""
    subprocess.run(
        [BLENDER, "-b", "--factory-startup", "--addons", "eye_render", "--python-expr", save],
        cwd=tmp_path,
        check=True,
    )
    (batch,) = (command for command in shell_commands() if "--background" in command)
    batch = batch.replace("blender --background", f"'{BLENDER}' --background", 1)
    result = subprocess.run(["sh", "-c", batch], cwd=tmp_path, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr
    assert (tmp_path / "out_0001.exr").exists(), result.stdout
    assert "not available" not in result.stdout + result.stderr, "the add-on is there too late"


def test_the_python_example_runs(tmp_path):
    (example,) = blocks("python")
    result = subprocess.run(
        [sys.executable, "-c", example], cwd=tmp_path, capture_output=True, text=True
    )
    assert result.returncode == 0, result.stderr
    assert result.stdout.splitlines()[-1] == "(128, 128, 4)"
