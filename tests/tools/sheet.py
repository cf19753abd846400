"""Puts pictures of one size into rows, each with its label below and each row with its title, by
OpenImageIO's oiiotool."""

import subprocess
from dataclasses import dataclass
from pathlib import Path

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"  # package fonts-dejavu-core
GAP_PX = 8


@dataclass
class Panel:
    picture: Path
    label: str  # may have several lines


@dataclass
class Row:
    panels: list[Panel]
    title: str = ""  # above the row, at its left


def make_sheet(sheet: Path, rows: list[Row], size_px: int, text_px: int, title: str = "") -> None:
    """The pictures are squares of `size_px`; a line of text has letters of `text_px`."""
    line_px = text_px * 7 // 5
    lines = max(panel.label.count("\n") + 1 for row in rows for panel in row.panels)
    label_px = lines * line_px + GAP_PX
    columns = max(len(row.panels) for row in rows)
    width_px = columns * size_px + (columns - 1) * GAP_PX
    commands = []

    def write(text: str, x: int, y: int, align: str) -> None:
        place = f"x={x}:y={y}:xalign={align}:yalign=center"
        commands.extend([f"--text:{place}:size={text_px}:color=0,0,0:font={FONT}", text])

    y = 0
    for row in [Row([], title), *rows]:
        if row.title:
            write(row.title, GAP_PX, y + line_px // 2, "left")
            y += line_px + GAP_PX
        for column, panel in enumerate(row.panels):
            x = column * (size_px + GAP_PX)
            commands += [str(panel.picture), "--ch", "R,G,B", "--swap", "--paste", f"+{x}+{y}"]
            for number, line in enumerate(panel.label.split("\n")):
                below = y + size_px + GAP_PX // 2 + number * line_px + line_px // 2
                write(line, x + size_px // 2, below, "center")
        y += size_px + label_px if row.panels else 0
    canvas = ["--create", f"{width_px}x{y}", "3", "--fill:color=1,1,1", f"{width_px}x{y}"]
    command = ["oiiotool", *canvas, *commands, "-d", "uint8", "-o", str(sheet)]
    subprocess.run(command, check=True)
