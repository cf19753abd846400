"""Files with the aberrations of an eye, as an aberrometer exports them.

CSV: lines `pupil_mm,6.0`, `wavelength_nm,555` and, if it is known, `eye,OD`; then a heading
`j,coefficient_um` and one line for each Zernike coefficient, j being its OSA/ANSI index. Empty
lines and what follows `#` do not count. JSON: an object with the same names, and under
`coefficients_um` a list from j = 0 or an object from j to coefficient.
"""

import json
from pathlib import Path
from typing import NamedTuple

from . import core

MAX_TERMS = 28  # to the 6th order
_NUMBERS = ("pupil_mm", "wavelength_nm")
_HEADING = ("j", "coefficient_um")
_SIDES = ("OD", "OS")


class WavefrontFile(NamedTuple):
    coefficients_um: list[float]  # MAX_TERMS of them, by OSA index
    pupil_mm: float
    wavelength_nm: float
    side: str  # "OD", "OS" or, if the file does not tell, ""


def read(path: str | Path) -> WavefrontFile:
    """ValueError tells what is wrong with the file."""
    try:
        text = Path(path).read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is no text"
        raise ValueError(f"{path} cannot be read: {reason}") from None
    try:
        heads, coefficients = _read_json(text) if text.lstrip()[:1] == "{" else _read_csv(text)
        measured = _checked(heads, coefficients)
        if core.module is not None:
            as_core(measured)
        return measured
    except ValueError as error:
        raise ValueError(f"{Path(path).name}: {error}") from None


def as_core(measured):
    """The core's Wavefront of such a file, or of the properties that keep one; ValueError."""
    return core.require().Wavefront(
        list(measured.coefficients_um), measured.pupil_mm, measured.wavelength_nm
    )


def _read_csv(text: str) -> tuple[dict[str, str], list[tuple[str, str]]]:
    heads: dict[str, str] = {}
    coefficients: list[tuple[str, str]] = []
    for number, line in enumerate(text.splitlines(), 1):
        line = line.partition("#")[0].strip()
        if not line:
            continue
        name, comma, value = (part.strip() for part in line.partition(","))
        if not comma or "," in value:
            raise ValueError(f"line {number} is '{line}'; expected a name or index and a value")
        if (name, value) == _HEADING:
            continue
        if name[:1].isdigit():
            coefficients.append((name, value))
        else:
            heads[name] = value
    return heads, coefficients


def _read_json(text: str) -> tuple[dict, list[tuple]]:
    content = json.loads(text)  # JSONDecodeError is a ValueError and names the place
    listed = content.pop("coefficients_um", [])
    if not isinstance(listed, list | dict):
        raise ValueError(f"coefficients_um is {listed}; expected a list or an object")
    return content, list(listed.items() if isinstance(listed, dict) else enumerate(listed))


def _number(name: str, value: object) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} is '{value}'; expected a number") from None


def _checked(heads: dict, coefficients: list[tuple]) -> WavefrontFile:
    unknown = sorted(heads.keys() - {*_NUMBERS, "eye"})
    if unknown:
        raise ValueError(f"'{unknown[0]}' is unknown; expected pupil_mm, wavelength_nm or eye")
    for name in _NUMBERS:
        if name not in heads:
            raise ValueError(f"{name} is missing")
    side = heads.get("eye", "")
    if side not in ("", *_SIDES):
        raise ValueError(f"eye is '{side}'; expected OD or OS")
    if not coefficients:
        raise ValueError("there is no coefficient in it")
    values = [0.0] * MAX_TERMS
    seen: set[int] = set()
    for index, value in coefficients:
        j = int(index) if str(index).isdecimal() else -1
        if not 0 <= j < MAX_TERMS:
            raise ValueError(f"j is {index}; expected an OSA index from 0 to {MAX_TERMS - 1}")
        if j in seen:
            raise ValueError(f"j = {j} is there twice")
        seen.add(j)
        values[j] = _number(f"the coefficient of j = {j}", value)
    pupil_mm, wavelength_nm = (_number(name, heads[name]) for name in _NUMBERS)
    return WavefrontFile(values, pupil_mm, wavelength_nm, side)
