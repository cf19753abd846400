"""Renders feature scenes in Blender processes, many in each; what is left after a crash goes into
the next."""

import json
import os
import signal
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
BLENDER = os.environ.get("BLENDER", "blender")
SCENE_TIMEOUT_S = 300


def blender_version() -> tuple[int, ...]:
    ran = subprocess.run([BLENDER, "--version"], capture_output=True, text=True, check=True)
    return tuple(int(part) for part in ran.stdout.split()[1].split("."))


@dataclass
class Rendered:
    """What became of one scene."""

    facts: dict  # of features.Feature
    pictures: list[np.ndarray] = field(default_factory=list)  # linear RGBA, one a seed
    error: str = ""
    warnings: list[str] = field(default_factory=list)
    seconds: float = 0.0  # of one render
    peak_mb: float = 0.0


def render_features(
    engine: str,
    glob: str,
    seeds: list[int],
    folder: Path,
    samples: int | None = None,
    only: list[str] | None = None,
) -> dict[str, Rendered]:
    """By name, in the order of the suite. `samples` None: each scene's own."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in (*folder.glob("*.npy"), *folder.glob("*.json*")):
        old.unlink()
    job = {"engine": engine, "glob": glob, "seeds": seeds, "samples": samples, "only": only}
    records: dict[str, dict] = {}
    crashed: dict[str, str] = {}
    while True:
        status = _run({**job, "folder": str(folder)}, folder)
        listed = folder / "features.json"
        if not listed.exists():
            raise SystemExit(f"Blender failed, status {status}; see {folder / 'blender.log'}")
        features = json.loads(listed.read_text())
        wanted = [f["name"] for f in features if only is None or f["name"] in only]
        begun = None
        for line in (folder / "records.jsonl").read_text().splitlines():
            record = json.loads(line)
            if "begin" in record:
                begun = record["begin"]
            else:
                records[record["end"]] = record
                begun = None
        if begun:
            crashed[begun] = f"Blender died, status {status}"
        left = [name for name in wanted if name not in records and name not in crashed]
        if not left or (begun is None and job["only"] == left):
            break
        job["only"] = left
    facts = {f["name"]: f for f in features}
    for name in wanted:
        records.setdefault(name, {"error": crashed.get(name, "not rendered")})
    return {name: _rendered(facts[name], records[name], seeds, folder) for name in wanted}


def _rendered(facts: dict, record: dict, seeds: list[int], folder: Path) -> Rendered:
    result = Rendered(facts)
    for key in ("error", "warnings", "seconds", "peak_mb"):
        setattr(result, key, record.get(key, getattr(result, key)))
    if not result.error:
        stem = facts["name"].replace("/", ".")
        result.pictures = [np.load(folder / f"{stem}.{seed}.npy") for seed in seeds]
    return result


def _run(job: dict, folder: Path) -> int:
    """Blender's exit status; it is ended if a scene takes too long."""
    job_file = folder / "job.json"
    job_file.write_text(json.dumps(job))
    records = folder / "records.jsonl"
    records.unlink(missing_ok=True)
    records.touch()
    command = [BLENDER, "-b", "--factory-startup"]
    if job["engine"] == "EYE_RENDER":
        command += ["--addons", "eye_render"]
    command += ["--python-exit-code", "1", "--python", str(HERE / "render_features.py")]
    with (folder / "blender.log").open("a") as log:
        blender = subprocess.Popen([*command, "--", str(job_file)], stdout=log, stderr=log)
        size, changed = 0, time.monotonic()
        while blender.poll() is None:
            time.sleep(0.05)
            if records.stat().st_size != size:
                size, changed = records.stat().st_size, time.monotonic()
            elif time.monotonic() - changed > SCENE_TIMEOUT_S:
                blender.send_signal(signal.SIGKILL)
    return blender.returncode
