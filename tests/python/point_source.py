"""A small bright disk on black, rendered through an eye: shared by the tests of its picture."""

import eyecore
import numpy as np
from materials import add_light

DISTANCE_M = 2.0
SIZE_PX = 112
SAMPLES = 512


def disk_scene(disk_slope: float, half_slope: float) -> eyecore.Scene:
    scene = eyecore.Scene()
    light = add_light(scene, "light")
    angles = np.linspace(0.0, 2.0 * np.pi, 256, endpoint=False)
    rim = (
        DISTANCE_M * disk_slope * np.stack([np.cos(angles), np.sin(angles), 0.0 * angles], axis=1)
    )
    positions = np.concatenate([[[0.0, 0.0, 0.0]], rim]).astype(np.float32)
    corners = np.arange(256, dtype=np.uint32)
    triangles = np.stack([0 * corners, 1 + corners, 1 + (corners + 1) % 256], axis=1)
    at_distance = np.eye(4)
    at_distance[2, 3] = -DISTANCE_M
    mesh = scene.add_mesh("disk", positions, triangles)
    scene.add_instances(mesh, at_distance[None], [light])
    bounds = (-half_slope, half_slope, -half_slope, half_slope)
    scene.set_camera(np.eye(4), bounds, (SIZE_PX, SIZE_PX))
    return scene


def disk_picture(
    observer: eyecore.Observer, extent: float, disk_share: float = 0.15, **settings
) -> tuple[np.ndarray, np.ndarray]:
    """Channel 0 of the picture and the slopes (2, pixels) of its pixels' centres. `extent` is the
    radius of the blur, of which the disk's own is a share."""
    half_slope = 1.25 * extent * (1.0 + disk_share)
    picture = eyecore.render(
        disk_scene(disk_share * extent, half_slope),
        observer,
        eyecore.Settings(samples=SAMPLES, seed=5, **settings),
    )["Combined"][:, :, 0].astype(np.float64)
    assert picture[0].max() == picture[-1].max() == 0.0, "the blur must fit the picture"
    slopes = (np.arange(SIZE_PX) + 0.5) * 2.0 * half_slope / SIZE_PX - half_slope
    y, x = np.meshgrid(slopes, slopes, indexing="ij")
    return picture, np.stack([x.ravel(), y.ravel()])
