"""Options after `--` on Blender's command line: they rule this run and are never saved."""

import sys
from collections.abc import Callable
from dataclasses import dataclass

from . import choices, core

EXIT_STATUS = 2  # of a run with a bad option


class OptionError(ValueError):
    """Names the option, what was given and what is allowed."""


@dataclass
class Overrides:
    """What the command line says in place of the file; None where it says nothing."""

    rx: str | None = None
    rx_left: str | None = None
    side: str | None = None  # "RIGHT" or "LEFT"
    pupil: str | float | None = None  # "auto" or millimetres
    focus: str | float | None = None  # "relaxed", "center" or metres
    age: float | None = None
    model: str | None = None
    quality: str | None = None
    samples: int | None = None
    seed: int | None = None
    sample_range: tuple[int, int] | None = None


overrides = Overrides()


def _prescription(text: str) -> str:
    # Without the core nothing is rendered anyhow, and its absence has been said.
    if core.module is not None:
        core.module.Prescription.parse(text)
    return text


def _one_of(items: list[tuple]) -> Callable[[str], str]:
    names = [item[0] for item in items]

    def read(text: str) -> str:
        if text.upper() not in names:
            raise ValueError("expected " + ", ".join(name.lower() for name in names))
        return text.upper()

    return read


def _number(kind: type, limits: tuple, unit: str = "", words: tuple[str, ...] = ()) -> Callable:
    lowest, highest = limits
    allowed = f"expected {lowest:g} to {highest:g}{unit}"
    if words:
        allowed += " or " + " or ".join(words)

    def read(text: str) -> str | float:
        if text.lower() in words:
            return text.lower()
        try:
            number = kind(text)
        except ValueError:
            raise ValueError(allowed) from None
        if not lowest <= number <= highest:
            raise ValueError(allowed)
        return number

    return read


def _sample_range(text: str) -> tuple[int, int]:
    try:
        first, end = (int(part) for part in text.split(":"))
    except ValueError:
        first, end = 0, 0
    if not 0 <= first < end:
        raise ValueError("expected A:B, the samples A to B-1, with 0 <= A < B")
    return first, end


_READERS: dict[str, Callable[[str], object]] = {
    "--eye-rx": _prescription,
    "--eye-rx-left": _prescription,
    "--eye-side": _one_of(choices.EYES),
    "--eye-pupil": _number(float, choices.PUPIL_RANGE_MM, " mm", ("auto",)),
    "--eye-focus": _number(float, choices.FOCUS_RANGE_M, " metres", ("relaxed", "center")),
    "--eye-age": _number(float, choices.AGE_RANGE_YEARS, " years"),
    "--eye-model": _one_of(choices.EYE_MODELS),
    "--eye-quality": _one_of(choices.QUALITIES),
    "--eye-samples": _number(int, choices.SAMPLES_RANGE),
    "--eye-seed": _number(int, choices.SEED_RANGE),
    "--eye-sample-range": _sample_range,
}


def parse(arguments: list[str]) -> Overrides:
    """Read the `--eye-…` options, as `--option value` or `--option=value`.

    A value may begin with a minus sign. What other add-ons read is passed over.
    """
    result = Overrides()
    remaining = iter(arguments)
    for argument in remaining:
        option, has_value, value = argument.partition("=")
        if not option.startswith("--eye-"):
            continue
        if option not in _READERS:
            raise OptionError(f"{option} is unknown; expected one of {', '.join(_READERS)}")
        if not has_value:
            value = next(remaining, None)
            if value is None:
                raise OptionError(f"{option} has no value")
        try:
            field = option.removeprefix("--eye-").replace("-", "_")
            setattr(result, field, _READERS[option](value))
        except ValueError as error:
            raise OptionError(f'{option} is "{value}"; {error}') from None
    return result


def register():
    """Read this run's options; a bad one ends Blender."""
    global overrides
    arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    try:
        overrides = parse(arguments)
    except OptionError as error:
        print(f"Eye Render: {error}", file=sys.stderr, flush=True)
        sys.exit(EXIT_STATUS)
