"""The visits as a CSV file, and their summary in Markdown."""

import csv
import re
from collections import Counter
from pathlib import Path

OUTCOMES = (
    "rendered",
    "nothing to see",  # a finite picture of no faces: points, lines, skeletons
    "importer refused",
    "importer died",
    "no importer",
    "FAILED",
)
_COLUMNS = ("file", "importer", "triangles", "seen", "covered", "warnings", "seconds")


def write_csv(path: Path, visits: list) -> None:
    with path.open("w", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow([*_COLUMNS, "outcome", "detail"])
        for visit in visits:
            row = [visit.file, visit.importer, visit.triangles]
            row += [f"{visit.seen:.3f}", f"{visit.covered:.3f}"]
            row += [" | ".join(visit.warnings), f"{visit.seconds:.1f}"]
            writer.writerow([*row, visit.outcome, visit.detail])


def summary(visits: list) -> str:
    sections = ["# Files that nobody here made", _counts(visits), _warnings(visits)]
    for outcome in ("FAILED", "importer died", "importer refused"):
        lines = [
            f"* `{visit.file}`: {visit.detail}" for visit in visits if visit.outcome == outcome
        ]
        if lines:
            sections.append(f"## {outcome.capitalize()}\n\n" + "\n".join(lines))
    return "\n\n".join(sections) + "\n"


def _counts(visits: list) -> str:
    """Formats down, outcomes across; the formats without an importer are one row."""
    count = Counter((_format_of(visit), visit.outcome) for visit in visits)
    formats = sorted({name for name, _ in count}, key=lambda name: (name == "others", name))
    lines = [f"| format | {' | '.join(OUTCOMES)} |", "|---|" + "--:|" * len(OUTCOMES)]
    for name in formats:
        numbers = (str(count[name, outcome] or "") for outcome in OUTCOMES)
        lines.append(f"| {name} | {' | '.join(numbers)} |")
    totals = Counter(visit.outcome for visit in visits)
    lines.append(f"| all | {' | '.join(str(totals[outcome]) for outcome in OUTCOMES)} |")
    triangles = sum(visit.triangles for visit in visits)
    seconds = sum(visit.seconds for visit in visits)
    lines += ["", f"{len(visits)} files, {triangles} triangles, {seconds:.0f} s of Blender."]
    return "\n".join(lines)


def _format_of(visit) -> str:
    return Path(visit.file).suffix.lower() if visit.importer else "others"


def _warnings(visits: list) -> str:
    """How many files had each kind of warning: the same sentence but for names."""
    kinds = Counter(
        kind for visit in visits for kind in {_without_names(text) for text in visit.warnings}
    )
    lines = [f"| {number} | {kind} |" for kind, number in kinds.most_common()]
    table = "\n".join(["| files | warning |", "|--:|---|", *lines])
    return f"## Warnings of Eye Render\n\n{table}" if lines else "No warnings of Eye Render."


def _without_names(warning: str) -> str:
    warning = re.sub(r"'[^']*'|\"[^\"]*\"|(?<= )/\S+", "…", warning)
    return warning.replace("|", "/")
