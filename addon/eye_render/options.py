"""The options that may follow `--` on Blender's command line: one table for reading them, for
`--eye-help` and for the README."""

import math
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from . import choices, core, wavefront
from .prescription import parse as parse_prescription

HELP = "--eye-help"
# Of several words, so quoted.
PRESCRIPTIONS = ("--eye-rx", "--eye-rx-left", "--eye-worn", "--eye-worn-left")
# What is not about the eye, so that no eye can be impossible because of it.
OF_THE_RENDER = {
    *("--eye-quality", "--eye-samples", "--eye-seed", "--eye-sample-range"),
    *("--eye-report", "--eye-report-distances"),
}


class Option(NamedTuple):
    allowed: str  # as people read it
    meaning: str
    read: Callable[[str], object]  # ValueError tells what is wrong


def _prescription(eye: str, meaning: str) -> Option:
    def read(text: str) -> str:
        # Without the core nothing is rendered anyhow, and its absence has been said.
        if core.module is not None:
            parse_prescription(text, eye)
        return text

    return Option("such as -2.00DS -0.75DC 160A", meaning, read)


def _worn(text: str) -> str:
    if text.lower() in ("none", "own"):
        return text.lower()
    if core.module is not None:
        core.module.Prescription.parse(text)
    return text


def _one_of(items: list[tuple], meaning: str) -> Option:
    names = [item[0].lower() for item in items]
    allowed = ", ".join(names)

    def read(text: str) -> str:
        if text.lower() not in names:
            raise ValueError(f"expected {allowed}")
        return text.upper()

    return Option(allowed, meaning, read)


def _switch(meaning: str) -> Option:
    words = {"on": True, "off": False}

    def read(text: str) -> bool:
        if text.lower() not in words:
            raise ValueError("expected on or off")
        return words[text.lower()]

    return Option("on, off", meaning, read)


def _spoken(number: float) -> str:
    """Without exponents: 16 777 216, 0.01."""
    return f"{int(number):,}".replace(",", " ") if number == int(number) else f"{number:g}"


def _number(
    kind: type,
    limits: tuple[float, float],
    meaning: str,
    unit: str = "",
    words: dict[str, object] | None = None,
) -> Option:
    """A number, with a point or a comma, or one of the words, with the value it stands for."""
    words = words or {}
    lowest, highest = limits
    allowed = f"{_spoken(lowest)} to {_spoken(highest)}{unit}"
    allowed = ", ".join([allowed, *words][:-1]) + f" or {list(words)[-1]}" if words else allowed

    def read(text: str) -> object:
        if text.lower() in words:
            return words[text.lower()]
        try:
            number = kind(text.replace(",", ".", 1))
        except ValueError:
            number = math.nan
        if not lowest <= number <= highest:
            raise ValueError(f"expected {allowed}")
        return number

    return Option(allowed, meaning, read)


def _sample_range(text: str) -> tuple[int, int]:
    try:
        first, end = (int(part) for part in text.split(":"))
    except ValueError:
        first, end = 0, 0
    highest = choices.SAMPLES_RANGE[1]
    if not 0 <= first < end <= highest:
        raise ValueError(
            f"expected A:B, the samples A to B-1, with 0 <= A < B <= {_spoken(highest)}"
        )
    return first, end


def _report_path(text: str) -> Path:
    path = Path(text)
    if path.suffix != ".json" or path.is_dir():
        raise ValueError("expected FILE.json")
    is_beside_the_scene = text.startswith("//")  # whose folder is not known yet
    if not is_beside_the_scene and not path.parent.is_dir():
        raise ValueError(f"expected a file in a folder that exists; {path.parent} does not")
    return path


_DISTANCES_ALLOWED = "1 to 8 distances in metres, such as 0.3,0.6,6,inf"
_MOST_DISTANCES = 8  # whose pictures stay large enough beside each other


def read_distances(text: str) -> tuple[float, ...]:
    """Metres from near to far, infinity among them if it is asked for."""
    nearest, farthest = choices.FOCUS_RANGE_M
    try:
        distances = {float(part) for part in text.split(",")}
    except ValueError:
        distances = set()
    is_possible = all(nearest <= each <= farthest or each == math.inf for each in distances)
    if not (is_possible and 1 <= len(distances) <= _MOST_DISTANCES):
        raise ValueError(
            f"expected {_DISTANCES_ALLOWED}, each {_spoken(nearest)} to {_spoken(farthest)} or inf"
        )
    return tuple(sorted(distances))


_WORN_ALLOWED = "none, own or such as -2.00DS"

OPTIONS: dict[str, Option] = {
    "--eye-rx": _prescription("RIGHT", "prescription of the right eye"),
    "--eye-rx-left": _prescription("LEFT", "prescription of the left eye"),
    "--eye-side": _one_of(choices.EYES, "the eye to look through"),
    "--eye-vertex": _number(
        float, choices.VERTEX_RANGE_MM, "from cornea to glasses, refracted with or worn", " mm"
    ),
    "--eye-correction": _one_of(choices.CORRECTIONS, "what is worn before the eyes"),
    "--eye-worn": Option(
        _WORN_ALLOWED,
        "what the glasses (or contact lenses) are made to; own: what the eye needs",
        _worn,
    ),
    "--eye-worn-left": Option(
        _WORN_ALLOWED, "the same for the left eye, where it differs from the right", _worn
    ),
    "--eye-worn-part": _one_of(
        choices.WORN_PARTS, "the part of the glasses to look through, near: with the add"
    ),
    "--eye-age": _number(
        float, choices.AGE_RANGE_YEARS, "limits accommodation, narrows the pupil", " years"
    ),
    "--eye-focus": _number(
        float,
        choices.FOCUS_RANGE_M,
        "what the eye looks at: inf is far away, relaxed its far point, camera what the camera "
        "is focused at, center the middle of the picture",
        " metres",
        {
            "relaxed": "relaxed",
            "camera": "camera",
            "center": "center",
            "inf": math.inf,
            "infinity": math.inf,
        },
    ),
    "--eye-pupil": _number(
        float, choices.PUPIL_RANGE_MM, "diameter of the pupil", " mm", {"auto": "auto"}
    ),
    "--eye-pupil-field": _number(
        float,
        choices.FIELD_RANGE_DEG,
        "diameter of the field whose light the automatic pupil answers to",
        " degrees",
        {"picture": "picture"},
    ),
    "--eye-pupil-hold": _switch("keeps the pupil that the first frame finds for all frames"),
    "--eye-model": _one_of(
        choices.EYE_MODELS, "how the eye turns a point of its pupil into a ray"
    ),
    "--eye-wavefront": Option(
        "a file, CSV or JSON",
        "measured aberrations of the right eye, or of the one it names, for the model wavefront",
        wavefront.read,
    ),
    "--eye-wavefront-left": Option(
        "a file, CSV or JSON", "the same of the left eye", wavefront.read
    ),
    "--eye-refraction-zero": _one_of(
        choices.REFRACTION_ZEROS, "what no prescription means for an eye with real surfaces"
    ),
    "--eye-exact-trace": _switch("traces each ray through the real surfaces, not their map"),
    "--eye-chromatic": _switch("lets the eye focus each colour at its own distance"),
    "--eye-stiles-crawford": _one_of(
        choices.STILES_CRAWFORD_MODES, "whether light counts less away from the pupil's middle"
    ),
    "--eye-quality": _one_of(choices.QUALITIES, "how many samples are taken of each pixel"),
    "--eye-samples": _number(int, choices.SAMPLES_RANGE, "samples of each pixel"),
    "--eye-seed": _number(int, choices.SEED_RANGE, "chooses the noise pattern"),
    "--eye-sample-range": Option(
        "A:B", "only the samples A to B-1, to be merged with others", _sample_range
    ),
    "--eye-report": Option(
        "FILE.json",
        "writes blur, contrast and focus of the eye, with a picture FILE.png; of an animation "
        "FILE.0001.json for each frame",
        _report_path,
    ),
    "--eye-report-distances": Option(
        _DISTANCES_ALLOWED,
        "what the report is about, in place of 0.4, 1, 6 and inf",
        read_distances,
    ),
}


def help_rows() -> list[tuple[str, str, str]]:
    """(option, what is allowed, what it means)"""
    rows = [(name, option.allowed, option.meaning) for name, option in OPTIONS.items()]
    return [*rows, (HELP, "", "prints this table and ends")]
