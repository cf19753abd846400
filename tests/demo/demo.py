"""Makes out/demo.png: the hall seen through the four prescriptions of Wang & Xiao 2013, Fig. 9.
What is newer than everything it was made from is not made again. `run demo` calls this."""

import argparse
import re
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from tools.blender import BUILD, OUT, ROOT, is_newer, make_hall, run_blender  # noqa: E402
from tools.sheet import Panel, Row, make_sheet  # noqa: E402

SPHERES_D = ("0.00", "-1.50", "-3.00", "-4.50")
SIZE_PX = 512  # as make_scene.py sets it
LABEL_PX = 36
SAMPLE = re.compile(r"Sample (\d+)/(\d+)")


class Progress:
    """Turns Blender's output into one line a view, which counts on a terminal."""

    def __init__(self, views: int):
        self._views, self._view = views, 0
        self._start = time.monotonic()

    def __call__(self, line: str) -> None:
        if line.startswith("Eye Render: warning"):
            print(line.rstrip())
        elif line.startswith("View "):
            self.finish()
            self._view += 1
            self._start = time.monotonic()
            self._title = f"View {self._view} of {self._views}: {line.split()[1]} DS"
            print(self._title, end="", flush=True)
        elif sys.stdout.isatty() and (sample := SAMPLE.search(line)):
            done = f"{sample[1]} of {sample[2]} samples"
            print(f"\r{self._title}  {done}", end="", flush=True)

    def finish(self) -> None:
        if self._view:
            print(f"  {time.monotonic() - self._start:.0f} s")


def samples_stamp(samples: int) -> Path:
    """A file that changes when the number of samples does."""
    stamp = BUILD / "demo" / "samples"
    if not stamp.exists() or stamp.read_text() != str(samples):
        stamp.write_text(str(samples))
    return stamp


def render_views(scene: Path, samples: int) -> list[Path]:
    views = {sphere_d: OUT / f"demo_{sphere_d}DS.png" for sphere_d in SPHERES_D}
    made_from = [
        scene,
        samples_stamp(samples),
        HERE / "render_views.py",
        HERE.parent / "tools/picture.py",
        *BUILD.glob("release/bindings/eyecore*.so"),
        *(ROOT / "addon/eye_render").rglob("*.py"),
    ]
    stale = [sphere_d for sphere_d, view in views.items() if not is_newer(view, made_from)]
    if stale:
        OUT.mkdir(parents=True, exist_ok=True)
        progress = Progress(len(stale))
        script = str(HERE / "render_views.py")
        run_blender("--addons", "eye_render", str(scene), "--python", script, "--",
                    str(OUT), str(samples), *stale, on_line=progress)  # fmt: skip
        progress.finish()
    return list(views.values())


def main() -> None:
    parser = argparse.ArgumentParser(prog="run demo")
    parser.add_argument("--samples", type=int, default=64, help="per pixel (default 64)")
    parser.add_argument(
        "--scene-only", action="store_true", help="build the scenes, render nothing"
    )
    arguments = parser.parse_args()

    scene = make_hall("principled")
    if arguments.scene_only:
        make_hall("basic")
        return
    views = render_views(scene, arguments.samples)
    strip = OUT / "demo.png"
    if not is_newer(strip, [*views, HERE.parent / "tools/sheet.py"]):
        labels = [f"{sphere_d} DS" for sphere_d in SPHERES_D]
        make_sheet(strip, [Row(list(map(Panel, views, labels)))], SIZE_PX, LABEL_PX)
    print(strip)


if __name__ == "__main__":
    main()
