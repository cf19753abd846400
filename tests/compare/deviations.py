"""What is known of scenes that are not as near to their references as the others, by design or not
yet: deviations.csv, of which `run compare --record` writes the figures, and people the reasons,
beside the scenes and in not_yet.py. A scene that comes nearer is off as well: its figures are old.
"""

import csv
import math
from dataclasses import dataclass
from pathlib import Path

from measure import Difference
from not_yet import NOT_YET

FILE = Path(__file__).with_name("deviations.csv")
BEFORE_4, ANY = "before 4.0", "any"  # Blender

# How much further or nearer than what is expected a picture may be.
FLIP_MARGIN = 0.03
# Of small differences FLIP is about six times the blocks' RMSE. A third more is for the noise of
# few samples, which is not quite that of Cycles.
EXCESS_MARGIN = 0.0067


@dataclass(frozen=True)
class Expected:
    """How far a scene is from its reference, and why so far."""

    flip: float = 0.0
    excess_rmse: float = 0.0
    why: str = ""

    def is_near(self, found: Difference) -> bool:
        """Whether a picture is as far off as that."""
        is_flip_near = math.isnan(found.flip) or abs(found.flip - self.flip) <= FLIP_MARGIN
        return is_flip_near and abs(found.excess_rmse - self.excess_rmse) <= EXCESS_MARGIN


AS_CYCLES = Expected()


def expected_of(facts: dict, version: tuple[int, ...]) -> Expected:
    """Of the scene in that Blender."""
    blender = _blender(facts, version)
    why = reason_of(facts, blender)
    figures = load().get((facts["name"], blender))
    return Expected(*figures, why) if why and figures else AS_CYCLES


def reason_of(facts: dict, blender: str) -> str:
    """Why the scene is off in that Blender, if it is known to be."""
    return NOT_YET.get(facts["name"]) or facts["before_4" if blender == BEFORE_4 else "differs"]


def record(found: dict[str, Difference], facts: dict[str, dict], version: tuple[int, ...]) -> None:
    """Keeps the figures of scenes that are off or have a reason to be; forgets the others."""
    deviations = load()
    for name, difference in found.items():
        if math.isnan(difference.flip):
            raise SystemExit("FLIP is not installed; without it nothing is recorded")
        blender = _blender(facts[name], version)
        deviations.pop((name, blender), None)
        if reason_of(facts[name], blender) or not AS_CYCLES.is_near(difference):
            deviations[name, blender] = (difference.flip, difference.excess_rmse)
    with FILE.open("w", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["scene", "blender", "flip", "excess_rmse"])
        for (name, blender), figures in sorted(deviations.items()):
            writer.writerow([name, blender, *(f"{figure:.4f}" for figure in figures)])


def _blender(facts: dict, version: tuple[int, ...]) -> str:
    """Which figures hold in that one."""
    is_special = version < (4, 0) and facts["before_4"] and facts["name"] not in NOT_YET
    return BEFORE_4 if is_special else ANY


def load() -> dict[tuple[str, str], tuple[float, float]]:
    with FILE.open(newline="") as stream:
        return {
            (row["scene"], row["blender"]): (float(row["flip"]), float(row["excess_rmse"]))
            for row in csv.DictReader(stream)
        }
