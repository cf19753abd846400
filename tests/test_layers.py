"""The layers of the core, read from its includes: arrows point down, and each third-party library
has one door."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]

MAY_INCLUDE = {
    "base": set(),
    "optics": {"base"},
    "shading": {"base"},
    "eye": {"optics", "base"},
    "scene": {"shading", "base"},
    "analysis": {"eye", "optics", "base"},
    "render": {"eye", "scene", "optics", "shading", "base"},
    "api": {"render", "analysis", "eye", "scene", "optics", "shading", "base"},
}

# Who may name a third-party header. embree.h is the one file that knows Embree's version; the
# acceleration structure reaches Embree through it.
DOORS = {
    "boost": {"core/optics/root.h"},
    "embree": {"core/scene/embree.h"},
    "OpenImageIO": {"core/scene/texture_cache.cpp"},
    "pybind11": {"bindings/*"},
    "Python.h": set(),
}

CORE = sorted([*ROOT.glob("core/**/*.h"), *ROOT.glob("core/**/*.cpp")])
BINDINGS = sorted([*ROOT.glob("bindings/**/*.h"), *ROOT.glob("bindings/**/*.cpp")])
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def name_of(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def each(paths: list[Path]):
    return pytest.mark.parametrize("path", paths, ids=[name_of(path) for path in paths])


def includes_of(path: Path) -> list[str]:
    return INCLUDE.findall(path.read_text(encoding="utf-8"))


def upward_includes(layer: str, includes: list[str]) -> list[str]:
    allowed = MAY_INCLUDE[layer] | {layer}
    layers = [(include, include.split("/")[0]) for include in includes]
    return [include for include, other in layers if other in MAY_INCLUDE and other not in allowed]


def foreign_includes(name: str, includes: list[str]) -> list[str]:
    return [
        include
        for include in includes
        for library, doors in DOORS.items()
        if include.split("/")[0].startswith(library)
        and not any(Path(name).match(door) for door in doors)
    ]


def test_every_layer_is_known():
    assert {path.name for path in (ROOT / "core").iterdir() if path.is_dir()} <= set(MAY_INCLUDE)


@each(CORE)
def test_core_includes_point_downward(path):
    layer = path.relative_to(ROOT / "core").parts[0]
    assert upward_includes(layer, includes_of(path)) == []


@each(CORE)
def test_core_includes_are_written_from_core(path):
    own = [
        include for include in includes_of(path) if include.endswith(".h") and "/" not in include
    ]
    assert [include for include in own if (path.parent / include).exists()] == []


@each(BINDINGS)
def test_bindings_include_the_api_alone(path):
    layers = [include for include in includes_of(path) if include.split("/")[0] in MAY_INCLUDE]
    assert [include for include in layers if not include.startswith("api/")] == []


@each(CORE + BINDINGS)
def test_third_party_headers_stay_behind_their_door(path):
    assert foreign_includes(name_of(path), includes_of(path)) == []


def test_an_upward_arrow_would_be_found():
    assert upward_includes("eye", ["optics/power_matrix.h", "scene/mesh.h"]) == ["scene/mesh.h"]
    assert upward_includes("scene", ["eye/eye_model.h"]) == ["eye/eye_model.h"]
    assert foreign_includes("core/render/film.cpp", ["embree4/rtcore.h"]) == ["embree4/rtcore.h"]
    assert foreign_includes("core/scene/mesh.cpp", ["OpenImageIO/texture.h"]) != []
    assert foreign_includes("bindings/module.cpp", ["pybind11/numpy.h"]) == []
