"""Renders the open file once, small, and notes time and memory. Inside Blender:

blender -b --factory-startup --addons eye_render FILE.blend --python render_large_scene.py -- \
    CYCLES|EYE_RENDER FOUND.json

FOUND: "seconds" of the render, "cpu_seconds" of all its threads, "memory_mb" that it took at most
beyond the loaded file, and for Eye Render the seconds of "export" and "build".
"""

import json
import sys
import time
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tools.engines import SET_UP  # noqa: E402

SIZE_PX = 64


def memory_mb(field: str) -> float:
    """VmRSS or VmHWM of this process."""
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(field):
            return int(line.split()[1]) / 1024
    raise ValueError(f"this system does not tell {field}")


def time_calls(owner, name: str, seconds: dict[str, float], part: str) -> None:
    """Notes how long the calls of a function of `owner` take."""
    call = getattr(owner, name)

    def timed(*arguments, **keywords):
        start = time.monotonic()
        result = call(*arguments, **keywords)
        seconds[part] = seconds.get(part, 0.0) + time.monotonic() - start
        return result

    setattr(owner, name, timed)


def main(engine: str, found: Path) -> None:
    scene = bpy.context.scene
    SET_UP[engine](scene, 1, 1, 1)
    scene.render.resolution_x = scene.render.resolution_y = SIZE_PX
    scene.render.resolution_percentage = 100
    parts: dict[str, float] = {}
    if engine == "EYE_RENDER":
        from eye_render import export, session

        time_calls(export, "export_scene", parts, "export")
        time_calls(session.RenderSession, "__init__", parts, "build")
    Path("/proc/self/clear_refs").write_text("5")  # the peak begins here
    before_mb = memory_mb("VmRSS")
    start, start_cpu = time.monotonic(), time.process_time()
    bpy.ops.render.render()
    seconds, cpu_seconds = time.monotonic() - start, time.process_time() - start_cpu
    memory = memory_mb("VmHWM") - before_mb
    found.write_text(
        json.dumps(parts | {"seconds": seconds, "cpu_seconds": cpu_seconds, "memory_mb": memory})
    )


main(sys.argv[-2], Path(sys.argv[-1]))
