"""Makes out/figures: the experiments of Wang & Xiao 2013, Fig. 9 to 13, each by the paper's eye
(above) and by the exact first-order eye (below). `run figures` calls this."""

import argparse
import json
import re
import subprocess
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from line_contrast import line_contrast, read_luminance  # noqa: E402
from tools.blender import BUILD, OUT, is_newer, make_hall, run_blender  # noqa: E402
from tools.sheet import Panel, Row, make_sheet  # noqa: E402

# Eye model, what its row is called, and the pupil's formula where the pupil is automatic. From the
# cornea to the pupil, 3.05 mm, 6 D become 2 % less.
MODELS = (
    ("paper", "the eye of Wang & Xiao 2013, refracted at the pupil", "PAPER"),
    ("paraxial", "the exact first-order eye, refracted at the cornea", "WATSON_YELLOTT"),
)
SIZE_PX, SAMPLES = 256, 48
RINGS = 8  # of Fig. 13's pattern: DistantFactor = AngleFactor


@dataclass
class View:
    """What one panel shows; the rest of its observer is as Blender starts with."""

    label: str  # {pupil_mm}, {luminance} and {line_contrast} are filled in from the picture
    rx: str = "Plano"
    pupil_mm: float | None = 4.0  # None: automatic
    looks_at_m: float | None = None  # None: relaxed
    pattern: str = "SOBOL"
    daylight: bool = True
    cd_m2_per_unit: float = 179.0


@dataclass
class Figure:
    title: str
    views: list[View]
    scene: str = "hall"  # or a target of make_target.py
    samples: int | None = None  # where the experiment prescribes them


def _in_light(name: str, **light) -> View:
    label = name + "\n{luminance} cd/m², pupil {pupil_mm:.1f} mm"
    return View(label, pupil_mm=None, looks_at_m=0.4, **light)


def _lines(rx: str) -> View:
    return View(rx + "\n{line_contrast}", rx)


def _pattern(name: str, pattern: str) -> View:
    return View(name, "-6.00DS", pupil_mm=6.0, pattern=pattern)


FIGURES = {
    9: Figure(
        "Fig. 9: myopia. Relaxed eye, pupil 4 mm",
        [View(f"{d} DS", f"{d}DS") for d in ("0.00", "-1.50", "-3.00", "-4.50")],
    ),
    10: Figure(
        "Fig. 10: hyperopia. Eye kept relaxed (a young one would accommodate), pupil 4 mm",
        [View(f"{d} DS", f"{d}DS") for d in ("0.00", "+2.00", "+4.00", "+6.00")],
    ),
    11: Figure(
        "Fig. 11: astigmatism. Relaxed eye, pupil 4 mm, lines 24 arcmin wide",
        [_lines(rx) for rx in ("Plano", "Plano -6.00DC 90A", "Plano -6.00DC 180A")],
        scene="lines",
    ),
    12: Figure(
        "Fig. 12: automatic pupil, looking at 0.4 m, exposure adapted",
        [
            _in_light("sunlight", cd_m2_per_unit=20000.0),
            _in_light("candlelight", cd_m2_per_unit=0.5, daylight=False),
        ],
    ),
    13: Figure(
        f"Fig. 13: pupil patterns of {RINGS} x {RINGS} points. -6.00 DS, relaxed, pupil 6 mm",
        [
            _pattern("even (grid)", "GRID"),
            _pattern("circinate", "CIRCINATE"),
            _pattern("Sobol", "SOBOL"),
        ],
        scene="lamps",
        samples=RINGS**2,
    ),
}


def make_target(name: str) -> Path:
    scene = BUILD / f"figures/{name}.blend"
    script = HERE / "make_target.py"
    if not is_newer(scene, [script]):
        scene.parent.mkdir(parents=True, exist_ok=True)
        run_blender("--python", str(script), "--", str(scene), name)
    return scene


def render_panels(figure: Figure, folder: Path, size_px: int, samples: int) -> dict:
    """The pictures of each model, in the order of the views."""
    scene = make_hall("principled") if figure.scene == "hall" else make_target(figure.scene)
    jobs, pictures = [], {}
    for model, _, formula in MODELS:
        names = [f"{model}_{number}" for number in range(len(figure.views))]
        pictures[model] = [folder / f"{name}.exr" for name in names]
        jobs += [
            asdict(view) | {"name": name, "model": model, "pupil_formula": formula}
            for name, view in zip(names, figure.views, strict=True)
        ]
    folder.mkdir(parents=True, exist_ok=True)
    script = str(HERE / "render_panels.py")
    run_blender("--addons", "eye_render", str(scene), "--python", script, "--", str(folder),
                str(size_px), str(figure.samples or samples), json.dumps(jobs),
                on_line=_pass_on)  # fmt: skip
    return pictures


def _pass_on(line: str) -> None:
    if line.startswith("Panel "):
        print(".", end="", flush=True)
    elif line.startswith("Eye Render: warning"):
        print(f"\n{line.rstrip()}")


def facts_of(picture: Path) -> dict[str, str]:
    """The observer, of a picture's metadata."""
    info = subprocess.run(
        ["oiiotool", "--info", "-v", str(picture)], capture_output=True, text=True, check=True
    ).stdout
    return dict(re.findall(r'eye_render:(\w+): "([^"]+)"', info))


def label_of(view: View, picture: Path) -> str:
    facts = facts_of(picture)
    return view.label.format(
        pupil_mm=float(facts["pupil_mm"]),
        luminance=f"{float(format(float(facts.get('luminance_cd_m2', 0)), '.2g')):g}",
        line_contrast=line_contrast(read_luminance(picture)),
    )


def make_figure(number: int, size_px: int, samples: int, out: Path) -> Path:
    figure = FIGURES[number]
    pictures = render_panels(figure, out / f"panels{number:02d}", size_px, samples)
    rows = []
    for model, title, _ in MODELS:
        panels = [
            Panel(picture.with_suffix(".png"), label_of(view, picture))
            for view, picture in zip(figure.views, pictures[model], strict=True)
        ]
        rows.append(Row(panels, title))
    sheet = out / f"fig{number:02d}.png"
    make_sheet(sheet, rows, size_px, max(10, size_px // 18), figure.title)
    return sheet


def main() -> None:
    parser = argparse.ArgumentParser(prog="run figures")
    parser.add_argument("--only", nargs="+", type=int, choices=list(FIGURES),
                        default=list(FIGURES), help="these figures")  # fmt: skip
    parser.add_argument("--samples", type=int, default=SAMPLES,
                        help=f"per pixel, but in Fig. 13 (default {SAMPLES})")  # fmt: skip
    parser.add_argument("--size", type=int, default=SIZE_PX,
                        help=f"pixels a side of a panel (default {SIZE_PX})")  # fmt: skip
    arguments = parser.parse_args()
    for number in arguments.only:
        start = time.monotonic()
        print(f"Fig. {number} ", end="", flush=True)
        sheet = make_figure(number, arguments.size, arguments.samples, OUT / "figures")
        print(f" {time.monotonic() - start:.0f} s  {sheet}")


if __name__ == "__main__":
    main()
