"""Renders the .blend and model files of Debian packages, which nobody here made, each in a Blender
of its own, and writes a table of what happened: models.csv and a summary, models.md, in the output
folder. `survey.py --all` takes every file, without it a part that is quick and the same each time.

Its exit status is 1 if Eye Render failed on a file. Files that Blender has no importer for, or
that its importer refuses or dies of, are counted, not held against Eye Render.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

import table

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
OUT = Path(os.environ.get("EYE_OUT_DIR", ROOT / "out"))
BLENDER = [os.environ.get("BLENDER", "blender"), "-b", "--factory-startup"]

PACKAGES = ("assimp-testmodels", "glmark2-data")
FOLDERS = ("/usr/share/assimp/models/", "/usr/share/glmark2/models/")
NOT_A_MODEL = {  # what models refer to, and texts about them
    *(".png", ".jpg", ".jpeg", ".bmp", ".tga", ".bin", ".mtl", ".material"),
    *(".txt", ".md", ".glsl", ".vert", ".frag"),
}
RX = "-2.00DS -0.75DC 160A"  # so that there is a lens to look through
SCRIPT_FAILED = 7  # Blender's exit status when a script of ours raised
TIMEOUT_S = 120
WORKERS = 2
LEAST_PART_SEEN = 0.02  # of the picture, below which sixteen by sixteen rays tell nothing
DIES_WITHOUT_US = "Blender dies of it without the add-on too"

_WARNING = re.compile(r"^Eye Render: warning: (.*)$", re.MULTILINE)


@dataclass(frozen=True)
class Visit:
    """A row of the table."""

    file: str
    importer: str = ""
    outcome: str = ""  # of `table.OUTCOMES`
    detail: str = ""
    triangles: int = 0
    seen: float = 0.0  # the part of the picture in which Blender's own rays hit something
    covered: float = 0.0  # the part of the picture in which Eye Render shows something
    warnings: tuple[str, ...] = ()
    seconds: float = 0.0


def packages_are_installed() -> bool:
    return subprocess.run(["dpkg", "-L", *PACKAGES], capture_output=True).returncode == 0


def model_files() -> list[Path]:
    """All model files of the packages, in a fixed order."""
    listed = subprocess.run(["dpkg", "-L", *PACKAGES], capture_output=True, text=True, check=True)
    paths = [Path(line) for line in listed.stdout.splitlines() if line.startswith(FOLDERS)]
    return sorted(p for p in paths if p.is_file() and p.suffix.lower() not in NOT_A_MODEL)


def importers() -> dict[str, str]:
    """Blender's operator for each ending of a name that it can load."""
    script = str(HERE / "importers.py")
    ran = subprocess.run([*BLENDER, "--python", script], capture_output=True, text=True)
    listed = re.search("^importers: (.*)$", ran.stdout, re.MULTILINE)
    if not listed:
        sys.exit(f"Blender does not tell its importers:\n{ran.stdout}{ran.stderr}")
    return json.loads(listed[1])


def quick_part(files: Iterable[Path], readable: Iterable[str]) -> list[Path]:
    """Every .blend; of each other format the smallest, the middle and the largest file."""
    chosen = []
    for ending in readable:
        ours = sorted((p for p in files if p.suffix.lower() == ending), key=_size_then_name)
        chosen += ours if ending == ".blend" else [ours[0], ours[len(ours) // 2], ours[-1]]
    return sorted(set(chosen))


def _size_then_name(path: Path) -> tuple[int, str]:
    return path.stat().st_size, str(path)


def visit(path: Path, importer: str | None, keep: Path | None = None) -> Visit:
    """Render the file; `keep` is a folder for the picture."""
    found = Visit(file=str(path), importer=importer or "")
    if importer is None:
        return replace(found, outcome="no importer")
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="eye-models-") as folder:
        found = _render(found, path, Path(folder))
        picture = Path(folder) / "0001.exr"
        if keep and picture.exists():
            _convert(picture, keep / f"{path.parent.name}_{path.name}.png")
    return replace(found, seconds=time.monotonic() - start)


def _render(found: Visit, path: Path, folder: Path) -> Visit:
    record_file, picture = folder / "record.json", folder / "0001.exr"
    status, output = _blender(folder, "--addons", "eye_render", path=path)
    record = json.loads(record_file.read_text()) if record_file.exists() else {"stage": "none"}
    found = replace(found, warnings=tuple(_WARNING.findall(output)))
    if record["stage"] == "refused":
        return replace(found, outcome="importer refused", detail=record["why"])
    if record["stage"] == "importing" and status != SCRIPT_FAILED:
        status_without_us, _ = _blender(folder, path=path)
        if status_without_us not in (0, SCRIPT_FAILED):
            return replace(found, outcome="importer died", detail=DIES_WITHOUT_US)
    if record["stage"] != "rendering":
        return replace(found, outcome="FAILED", detail=_last_words(status, output))

    found = replace(found, triangles=record["triangles"], seen=record["seen"])
    if status != 0:
        return replace(found, outcome="FAILED", detail=_last_words(status, output))
    if not picture.exists():
        return replace(found, outcome="FAILED", detail="exit status 0 without a picture")
    return _judge(found, picture)


def _blender(folder: Path, *options: str, path: Path) -> tuple[int, str]:
    """Blender's exit status, and what it said; with the add-on it renders."""
    command = [*BLENDER, *options, "--python-exit-code", str(SCRIPT_FAILED)]
    command += ["--python", str(HERE / "prepare.py")]
    if options:
        command += ["-E", "EYE_RENDER", "-o", f"{folder}/####", "-F", "OPEN_EXR_MULTILAYER"]
        command += ["-x", "1", "-f", "1"]
    command += ["--", str(path), str(folder / "record.json"), "--eye-rx", RX]
    try:
        ended = subprocess.run(
            command,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=TIMEOUT_S,
            text=True,
            errors="replace",
            env={**os.environ, "TMPDIR": str(folder)},  # where Blender leaves its crash reports
        )
    except subprocess.TimeoutExpired as error:
        return -1, f"{(error.output or b'').decode(errors='replace')}\nnot done in {TIMEOUT_S} s"
    return ended.returncode, ended.stdout


def _last_words(status: int, output: str) -> str:
    lines = [line for line in output.splitlines() if line.strip() and "Blender quit" not in line]
    return f"exit status {status}: {' / '.join(lines[-3:])}"


def _judge(found: Visit, picture: Path) -> Visit:
    """Hold the picture to what Blender itself sees."""
    report = _oiiotool("--info", "-v", "--stats", str(picture))
    names = _channels(report)
    not_finite = [
        name
        for kind in ("NanCount", "InfCount")
        for name, count in zip(names, _statistic(report, kind), strict=True)
        if count > 0
    ]
    if not_finite:
        return replace(found, outcome="FAILED", detail=f"not finite: {', '.join(not_finite)}")
    mean = dict(zip(names, _statistic(report, "Avg"), strict=True))
    of_combined = {name[-1]: value for name, value in mean.items() if ".Combined." in name}
    found = replace(found, covered=of_combined["A"])
    if found.seen >= LEAST_PART_SEEN and found.covered < found.seen / 2:
        detail = f"Blender sees geometry in {found.seen:.0%} of the picture"
        return replace(found, outcome="FAILED", detail=f"{detail}, it covers {found.covered:.0%}")
    if found.covered == 0:
        return replace(found, outcome="nothing to see")
    is_black = all(of_combined[channel] == 0 for channel in "RGB")
    return replace(found, outcome="rendered", detail="black" if is_black else "")


def _statistic(report: str, kind: str) -> list[float]:
    values = re.search(rf"Stats {kind}: ([^(\n]*)", report)[1]
    return [float(value) for value in values.split()]


def _convert(picture: Path, png: Path) -> None:
    names = _channels(_oiiotool("--info", "-v", str(picture)))
    shown = [name for name in names if re.search(r"\.Combined\.[RGB]$", name)]
    png.parent.mkdir(parents=True, exist_ok=True)
    to_srgb = ("--colorconvert", "linear", "sRGB")
    _oiiotool(str(picture), "--ch", ",".join(shown), *to_srgb, "-o", str(png))


def _oiiotool(*arguments: str) -> str:
    ran = subprocess.run(["oiiotool", *arguments], capture_output=True, text=True, check=True)
    return ran.stdout


def _channels(report: str) -> list[str]:
    return re.search("channel list: (.*)", report)[1].split(", ")


def survey(is_quick: bool, keep: Path | None = None) -> list[Visit]:
    """Visit the files, and say each failure as it happens."""
    readable = importers()
    files = model_files()
    if is_quick:
        files = quick_part(files, readable)

    def visit_and_say(path: Path) -> Visit:
        found = visit(path, readable.get(path.suffix.lower()), keep)
        if found.outcome == "FAILED":
            print(f"FAILED {path}: {found.detail}", flush=True)
        return found

    with ThreadPoolExecutor(WORKERS) as pool:
        return list(pool.map(visit_and_say, files))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--all", action="store_true", help="every file, not only the quick part")
    parser.add_argument("--keep", type=Path, help="a folder for the pictures, as PNG")
    options = parser.parse_args()
    if not packages_are_installed():
        sys.exit(f"Not installed: {' or '.join(PACKAGES)}")
    visits = survey(not options.all, options.keep)
    OUT.mkdir(parents=True, exist_ok=True)
    table.write_csv(OUT / "models.csv", visits)
    summary = table.summary(visits)
    (OUT / "models.md").write_text(summary)
    print(summary)
    print(OUT / "models.csv")
    sys.exit(any(found.outcome == "FAILED" for found in visits))


if __name__ == "__main__":
    main()
