"""Files that nobody here made load and render: a part of what tests/models/survey.py visits."""

import sys
from pathlib import Path

import bpy
import pytest

sys.path.append(str(Path(__file__).parents[1] / "models"))
import survey  # noqa: E402

NOTHING_TO_SEE_IN = {".bvh"}  # motion alone
# Refusals that are no test of ours: Blender 5 and big-endian files, Debian's Blender 5 without its
# Draco library, and, in 5's importer, files without their data or without a scene.
UNREADABLE = (
    "Big Endian",
    "libbf_intern_draco_bridge",
    "Missing resource, 'BoxTextured0.bin'",
    "'NoneType' object is not subscriptable",
)


@pytest.fixture(scope="module")
def visits() -> list[survey.Visit]:
    if not survey.packages_are_installed():
        pytest.skip(f"{' or '.join(survey.PACKAGES)} is not installed")
    survey.BLENDER[0] = bpy.app.binary_path
    found = survey.survey(is_quick=True)
    return [
        visit
        for visit in found
        if visit.outcome != "importer refused"
        or not any(reason in visit.detail for reason in UNREADABLE)
    ]


def test_eye_render_fails_on_no_file(visits):
    assert [visit for visit in visits if visit.outcome == "FAILED"] == []


def test_every_blend_file_is_rendered(visits):
    outcomes = {visit.outcome for visit in visits if visit.file.endswith(".blend")}
    assert outcomes == {"rendered"}


def test_every_format_with_faces_is_rendered(visits):
    def endings(outcomes: set[str]) -> set[str]:
        seen = [visit for visit in visits if visit.outcome in outcomes]
        return {Path(visit.file).suffix.lower() for visit in seen}

    refused = {"importer refused", "importer died"}
    assert endings({"rendered"}) >= endings({"rendered", "nothing to see"}) - NOTHING_TO_SEE_IN
    assert endings({"rendered", "nothing to see"}) >= endings(refused)
