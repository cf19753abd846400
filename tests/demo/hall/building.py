"""The architecture: a nave 8 m wide and 40 m deep along +y between two storeys of arcades, open to
the sky, with aisles behind the columns. The eye stands at the origin, 2 m inside."""

import numpy as np

from .patches import Patch, arch_wall, archivolt, box, lathe, make_mesh, place, rectangle, rounded

NEAR_M, FAR_M = -2.0, 38.0
BAY_M = 4.0
BAYS = 10
NAVE_HALF_M, WALL_M = 4.0, 7.2  # |x| of the column axes and of the outer walls
SPRING_M, GALLERY_M, EAVES_M = 4.2, 6.7, 11.2  # z of the arches' spring, gallery floor, top
UPPER_SPRING_M = 9.3
THICKNESS_M = 0.62


def build(materials) -> None:
    stone, marble, plaster = materials["stone"], materials["marble"], materials["plaster"]
    _shell(materials["floor"], stone, plaster)
    for side in (-1, 1):
        _arcade(side, stone, marble)
        _gallery(side, stone, marble)
    _end_wall(stone, marble, materials["wood"])


def _shell(floor, stone, plaster):
    low, high = (-WALL_M, NEAR_M), (WALL_M, FAR_M)
    ground = rectangle((*low, 0), (high[0], low[1], 0), (*high, 0), (low[0], high[1], 0))
    place("floor", make_mesh("floor", [ground], [floor]))
    walls = [
        rectangle(
            (-WALL_M, NEAR_M, 0),
            (-WALL_M, FAR_M, 0),
            (-WALL_M, FAR_M, EAVES_M),
            (-WALL_M, NEAR_M, EAVES_M),
        ),
        rectangle(
            (WALL_M, FAR_M, 0),
            (WALL_M, NEAR_M, 0),
            (WALL_M, NEAR_M, EAVES_M),
            (WALL_M, FAR_M, EAVES_M),
        ),
        rectangle(
            (WALL_M, NEAR_M, 0),
            (-WALL_M, NEAR_M, 0),
            (-WALL_M, NEAR_M, EAVES_M),
            (WALL_M, NEAR_M, EAVES_M),
        ),
        rectangle(
            (-WALL_M, FAR_M, 0),
            (WALL_M, FAR_M, 0),
            (WALL_M, FAR_M, EAVES_M),
            (-WALL_M, FAR_M, EAVES_M),
        ),
    ]
    place("walls", make_mesh("walls", walls, [plaster]))
    slabs = []
    for side in (-1, 1):
        inner, outer = side * (NAVE_HALF_M - 0.36), side * WALL_M
        x0, x1 = min(inner, outer), max(inner, outer)
        slabs += box((x0, NEAR_M, GALLERY_M - 0.3), (x1, FAR_M, GALLERY_M))
        slabs += box((x0, NEAR_M, EAVES_M), (x1, FAR_M, EAVES_M + 0.3))
    place("slabs", make_mesh("slabs", slabs, [stone]))


def _column(height_m, radius_m, flutes, steps, materials):
    """A fluted shaft with entasis on a round base, under a bell capital and a square abacus."""
    r, base_m, capital_m = radius_m, 0.9 * radius_m, 1.7 * radius_m
    top_m = height_m - capital_m
    base = rounded(
        [
            (1.5 * r, 0),
            (1.5 * r, 0.2 * r),
            (1.32 * r, 0.32 * r),
            (1.2 * r, 0.5 * r),
            (1.3 * r, 0.68 * r),
            (1.04 * r, base_m),
        ],
        steps,
    )
    z = np.linspace(base_m, top_m, 3 * steps)
    t = (z - base_m) / (top_m - base_m)
    shaft = np.stack([r * (1 - 0.16 * t**1.8), z], axis=-1)
    neck_r = 0.84 * r
    capital = rounded(
        [
            (neck_r, top_m),
            (1.12 * r, top_m + 0.12 * r),
            (0.9 * r, top_m + 0.3 * r),
            (0.98 * r, top_m + 0.8 * r),
            (1.35 * r, height_m - 0.4 * r),
            (1.45 * r, height_m - 0.3 * r),
        ],
        steps,
    )
    angle = np.linspace(0, 2 * np.pi, 6 * flutes + 1)
    groove = 1 - 0.05 * np.abs(np.sin(angle * flutes / 2)) ** 0.6
    leaves = 1 + 0.07 * np.cos(8 * np.linspace(0, 2 * np.pi, 8 * steps + 1))
    half = 1.5 * r
    return make_mesh(
        "column",
        [
            lathe(base, 8 * steps),
            lathe(shaft, 6 * flutes, groove),
            lathe(capital, 8 * steps, leaves),
            *box((-half, -half, height_m - 0.32 * r), (half, half, height_m)),
            *box((-1.6 * r, -1.6 * r, -0.02), (1.6 * r, 1.6 * r, 0.1 * r)),
        ],
        materials,
    )


def _arcade(side, stone, marble):
    """Columns every bay, round arches between them, a frieze up to the gallery floor."""
    column = _column(SPRING_M, 0.34, 20, 6, [marble])
    for k in range(BAYS + 1):
        place("column", column, (side * NAVE_HALF_M, NEAR_M + k * BAY_M, 0))
    radius_m = BAY_M / 2 - 0.42
    arch = arch_wall(BAY_M, radius_m, SPRING_M, GALLERY_M - 0.3, THICKNESS_M, 48)
    for x_m in (-THICKNESS_M / 2, THICKNESS_M / 2):
        moulding = archivolt(BAY_M, radius_m, SPRING_M, x_m, 0.3)
        arch.append(Patch(moulding.points, moulding.uv, slot=1))
    mesh = make_mesh("arch", arch, [stone, marble])
    for k in range(BAYS):
        place("arch", mesh, (side * NAVE_HALF_M, NEAR_M + k * BAY_M, 0))


def _gallery(side, stone, marble):
    """Half-size columns and arches, a balustrade, and the cornices that close both storeys."""
    column = _column(UPPER_SPRING_M - GALLERY_M, 0.17, 12, 4, [marble])
    half_bay_m = BAY_M / 2
    for k in range(2 * BAYS + 1):
        place("gallery column", column, (side * NAVE_HALF_M, NEAR_M + k * half_bay_m, GALLERY_M))
    radius_m = half_bay_m / 2 - 0.22
    arch = arch_wall(half_bay_m, radius_m, UPPER_SPRING_M, EAVES_M, 0.4, 32)
    moulding = archivolt(half_bay_m, radius_m, UPPER_SPRING_M, -side * 0.2, 0.16)
    arch.append(Patch(moulding.points, moulding.uv, slot=1))
    mesh = make_mesh("gallery arch", arch, [stone, marble])
    rail = make_mesh("balustrade", _balustrade(half_bay_m), [marble])
    for k in range(2 * BAYS):
        y_m = NEAR_M + k * half_bay_m
        place("gallery arch", mesh, (side * NAVE_HALF_M, y_m, 0))
        place("balustrade", rail, (side * (NAVE_HALF_M - 0.22), y_m, GALLERY_M))
    for z_m, reach_m in ((GALLERY_M - 0.42, 0.5), (EAVES_M - 0.1, 0.6)):
        place("cornice", make_mesh("cornice", [_cornice(side, z_m, reach_m)], [marble]))


def _balustrade(length_m):
    profile = rounded(
        [
            (0.05, 0.1),
            (0.055, 0.16),
            (0.03, 0.2),
            (0.062, 0.34),
            (0.066, 0.42),
            (0.034, 0.62),
            (0.03, 0.7),
            (0.052, 0.76),
            (0.05, 0.8),
        ],
        2,
    )
    baluster = lathe(profile, 16)
    patches = box((-0.09, 0, 0), (0.09, length_m, 0.1)) + box(
        (-0.1, 0, 0.8), (0.1, length_m, 0.92)
    )
    return patches + [baluster.moved(y=(k + 0.5) * length_m / 8) for k in range(8)]


def _cornice(side, z_m, reach_m):
    profile = np.array(
        [
            (0, 0),
            (0.25, 0.02),
            (0.3, 0.1),
            (0.55, 0.16),
            (0.7, 0.3),
            (0.95, 0.34),
            (1, 0.38),
            (1, 0.5),
            (0, 0.52),
        ]
    )
    x = side * (NAVE_HALF_M - 0.2 - (reach_m - 0.1) * profile[:, 0])
    y = np.linspace(NEAR_M, FAR_M, 2)
    points = np.stack(np.broadcast_arrays(x[:, None], y, (z_m + profile[:, 1])[:, None]), axis=-1)
    uv = np.stack(np.broadcast_arrays(y, profile[:, 1][:, None]), axis=-1)
    return Patch(points if side > 0 else points[::-1], uv, smooth=False)


def _end_wall(stone, marble, wood):
    """Blind arches over two doors, and a row of small ones above, close the view."""
    arches = []
    for k in range(2):
        arches += [
            p.moved(y=k * BAY_M)
            for p in arch_wall(BAY_M, 1.5, SPRING_M, GALLERY_M, THICKNESS_M, 48)
        ]
        moulding = archivolt(BAY_M, 1.5, SPRING_M, THICKNESS_M / 2, 0.3).moved(y=k * BAY_M)
        arches.append(Patch(moulding.points, moulding.uv, slot=1))
    mesh = make_mesh("end arches", arches, [stone, marble])
    # Turned so that the wall's +x face looks back along -y.
    place("end arches", mesh, (-NAVE_HALF_M, FAR_M - 0.5, 0), (0, 0, -np.pi / 2))
    column = _column(SPRING_M, 0.34, 20, 6, [marble])
    place("end column", column, (0, FAR_M - 0.5, 0))
    small_span_m, small_radius_m = BAY_M / 2, BAY_M / 4 - 0.22
    small = arch_wall(small_span_m, small_radius_m, UPPER_SPRING_M, EAVES_M, 0.4, 32)
    moulding = archivolt(small_span_m, small_radius_m, UPPER_SPRING_M, 0.2, 0.16)
    small.append(Patch(moulding.points, moulding.uv, slot=1))
    small_mesh = make_mesh("end gallery arch", small, [stone, marble])
    small_column = _column(UPPER_SPRING_M - GALLERY_M, 0.17, 12, 4, [marble])
    for k in range(4):
        x_m = -NAVE_HALF_M + k * small_span_m
        place("end gallery arch", small_mesh, (x_m, FAR_M - 0.5, 0), (0, 0, -np.pi / 2))
        place("end gallery column", small_column, (x_m, FAR_M - 0.5, GALLERY_M))
    for x_m in (-BAY_M / 2, BAY_M / 2):
        panels = []
        for i in range(2):
            for j in range(4):
                panels += box(
                    (-1.2 + 1.22 * i, -0.1, 0.15 + 1.0 * j), (-0.02 + 1.22 * i, 0, 1.05 + j)
                )
        place("door", make_mesh("door", panels, [wood]), (x_m, FAR_M - 0.02, 0))
