"""Makes the reference pictures: every feature scene by Cycles of Blender 4.3, in four batches of
other seeds, with more samples until one half of them looks like the other. Where Blender is
another, in a folder of Debian trixie:

run compat trixie references

They go into the output folder (in trixie's: var/tmp/eye_render/out/references), to be copied to
tests/compare/references.
"""

import argparse
import os
import sys
import tempfile
from pathlib import Path

import numpy as np
from blender_batch import blender_version, render_features
from picture import as_seen
from references import of_batches, path_of, save

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tools.flip import mean_flip  # noqa: E402

OUT = Path(os.environ.get("EYE_OUT_DIR", Path(__file__).resolve().parents[2] / "out"))
SEEDS = [1, 2, 3, 4]
SAMPLES = (64, 256, 1024)  # of a batch, until the halves agree
AGREEMENT = 0.012  # mean FLIP of half against half; the mean of both is closer to the truth
VERSION = (4, 3)


def main() -> None:
    parser = argparse.ArgumentParser(prog="run references")
    parser.add_argument("--scenes", default="*", help="names to make, as FAMILY/NAME (default *)")
    arguments = parser.parse_args()
    version = blender_version()
    if version[:2] != VERSION:
        sys.exit(f"References are of Blender {VERSION}, this is {version}")
    blender = f"Blender {'.'.join(map(str, version))}"
    folder = OUT / "references"
    folder.mkdir(parents=True, exist_ok=True)
    left = None
    for samples in SAMPLES:
        left = _render_round(arguments.scenes, samples, left, blender, folder)
        if not left:
            break
    print(f"{folder}; {len(left)} scenes still noisy: {' '.join(left)}")


def _render_round(glob: str, samples: int, only, blender: str, folder: Path) -> list[str]:
    """Renders and keeps; gives the scenes that need more samples."""
    noisy = []
    with tempfile.TemporaryDirectory(prefix="eye-references-") as scratch:
        found = render_features("CYCLES", glob, SEEDS, Path(scratch), samples, only)
    for name, rendered in found.items():
        if rendered.facts["refused"]:
            continue
        if rendered.error:
            print(f"FAILED {name}: {rendered.error}", flush=True)
            continue
        seen = [as_seen(picture, rendered.facts["view"]) for picture in rendered.pictures]
        noise = mean_flip(np.mean(seen[::2], axis=0), np.mean(seen[1::2], axis=0))
        reference = of_batches(seen, samples, noise, blender)
        save(folder / path_of(name).name, reference)
        print(f"{name:40} {reference.samples:5} samples, noise {noise:.4f}", flush=True)
        if noise > AGREEMENT:
            noisy.append(name)
    return noisy


if __name__ == "__main__":
    main()
