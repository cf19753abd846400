"""The source is formatted and linted: clang-format, clang-tidy, ruff, shellcheck. A tool that is
not here, or not in the version its configuration is written for, is skipped by name."""

import hashlib
import os
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
BUILD = Path(os.environ.get("EYE_BUILD_DIR", ROOT / "build"))
CLANG_VERSION = 14

HEADERS = sorted(path for folder in ("core", "bindings") for path in ROOT.glob(f"{folder}/**/*.h"))
SOURCES = sorted(
    path for folder in ("core", "bindings") for path in ROOT.glob(f"{folder}/**/*.cpp")
)
TESTS = sorted([*ROOT.glob("tests/**/*.h"), *ROOT.glob("tests/**/*.cpp")])
SHELL = [ROOT / "run", ROOT / ".ci/run", *sorted(ROOT.glob("tests/**/*.sh"))]


def tool(name: str) -> str:
    path = shutil.which(name)
    if path is None:
        pytest.skip(f"{name} is not installed")
    return path


def clang_tool(name: str) -> str:
    path = tool(name)
    text = subprocess.run([path, "--version"], capture_output=True, text=True, check=True).stdout
    version = int(re.search(r"version (\d+)", text).group(1))
    if version != CLANG_VERSION:
        pytest.skip(f"{name} is version {version}; the configuration is for {CLANG_VERSION}")
    return path


def complaints_of(*command: str | Path) -> str:
    result = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
    return result.stdout + result.stderr if result.returncode else ""


def test_cpp_is_formatted():
    assert (
        complaints_of(
            clang_tool("clang-format"), "--dry-run", "--Werror", *HEADERS, *SOURCES, *TESTS
        )
        == ""
    )


def test_cpp_is_tidy():
    """Slow the first time; afterwards only what changed, headers counting for every source."""
    clang_tidy = clang_tool("clang-tidy")
    database = BUILD / "release"
    if not (database / "compile_commands.json").exists():
        pytest.skip("no compile_commands.json; `run test` makes it")
    stamps = BUILD / "tidy"
    stamps.mkdir(parents=True, exist_ok=True)
    shared = b"".join(path.read_bytes() for path in [ROOT / ".clang-tidy", *HEADERS])

    def check(source: Path) -> str:
        digest = hashlib.sha256(shared + source.read_bytes()).hexdigest()
        stamp = stamps / source.relative_to(ROOT).as_posix().replace("/", "_")
        if stamp.exists() and stamp.read_text() == digest:
            return ""
        found = complaints_of(clang_tidy, "--quiet", "-p", database, source)
        if not found:
            stamp.write_text(digest)
        return found

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        assert "".join(pool.map(check, SOURCES)) == ""


def test_python_is_linted():
    ruff = BUILD / "lint/bin/ruff"
    if not ruff.exists():
        pytest.skip("ruff is not installed; `run test` installs it if it can")
    assert complaints_of(ruff, "check", "--no-cache", "--quiet", ROOT) == ""
    assert complaints_of(ruff, "format", "--no-cache", "--check", "--quiet", ROOT) == ""


def test_shell_scripts_are_checked():
    assert complaints_of(tool("shellcheck"), *SHELL) == ""
