"""Files that others made, each rendered by Cycles and by Eye Render of the same Blender, an engine
a process, so that time and memory are each one's own."""

import argparse
import json
import math
import os
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
from blender_batch import BLENDER
from deviations import FLIP_MARGIN
from measure import measure
from page import FAILED, NOT_IMPORTABLE, PASSED, Cost, Row, line_of

HERE = Path(__file__).resolve().parent
MODELS = HERE.parent / "models"
sys.path.append(str(MODELS))
from survey import importers  # noqa: E402

PREPARE = MODELS / "prepare.py"  # imports models, and gives them camera and light
ENGINES = ("CYCLES", "EYE_RENDER")
SEEDS = [1, 2]
TIMEOUT_S = 1800
SCRIPT_FAILED = 1  # Blender's exit status when a script of ours raised


def compare_files(options: argparse.Namespace, scratch: Path) -> list[Row]:
    files = options.files
    if options.library:
        files = [scene for library in files for scene in _scenes_of(library, scratch)]
    endings = {path.suffix.lower() for path in files}
    readable = set() if endings == {".blend"} else set(importers())
    rows = []
    for number, path in enumerate(files):
        folder = scratch / str(number)
        folder.mkdir()
        row = Row(path.name, str(path.resolve()), FAILED, FLIP_MARGIN)
        if path.suffix.lower() in readable | {".blend"}:
            compare_file(path.resolve(), options, folder, row)
        else:
            row.outcome, row.reason = NOT_IMPORTABLE, "no importer for its kind"
        print(f"{number + 1}/{len(files)} {path}: {line_of(row)}", flush=True)
        rows.append(row)
    return rows


def _scenes_of(library: Path, scratch: Path) -> list[Path]:
    """A file for each material."""
    folder = scratch / f"library-{library.stem}"
    folder.mkdir()
    command = [BLENDER, "-b", "--factory-startup", "--python-exit-code", "1"]
    command += ["--python", str(HERE / "dress_library.py"), "--", str(library.resolve())]
    ran = subprocess.run([*command, str(folder)], capture_output=True, text=True)
    if ran.returncode:
        raise SystemExit(f"Blender failed on {library}:\n{ran.stdout[-2000:]}{ran.stderr[-2000:]}")
    return sorted(folder.glob("*.blend"))


class NotImportableError(Exception):
    """Blender's importer refuses the file, or dies of it."""


def compare_file(path: Path, options: argparse.Namespace, folder: Path, row: Row) -> None:
    """Fills in the row."""
    pictures: dict[str, list[np.ndarray]] = {}
    for engine in ENGINES:
        job = {"engine": engine, "samples": options.samples or 256, "bounces": options.bounces}
        job |= {"size": options.size, "seeds": SEEDS, "folder": str(folder)}
        try:
            found, peak_mb = _render(path, job, folder)
        except NotImportableError as error:
            row.outcome, row.reason = NOT_IMPORTABLE, str(error)
            return
        except RuntimeError as error:
            row.reason = f"{engine}: {error}"
            return
        cost = Cost(found["seconds"], peak_mb)
        if engine == "CYCLES":
            row.cycles = cost
        else:
            row.eye_render, row.warnings = cost, found["warnings"]
        pictures[engine] = [np.load(folder / f"{engine}.{seed}.npy")[..., :3] for seed in SEEDS]
    reference, ours = (np.mean(pictures[engine], axis=0) for engine in ENGINES)
    row.pictures = (reference, ours)
    row.noise = noise_of_means(*pictures["CYCLES"])
    row.difference = measure(reference, ours)
    row.threshold = round(FLIP_MARGIN + row.noise, 4)
    figure = row.difference.figure()
    row.outcome = PASSED if figure <= row.threshold else FAILED
    row.reason = "" if row.outcome == PASSED else f"more than {row.threshold}"


def noise_of_means(first: np.ndarray, second: np.ndarray) -> float:
    """The figure that noise alone gives means of two pictures, if ours are as noisy as these two
    of Cycles; more noise of ours is our fault. Such means are nearer to each other than these two
    by the square root of two, of whose power 0.7 FLIP is made (Andersson et al. 2020)."""
    return measure(first, second).figure() * math.sqrt(0.5) ** 0.7


def _render(path: Path, job: dict, folder: Path) -> tuple[dict, float]:
    """What Blender found, and the most memory that it had."""
    job_file, log = folder / "job.json", folder / f"{job['engine']}.log"
    job_file.write_text(json.dumps(job))
    record_file = folder / "record.json"  # of PREPARE
    for old in (folder / "found.json", record_file):
        old.unlink(missing_ok=True)
    command = [BLENDER, "-b", "--factory-startup", "--addons", "eye_render"]
    command += ["--python-exit-code", str(SCRIPT_FAILED)]
    if path.suffix == ".blend":
        command += [str(path)]
    else:
        command += ["--python", str(PREPARE)]
    command += ["--python", str(HERE / "render_file.py"), "--"]
    command += [str(path), str(record_file), str(job_file)]
    with log.open("w") as output:
        blender = subprocess.Popen(command, stdout=output, stderr=output)
        timer = threading.Timer(TIMEOUT_S, blender.kill)
        timer.start()
        # Not Popen.wait, which does not tell how much memory the process had.
        _, status, usage = os.wait4(blender.pid, 0)
        blender.returncode = os.waitstatus_to_exitcode(status)
        is_late = not timer.is_alive()
        timer.cancel()
    if is_late:
        raise RuntimeError(f"not done in {TIMEOUT_S} s")
    record = json.loads(record_file.read_text()) if record_file.exists() else {"stage": ""}
    if record["stage"] == "refused":
        raise NotImportableError(record["why"])
    if record["stage"] == "importing" and blender.returncode != SCRIPT_FAILED:
        raise NotImportableError(f"its importer dies, status {blender.returncode}")
    if status or not (folder / "found.json").exists():
        lines = [line for line in log.read_text(errors="replace").splitlines() if line.strip()]
        raise RuntimeError(f"exit status {blender.returncode}: {' / '.join(lines[-3:])}")
    return json.loads((folder / "found.json").read_text()), usage.ru_maxrss / 1024
