"""What an eye makes of points at several distances: a JSON file of numbers, and a picture beside
it. Plain Python on the native module; knows nothing of Blender."""

import json
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from .measure import Subject, distances_of, measure, subject_of, summary_line

__all__ = ["Subject", "Written", "distances_of", "subject_of", "summary_line", "write_report"]


class Written(NamedTuple):
    numbers: Path
    picture: Path | None
    note: str  # why there is no picture; empty if there is one


def write_report(subject: Subject, distances_m: Sequence[float], path: Path) -> Written:
    """Write the JSON file `path`, and a PNG of the same name beside it if matplotlib is there.

    OSError tells which file cannot be written, ValueError that the eye has nothing to report.
    """
    report = measure(subject, distances_m)
    text = json.dumps(_rounded(report), indent=2, allow_nan=False)
    # Both are made before either takes its place, so that no failure leaves half a report.
    with TemporaryDirectory(dir=path.parent) as folder:
        new = Path(folder) / path.name
        new.write_text(text + "\n", encoding="utf-8")
        try:
            from .figure import draw
        except ImportError as error:
            note = f"the report has no picture: {error}; Debian's package is python3-matplotlib"
            new.replace(path)
            return Written(path, None, note)
        picture = path.with_suffix(".png")
        draw(subject.eye, report, new.with_suffix(".png"))
        new.with_suffix(".png").replace(picture)
        new.replace(path)
    return Written(path, picture, "")


_FINEST_DECIMAL = 9  # below it lies the noise of sums that should be 0


def _rounded(value: object) -> object:
    """To what the sampling of the pupil is good for, and more than any clinic asks for."""
    if isinstance(value, float):
        return round(float(f"{value:.6g}"), _FINEST_DECIMAL)
    if isinstance(value, dict):
        return {key: _rounded(each) for key, each in value.items()}
    if isinstance(value, list):
        return [_rounded(each) for each in value]
    return value
