"""What many lamps cost: processor time a sample on a floor under point lamps, beside one lamp.

PYTHONPATH=build/bindings python3 tests/bench/many_lamps.py
"""

import time

import eyecore
import numpy as np

SIZE_PX = 128
SAMPLES = 16
COUNTS = (1, 10, 100, 1000)
RUNS = 3


def floor_under(lamps: int, radius: float) -> eyecore.Scene:
    random = np.random.default_rng(2)
    scene = eyecore.Scene()
    diffuse = eyecore.NodeGraph().add("BSDF_DIFFUSE", {"Color": 0.8})
    white = scene.add_material("white", diffuse["BSDF"])
    corners = np.array([[-4, -4, 0], [4, -4, 0], [4, 4, 0], [-4, 4, 0]], np.float32)
    floor = scene.add_mesh("floor", corners, np.array([[0, 1, 2], [0, 2, 3]], np.uint32))
    scene.add_instances(floor, np.eye(4)[None], [white])
    for number in range(lamps):
        at = np.eye(4)
        at[:3, 3] = [*random.uniform(-3.0, 3.0, 2), 0.4]
        color = tuple(random.uniform(0.1, 1.0, 3) * 300.0 / lamps)
        scene.add_light(f"lamp {number}", "POINT", at, color, radius=radius)
    above = np.eye(4)
    above[2, 3] = 8.0
    scene.set_camera(above, (-0.5, 0.5, -0.5, 0.5), (SIZE_PX, SIZE_PX))
    return scene


def seconds_a_sample(scene: eyecore.Scene) -> float:
    """The least of some runs."""
    found = []
    for _ in range(RUNS):
        settings = eyecore.Settings(samples=SAMPLES, threads=1)
        session = eyecore.Session(scene, eyecore.Observer(model="pinhole"), settings)
        begin = time.process_time()
        session.start()
        while not session.wait(10.0):
            pass
        found.append((time.process_time() - begin) / (SIZE_PX**2 * SAMPLES))
    return min(found)


for radius in (0.0, 0.02):
    one = None
    for count in COUNTS:
        seconds = seconds_a_sample(floor_under(count, radius))
        one = one or seconds
        ratio = seconds / one
        print(f"{count:5} lamps of radius {radius}: {1e6 * seconds:.2f} us a sample, {ratio:.2f}")
