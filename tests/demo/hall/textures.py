"""Image textures painted with NumPy and packed into the .blend: marble floor, stone blocks with
their normal map, cloth, a UV grid. All repeat without a seam."""

import bpy
import numpy as np

SIZE_PX = 1024


def _noise(seed: int, slope: float) -> np.ndarray:
    """Seamless noise with a power-law spectrum, mean 0, standard deviation 1."""
    white = np.random.default_rng(seed).standard_normal((SIZE_PX, SIZE_PX))
    fx, fy = np.fft.fftfreq(SIZE_PX)[:, None], np.fft.rfftfreq(SIZE_PX)[None, :]
    frequency = np.hypot(fx, fy)
    frequency[0, 0] = np.inf
    field = np.fft.irfft2(np.fft.rfft2(white) * frequency**-slope, s=white.shape)
    return (field - field.mean()) / field.std()


def _mix(a, b, t: np.ndarray) -> np.ndarray:
    return np.asarray(a) + (np.asarray(b) - np.asarray(a)) * t[..., None]


def _cells(rows: int, columns: int, shift: float):
    """(row, column, distance to the cell's edge in texture units) of each pixel; every second row
    is shifted by `shift` cells."""
    v, u = np.mgrid[0:SIZE_PX, 0:SIZE_PX] / SIZE_PX
    row = np.floor(v * rows).astype(int)
    along = u * columns + shift * (row % 2)
    column = np.floor(along).astype(int) % columns
    fraction_u, fraction_v = along % 1, (v * rows) % 1
    edge = np.minimum(
        np.minimum(fraction_u, 1 - fraction_u) / columns,
        np.minimum(fraction_v, 1 - fraction_v) / rows,
    )
    return row, column, edge


def _image(name: str, rgb: np.ndarray, is_data=False) -> bpy.types.Image:
    image = bpy.data.images.new(name, SIZE_PX, SIZE_PX, alpha=False, is_data=is_data)
    rgba = np.ones((SIZE_PX, SIZE_PX, 4), np.float32)
    rgba[..., :3] = np.clip(rgb, 0, 1)
    image.pixels.foreach_set(rgba.ravel())
    image.pack()
    return image


def floor() -> bpy.types.Image:
    """Two by two marble slabs, light and dark, with veins and a thin joint."""
    row, column, edge = _cells(2, 2, 0)
    veins = np.exp(-6 * np.abs(_noise(1, 1.6)))
    cloud = 0.5 + 0.18 * _noise(2, 1.5)
    light = _mix((0.80, 0.76, 0.69), (0.62, 0.55, 0.47), np.clip(cloud * 0.4 + veins * 0.6, 0, 1))
    dark = _mix((0.30, 0.16, 0.13), (0.62, 0.50, 0.44), np.clip(cloud * 0.25 + veins * 0.5, 0, 1))
    rgb = np.where(((row + column) % 2)[..., None], dark, light)
    return _image("floor", rgb * np.clip(0.35 + edge * 260, 0, 1)[..., None])


def _stone_height():
    row, column, edge = _cells(6, 3, 0.5)
    joint = np.clip(edge * 110, 0, 1)
    tint = np.random.default_rng(5).uniform(-1, 1, (6, 3))[row, column]
    return joint, tint, _noise(6, 1.3)


def stone() -> bpy.types.Image:
    """Sandstone blocks, six courses, each block its own tint."""
    joint, tint, grain = _stone_height()
    tone = np.clip(0.5 + 0.22 * tint + 0.10 * grain, 0, 1)
    rgb = _mix((0.62, 0.53, 0.42), (0.80, 0.73, 0.62), tone)
    return _image("stone", rgb * (0.6 + 0.4 * joint)[..., None])


def stone_normal() -> bpy.types.Image:
    """Tangent-space normals of `stone`, OpenGL's convention (green is up)."""
    joint, tint, grain = _stone_height()
    height_px = 9 * joint + 1.5 * tint * joint + 0.7 * grain
    du = (np.roll(height_px, -1, 1) - np.roll(height_px, 1, 1)) / 2
    dv = (np.roll(height_px, -1, 0) - np.roll(height_px, 1, 0)) / 2
    normal = np.stack([-du, -dv, np.ones_like(du)], axis=-1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    return _image("stone normal", normal * 0.5 + 0.5, is_data=True)


def plaster() -> bpy.types.Image:
    tone = np.clip(0.5 + 0.16 * _noise(8, 1.4), 0, 1)
    return _image("plaster", _mix((0.70, 0.63, 0.53), (0.85, 0.80, 0.71), tone))


def cloth() -> bpy.types.Image:
    """Stripes and a border to be tinted by no one: red and ochre."""
    v, u = np.mgrid[0:SIZE_PX, 0:SIZE_PX] / SIZE_PX
    stripe = (np.sin(2 * np.pi * 8 * u) > 0.55).astype(float)
    border = ((v % 1 < 0.05) | (np.abs(v - 0.09) < 0.012)).astype(float)
    thread = 0.9 + 0.1 * np.sin(2 * np.pi * 256 * u) * np.sin(2 * np.pi * 256 * v)
    rgb = _mix((0.56, 0.07, 0.07), (0.80, 0.56, 0.20), np.maximum(stripe * 0.5, border))
    return _image("cloth", rgb * thread[..., None])


def grid() -> bpy.types.Image:
    """A UV grid: hue by column, brightness by row, white lines."""
    row, column, edge = _cells(8, 8, 0)
    hue = column / 8.0 * 2 * np.pi
    rgb = np.stack([0.5 + 0.4 * np.cos(hue - k * 2 * np.pi / 3) for k in range(3)], axis=-1)
    rgb = rgb * (0.45 + 0.55 * row / 7.0)[..., None]
    return _image("grid", np.where((edge < 0.006)[..., None], 0.95, rgb))
