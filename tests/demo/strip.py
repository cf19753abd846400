"""Puts pictures side by side, each with its label below, by OpenImageIO's oiiotool."""

import subprocess
from pathlib import Path

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"  # package fonts-dejavu-core
LABEL_HEIGHT_PX, LABEL_SIZE_PX, GAP_PX = 64, 36, 8


def make_strip(pictures: list[Path], labels: list[str], size_px: int, strip: Path) -> None:
    """`pictures` are squares of `size_px`."""
    height_px = size_px + LABEL_HEIGHT_PX
    command = ["oiiotool"]
    for picture, label in zip(pictures, labels, strict=True):
        command += [str(picture), "--ch", "R,G,B", "--cut", f"{size_px}x{height_px}+0+0"]
        command += ["--fill:color=1,1,1", f"{size_px}x{LABEL_HEIGHT_PX}+0+{size_px}"]
        place = f"x={size_px // 2}:y={size_px + LABEL_HEIGHT_PX // 2}:xalign=center:yalign=center"
        command += [f"--text:{place}:size={LABEL_SIZE_PX}:color=0,0,0:font={FONT}", label]
    command += [f"--mosaic:pad={GAP_PX}", f"{len(pictures)}x1", "-d", "uint8", "-o", str(strip)]
    subprocess.run(command, check=True)
