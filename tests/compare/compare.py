"""Holds Eye Render's pictures to Cycles'. `run compare` calls this.

Without files: the feature scenes, in the user's Blender, against the stored pictures of Cycles
4.3. With .blend or model files: each in Cycles and in Eye Render of the same Blender, seen by an
emmetrope through a pinhole. Writes compare.csv and compare.html into the output folder; its exit
status is 1 if a scene is further off than it may be, or nearer than deviations.csv says.
"""

import argparse
import os
import shutil
import sys
import tempfile
from pathlib import Path

from blender_batch import blender_version, render_features
from compare_files import compare_files
from deviations import record
from not_yet import NOT_YET
from page import FAILED, PASSED, Row, line_of, summary, write_csv, write_page
from verdict import row_of

OUT = Path(os.environ.get("EYE_OUT_DIR", Path(__file__).resolve().parents[2] / "out"))
SEED = 11  # none of the references'


def compare_features(arguments: argparse.Namespace, folder: Path) -> list[Row]:
    found = render_features("EYE_RENDER", arguments.scenes, [SEED], folder, arguments.samples)
    version = blender_version()
    rows = [row_of(rendered, version, arguments.samples) for rendered in found.values()]
    if arguments.record:
        measured = {row.name: row.difference for row in rows if row.difference}
        record(measured, {name: rendered.facts for name, rendered in found.items()}, version)
        rows = [row_of(rendered, version, arguments.samples) for rendered in found.values()]
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(prog="run compare", description=__doc__.split("\n\n")[0])
    parser.add_argument("files", nargs="*", type=Path, metavar="FILE",
                        help=".blend files, or models that Blender can import")  # fmt: skip
    parser.add_argument("--library", action="store_true",
                        help="the files are libraries: a ball of each material")  # fmt: skip
    parser.add_argument("--scenes", default="*", metavar="GLOB",
                        help="feature scenes to compare, as 'lights/*' (default all)")  # fmt: skip
    parser.add_argument("--samples", type=int, help="per pixel (default: each scene's own; 256)")
    parser.add_argument("--record", action="store_true",
                        help="keep how far off scenes are, in deviations.csv")  # fmt: skip
    parser.add_argument("--bounces", type=int, default=4, help="of files (default 4)")
    parser.add_argument("--size", type=int, default=256,
                        help="of files: pixels of the longer side (default 256)")  # fmt: skip
    arguments = parser.parse_args()
    OUT.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="eye-compare-") as folder:
        if arguments.files:
            rows = compare_files(arguments, Path(folder))
        else:
            rows = compare_features(arguments, Path(folder))
            shutil.copy(Path(folder) / "blender.log", OUT / "compare.log")
    for row in rows:
        print(line_of(row))
    write_csv(OUT / "compare.csv", rows)
    write_page(OUT / "compare.html", "Eye Render beside Cycles", rows)
    built = [row.name for row in rows if row.outcome == PASSED and row.name in NOT_YET]
    if built:
        print(f"Built, to be taken from not_yet.py: {' '.join(built)}")
    print(f"{summary(rows)}\n{OUT / 'compare.csv'}\n{OUT / 'compare.html'}")
    sys.exit(any(row.outcome == FAILED for row in rows))


if __name__ == "__main__":
    main()
