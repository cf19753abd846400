"""Options after `--` on Blender's command line: they rule this run and are never saved."""

import difflib
import sys
from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path

import bpy

from .options import HELP, OPTIONS, PRESCRIPTIONS, help_rows
from .wavefront import WavefrontFile

EXIT_STATUS = 2  # of a run with a bad option
_PREFIX = "--eye"
# Blender's own options that render, or run a script that may.
_RENDERING = {"-f", "--render-frame", "-a", "--render-anim", "-P", "--python", "--python-text"} | {
    "--python-expr",
    "--python-console",
    "-c",
    "--command",
}
_LIKENESS = 0.75  # of a misspelling to the option meant, 1 for the same text


class OptionError(ValueError):
    """Names the option, what was given and what is allowed."""


@dataclass
class Overrides:
    """What the command line says in place of the file; None where it says nothing."""

    rx: str | None = None
    rx_left: str | None = None
    side: str | None = None  # "RIGHT" or "LEFT"
    vertex: float | None = None  # millimetres
    correction: str | None = None  # as the properties name it
    worn: str | None = None  # "none", "own" or a prescription
    worn_left: str | None = None
    worn_part: str | None = None  # "FAR" or "NEAR"
    age: float | None = None
    focus: str | float | None = None  # "relaxed", "camera", "center" or metres
    pupil: str | float | None = None  # "auto" or millimetres
    pupil_field: str | float | None = None  # "picture" or degrees
    pupil_hold: bool | None = None
    model: str | None = None
    wavefront: WavefrontFile | None = None
    wavefront_left: WavefrontFile | None = None
    refraction_zero: str | None = None
    exact_trace: bool | None = None
    chromatic: bool | None = None
    stiles_crawford: str | None = None
    quality: str | None = None
    samples: int | None = None
    seed: int | None = None
    sample_range: tuple[int, int] | None = None
    report: Path | None = None
    report_distances: tuple[float, ...] | None = None
    given: dict[str, str] = field(default_factory=dict, compare=False)  # options, as typed

    def spoken(self, options: Iterable[str]) -> str:
        """Which of these options were given, and with what."""
        return ", ".join(
            f'{name} is "{self.given[name]}"' for name in options if name in self.given
        )


overrides = Overrides()


def ruled(override: object, setting: object) -> object:
    """What the command line says, where it says anything."""
    return setting if override is None else override


def parse(arguments: list[str]) -> Overrides:
    """Read the `--eye-…` options, as `--option value` or `--option=value`.

    A value may begin with a minus sign. What other add-ons read is passed over.
    """
    result = Overrides()
    remaining = iter(arguments)
    is_prescription = False
    for argument in remaining:
        if is_prescription and not argument.startswith("--"):
            raise OptionError(
                f'"{argument}" follows a prescription; put all of it in quotes, as in '
                '--eye-rx "-2.00DS -0.75DC 160A"'
            )
        is_prescription = False
        option, has_value, value = argument.partition("=")
        if not option.startswith(_PREFIX):
            continue
        if option not in OPTIONS:
            raise OptionError(_unknown(option))
        if not has_value:
            value = next(remaining, None)
            if value is None or value.startswith(_PREFIX):
                raise OptionError(f"{option} has no value; expected {OPTIONS[option].allowed}")
        is_prescription = option in PRESCRIPTIONS
        try:
            name = option.removeprefix("--eye-").replace("-", "_")
            setattr(result, name, OPTIONS[option].read(value))
            result.given[option] = value
        except ValueError as error:
            raise OptionError(f'{option} is "{value}"; {error}') from None
    return result


def check_report(read: Overrides, blenders_arguments: list[str]) -> None:
    """OptionError for a report that a background Blender would end without."""
    if read.report is None:
        if read.report_distances is not None:
            raise OptionError("--eye-report-distances is given without --eye-report FILE.json")
    elif not _RENDERING & set(blenders_arguments):
        raise OptionError(
            f'--eye-report is "{read.report}", but nothing is rendered to report on; '
            "expected -f FRAME or -a before --"
        )


def asks_for_one_frame(arguments: list[str]) -> bool:
    """Whether Blender's own arguments render a frame, and no other."""
    own = arguments[: arguments.index("--")] if "--" in arguments else arguments
    frames = [
        value for option, value in pairwise(own) if option in ("-f", "--render-frame")
    ]  # such as 1, +1, 1,3 or 1..3
    is_one = len(frames) == 1 and frames[0].lstrip("+-").isdigit()
    return is_one and not {"-a", "--render-anim"} & set(own)


def _unknown(option: str) -> str:
    alike = difflib.get_close_matches(option, OPTIONS, 1, _LIKENESS)
    hint = f" (did you mean {alike[0]}?)" if alike else ""
    return f"{option} is unknown{hint}; expected one of {', '.join(OPTIONS)}"


def help_text() -> str:
    rows = help_rows()
    widths = [max(len(row[column]) for row in rows) for column in range(2)]
    lines = [f"  {row[0]:{widths[0]}}  {row[1]:{widths[1]}}  {row[2]}".rstrip() for row in rows]
    return "\n".join(["Eye Render's options, after -- on Blender's command line:", *lines])


def register():
    """Read this run's options; a bad one, or a call for help, ends Blender."""
    global overrides
    end = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)
    arguments = sys.argv[end + 1 :]
    if HELP in arguments:
        print(help_text(), flush=True)
        sys.exit(0)
    try:
        overrides = parse(arguments)
        if bpy.app.background:
            check_report(overrides, sys.argv[:end])
    except OptionError as error:
        end_blender(error)


def end_blender(error: OptionError) -> None:
    """One line on what is wrong, and the status that says that the command line is."""
    print(f"Eye Render: {error}", file=sys.stderr, flush=True)
    sys.exit(EXIT_STATUS)
