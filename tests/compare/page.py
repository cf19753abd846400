"""The table and the page of a comparison."""

import base64
import csv
import html
import math
import struct
import zlib
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from measure import Difference
from tools.display import to_display

PASSED, EXPECTED, FAILED = "ok", "differs, as expected", "FAILED"
NOT_IMPORTABLE = "not importable here"  # Blender has no importer for the file, or it refuses
OUTCOMES = (FAILED, EXPECTED, PASSED, NOT_IMPORTABLE)
DIFFERENCE_GAIN = 4.0  # the page's difference pictures are brightened by this


@dataclass
class Cost:
    seconds: float
    peak_mb: float


@dataclass
class Row:
    """One scene beside Cycles."""

    name: str
    about: str
    outcome: str
    threshold: float
    reason: str = ""  # why it differs, or what failed
    difference: Difference | None = None
    noise: float = math.nan  # mean FLIP of the reference against itself
    cycles: Cost | None = None
    eye_render: Cost | None = None
    warnings: list[str] = field(default_factory=list)
    pictures: tuple[np.ndarray, ...] = ()  # linear: the reference and ours


def write_csv(path: Path, rows: list[Row]) -> None:
    with path.open("w", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(
            "scene outcome flip threshold reference_noise rmse block_rmse brightness_ratio"
            " cycles_s eye_render_s cycles_mb eye_render_mb reason warnings".split()
        )
        for row in rows:
            found = row.difference
            figures = [found.flip, found.rmse, found.block_rmse, found.brightness_ratio] \
                if found else [math.nan] * 4  # fmt: skip
            flip, *others = (f"{value:.4f}" for value in figures)
            costs = [getattr(cost, name, math.nan) for name in ("seconds", "peak_mb")
                     for cost in (row.cycles, row.eye_render)]  # fmt: skip
            writer.writerow(
                [row.name, row.outcome, flip, row.threshold, f"{row.noise:.4f}", *others]
                + [f"{cost:.2f}" for cost in costs]
                + [row.reason, " | ".join(row.warnings)]
            )


def line_of(row: Row) -> str:
    """A line of the table on the console."""
    found = row.difference
    if not found:
        return f"{row.name:40} {row.outcome}: {row.reason}"
    figures = f"FLIP {found.flip:.4f}  RMSE {found.rmse:.4f}"
    figures += f"  brightness {found.brightness_ratio:.3f}"
    for name, cost in (("Cycles", row.cycles), ("ours", row.eye_render)):
        if cost:
            figures += f"  {name} {cost.seconds:.1f} s {cost.peak_mb:.0f} MB"
    ending = "" if row.outcome == PASSED else f"  {row.outcome}: {row.reason}"
    return f"{row.name:40} {figures}{ending}"


def summary(rows: list[Row]) -> str:
    count = Counter(row.outcome for row in rows)
    parts = ", ".join(f"{count[outcome]} {outcome}" for outcome in (PASSED, EXPECTED, FAILED))
    if count[NOT_IMPORTABLE]:
        parts += f", {count[NOT_IMPORTABLE]} {NOT_IMPORTABLE}"
    return f"{len(rows)} scenes: {parts}"


# --- the page ------------------------------------------------------------------------------

_STYLE = """body { font: 14px sans-serif; margin: 2em; background: #eee }
table { border-collapse: collapse } td, th { padding: 4px 10px; text-align: left }
tr { border-bottom: 1px solid #ccc } img { image-rendering: pixelated; width: 192px }
.FAILED { color: #b00 } small { color: #555 }"""


def write_page(path: Path, title: str, rows: list[Row]) -> None:
    """One file that holds its pictures; what is furthest off comes first."""
    ranked = sorted(
        rows,
        key=lambda r: (
            OUTCOMES.index(r.outcome),
            -(r.difference.figure() if r.difference else 9),
        ),
    )
    head = "".join(f"<th>{text}</th>" for text in (
        "scene", "Cycles", "Eye Render", f"difference × {DIFFERENCE_GAIN:.0f}", ""))  # fmt: skip
    page = f"<!doctype html><meta charset=utf-8><title>{html.escape(title)}</title>"
    page += f"<style>{_STYLE}</style><h1>{html.escape(title)}</h1><p>{summary(rows)}</p>"
    page += f"<table><tr>{head}</tr>{''.join(map(_page_row, ranked))}</table>"
    path.write_text(page)


def _page_row(row: Row) -> str:
    cells = [f"<b class={row.outcome.split(',')[0]}>{html.escape(row.name)}</b><br>"
             f"{html.escape(row.about)}"]  # fmt: skip
    if len(row.pictures) == 2:
        reference, ours = map(to_display, row.pictures)
        shown = [reference, ours]
        if reference.shape == ours.shape:
            shown.append(np.clip(DIFFERENCE_GAIN * abs(reference - ours), 0, 1))
        cells += map(_image, shown)
    cells += [""] * (4 - len(cells))
    text = [row.outcome, row.reason, line_of(row).removeprefix(row.name), *row.warnings]
    cells.append("<br>".join(f"<small>{html.escape(line)}</small>" for line in text if line))
    return "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"


def _image(shown: np.ndarray) -> str:
    data = base64.b64encode(png((shown * 255 + 0.5).astype(np.uint8))).decode()
    return f'<img src="data:image/png;base64,{data}">'


def png(rgb: np.ndarray) -> bytes:
    """A PNG file of bytes (height, width, 3), rows from the top."""
    height, width, _ = rgb.shape
    rows = b"".join(b"\0" + row.tobytes() for row in rgb)

    def chunk(kind: bytes, data: bytes) -> bytes:
        checked = kind + data
        return struct.pack(">I", len(data)) + checked + struct.pack(">I", zlib.crc32(checked))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))  # fmt: skip
