"""Meshes made of quad patches. A patch is a grid of points (m) with texture coordinates; every
column, arch, curtain and baluster of the hall is a few of them in one mesh."""

from dataclasses import dataclass

import bpy
import numpy as np

from .materials import tile_m


@dataclass
class Patch:
    points: np.ndarray  # (nu, nv, 3), metres; the outside is on the side of d/du x d/dv
    uv: np.ndarray  # (nu, nv, 2), metres along the surface
    slot: int = 0  # index into the mesh's materials
    smooth: bool = True

    def moved(self, x=0.0, y=0.0, z=0.0) -> "Patch":
        return Patch(self.points + np.array([x, y, z]), self.uv, self.slot, self.smooth)


def lathe(profile, segments: int, radius_factor=1.0) -> Patch:
    """Turns `profile`, rows of (radius, z) from bottom to top, about the z axis. `radius_factor`
    may vary with the angle (segments + 1 values): flutes."""
    profile = np.asarray(profile, float)
    angle = np.linspace(0, 2 * np.pi, segments + 1)
    radius = np.multiply.outer(np.broadcast_to(radius_factor, angle.shape), profile[:, 0])
    points = np.stack(
        [
            radius * np.cos(angle)[:, None],
            radius * np.sin(angle)[:, None],
            np.broadcast_to(profile[:, 1], radius.shape),
        ],
        axis=-1,
    )
    girth_m = 2 * np.pi * profile[:, 0].mean()
    along_m = np.concatenate([[0], np.hypot(*np.diff(profile, axis=0).T).cumsum()])
    uv = np.stack(np.broadcast_arrays(girth_m * (angle / (2 * np.pi))[:, None], along_m), axis=-1)
    return Patch(points, uv)


def rounded(profile, steps: int) -> np.ndarray:
    """The profile as a Catmull-Rom spline, `steps` points a span."""
    p = np.asarray(profile, float)
    p = np.vstack([2 * p[0] - p[1], p, 2 * p[-1] - p[-2]])
    t = np.linspace(0, 1, steps, endpoint=False)[:, None]
    spans = []
    for a, b, c, d in zip(p, p[1:], p[2:], p[3:], strict=False):
        spans.append(
            0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t**2)
            + 0.5 * (3 * b - a - 3 * c + d) * t**3
        )
    return np.vstack([*spans, p[-2:-1]])


def box(low, high, slot=0) -> list[Patch]:
    """Six flat sides, texture coordinates in metres."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    sides = [
        [(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)],
        [(x1, y1, z0), (x0, y1, z0), (x0, y1, z1), (x1, y1, z1)],
        [(x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)],
        [(x0, y1, z0), (x0, y0, z0), (x0, y0, z1), (x0, y1, z1)],
        [(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)],
        [(x0, y1, z0), (x1, y1, z0), (x1, y0, z0), (x0, y0, z0)],
    ]
    return [rectangle(*side, slot=slot) for side in sides]


def rectangle(a, b, c, d, slot=0) -> Patch:
    """The quadrilateral a, b, c, d, counter-clockwise seen from outside."""
    a, b, c, d = (np.asarray(corner, float) for corner in (a, b, c, d))
    width_m, height_m = np.linalg.norm(b - a), np.linalg.norm(d - a)
    uv = [[(0, 0), (0, height_m)], [(width_m, 0), (width_m, height_m)]]
    return Patch(np.array([[a, d], [b, c]]), np.array(uv, float), slot, smooth=False)


def arch_wall(span_m, radius_m, spring_m, top_m, depth_m, steps=32) -> list[Patch]:
    """A wall along y, `depth_m` thick in x, from y = 0 to `span_m`, above an opening with a
    half-round arch that springs at z = `spring_m`."""
    angle = np.linspace(np.pi, 0, steps + 1)
    y = span_m / 2 + radius_m * np.cos(angle)
    z = spring_m + radius_m * np.sin(angle)
    # Over the arch's ends the wall starts at the spring line, so the strip goes to the edge there.
    y = np.concatenate([[0, y[0]], y[1:-1], [y[-1], span_m]])
    z = np.concatenate([[spring_m, spring_m], z[1:-1], [spring_m, spring_m]])
    half = depth_m / 2

    def face(x, flip):
        low = np.stack([np.full_like(y, x), y, z], axis=-1)
        high = np.stack([np.full_like(y, x), y, np.full_like(y, top_m)], axis=-1)
        points = np.stack([low, high], axis=1)
        return Patch(
            points[::-1] if flip else points, points[..., 1:][:: -1 if flip else 1], smooth=False
        )

    soffit = np.stack(
        [np.stack([np.full_like(y, x), y, z], axis=-1) for x in (-half, half)], axis=1
    )
    along_m = np.concatenate([[0], np.hypot(np.diff(y), np.diff(z)).cumsum()])
    uv = np.stack(np.broadcast_arrays(along_m[:, None], np.array([0, depth_m])), axis=-1)
    return [face(half, False), face(-half, True), Patch(soffit, uv)]


def archivolt(span_m, radius_m, spring_m, x_m, width_m, steps=48) -> Patch:
    """A moulding round the arch of `arch_wall`, on its face at x = `x_m`."""
    bend = np.linspace(0, np.pi, 17)
    ripple = 1 + 0.18 * np.cos(6 * bend)
    outward = np.sign(x_m) * 0.45 * width_m * np.sin(bend) * ripple
    radius = radius_m + width_m * (1 - np.cos(bend)) / 2
    angle = np.linspace(0, np.pi, steps + 1)
    points = np.stack(
        np.broadcast_arrays(
            x_m + outward,
            span_m / 2 + radius * np.cos(angle)[:, None],
            spring_m + radius * np.sin(angle)[:, None],
        ),
        axis=-1,
    )
    uv = np.stack(np.broadcast_arrays(radius_m * angle[:, None], width_m * bend), axis=-1)
    return Patch(points if x_m > 0 else points[::-1], uv)


def make_mesh(name: str, patches: list[Patch], materials) -> bpy.types.Mesh:
    """One mesh of all patches; texture coordinates are repeats of each material's image."""
    points, faces, uv, slots, smooth = [], [], [], [], []
    first = 0
    for patch in patches:
        nu, nv = patch.points.shape[:2]
        index = first + np.arange(nu * nv).reshape(nu, nv)
        quads = np.stack(
            [index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]], axis=-1
        ).reshape(-1, 4)
        points.append(patch.points.reshape(-1, 3))
        faces.append(quads)
        repeats = patch.uv.reshape(-1, 2) / tile_m(materials[patch.slot])
        uv.append(repeats[quads - first].reshape(-1, 2))
        slots.append(np.full(len(quads), patch.slot, np.int32))
        smooth.append(np.full(len(quads), patch.smooth))
        first += nu * nv

    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(np.vstack(points).tolist(), [], np.vstack(faces).tolist())
    mesh.uv_layers.new(name="UVMap").data.foreach_set(
        "uv", np.vstack(uv).astype(np.float32).ravel()
    )
    mesh.polygons.foreach_set("material_index", np.concatenate(slots))
    mesh.polygons.foreach_set("use_smooth", np.concatenate(smooth))
    for material in materials:
        mesh.materials.append(material)
    mesh.update()
    return mesh


def place(name: str, data, location=(0, 0, 0), rotation=(0, 0, 0), scale=(1, 1, 1)):
    """A new object of the scene; `rotation` in radians, XYZ."""
    thing = bpy.data.objects.new(name, data)
    thing.location, thing.rotation_euler, thing.scale = location, rotation, scale
    bpy.context.scene.collection.objects.link(thing)
    return thing
