"""Runs Blender for the programs that render pictures, and has it build the demo hall."""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("EYE_BUILD_DIR", ROOT / "build"))
OUT = Path(os.environ.get("EYE_OUT_DIR", ROOT / "out"))
BLENDER = [os.environ.get("BLENDER", "blender"), "-b", "--factory-startup"]
DEMO = ROOT / "tests/demo"


def is_newer(made: Path, made_from: list[Path]) -> bool:
    """Whether `made` need not be made again."""
    if not made.exists():
        return False
    return made.stat().st_mtime >= max(path.stat().st_mtime for path in made_from)


def run_blender(*arguments: str, on_line: Callable[[str], None] = lambda line: None) -> None:
    """Ends this program with Blender's last lines if Blender fails."""
    lines = []
    with subprocess.Popen(
        [*BLENDER, "--python-exit-code", "1", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    ) as blender:
        for line in blender.stdout:
            lines.append(line)
            on_line(line)
    if blender.returncode:
        sys.exit("".join([*lines[-20:], f"\nBlender failed, status {blender.returncode}"]))


def make_hall(variant: str) -> Path:
    """The demo hall in the materials `principled` or `basic`, built if it is not there yet."""
    scene = BUILD / "demo" / f"hall_{variant}.blend"
    script = DEMO / "make_scene.py"
    if not is_newer(scene, [script, *(DEMO / "hall").glob("*.py")]):
        start = time.monotonic()
        print(f"Building the hall ({variant})", end=" ", flush=True)
        scene.parent.mkdir(parents=True, exist_ok=True)
        run_blender("--python", str(script), "--", str(scene), variant)
        print(f"{time.monotonic() - start:.0f} s")
    return scene
