"""Blur too narrow to see is rendered without the lens; where the lens comes in, no step shows."""

import sys
from pathlib import Path

import eyecore
import numpy as np
import pytest
from materials import add_light

sys.path.append(str(Path(__file__).parents[1]))
from tools.display import to_display  # noqa: E402

PIXEL = 1e-3  # of slope
PUPIL_MM = 4.0
SWITCH_PX = 0.125


def edge_columns(blur_px: float, seed: int) -> tuple[str, np.ndarray]:
    """The plan, and the columns' means of a far white half-plane, its edge between two pixels."""
    scene = eyecore.Scene()
    white = add_light(scene, "white", 1.0)
    far_m = 1e5
    corners = np.array([[0, -1, -1], [1, -1, -1], [1, 1, -1], [0, 1, -1]], np.float32) * far_m
    mesh = scene.add_mesh("half", corners, np.array([[0, 1, 2], [0, 2, 3]], np.uint32))
    scene.add_instances(mesh, np.eye(4)[None], [white])
    half_x, half_y = 4.0 * PIXEL, 64.0 * PIXEL
    scene.set_camera(
        np.eye(4), (-half_x, half_x, -half_y, half_y), (8, 128), clip=(0.9 * far_m, 2.0 * far_m)
    )
    error_d = blur_px * PIXEL / (PUPIL_MM * 1e-3)
    observer = eyecore.Observer(
        rx=eyecore.Prescription(-error_d), rx_plane="entrance_pupil", pupil=PUPIL_MM
    )
    settings = eyecore.Settings(samples=2048, seed=seed)
    plan = eyecore.Session(scene, observer, settings).plan_text
    picture = eyecore.render(scene, observer, settings)["Combined"][:, :, 0]
    return plan, picture.astype(np.float64).mean(axis=0)


def test_focus_is_pulled_without_a_step() -> None:
    (plan, before), (plan_after, after) = (
        edge_columns(share * SWITCH_PX, seed) for share, seed in ((0.99, 1), (1.01, 2))
    )
    assert "lens: pinhole" in plan and "lens: sampled" in plan_after
    noise = np.abs(edge_columns(0.99 * SWITCH_PX, 3)[1] - before).max()
    # 2048 Sobol points in 128 rows know the edge well enough to tell the step.
    assert noise < 5e-4
    step = np.abs(after - before).max()
    assert step < 0.001 + noise
    assert 255.0 * np.abs(to_display(after) - to_display(before)).max() < 1.0


def test_a_blur_that_shows_is_rendered() -> None:
    """Of a pixel: by convolution of filter and disk the pixels beside the edge lose 0.0370."""
    _, sharp = edge_columns(0.0, 1)
    _, blurred = edge_columns(1.0, 1)
    assert np.abs(blurred - sharp).max() == pytest.approx(0.0370, abs=1e-3)
