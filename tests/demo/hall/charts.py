"""Letter charts at five distances. All look the same size from the eye, letters of 100, 70, 50,
35 and 25 arcmin, so what differs between them is blur alone. At 512 pixels over 48 degrees one
pixel is 5.7 arcmin; letters of 5 arcmin (20/20) need a picture ten times as wide."""

import math

import bpy

from .patches import box, make_mesh, place

EYE_HEIGHT_M = 1.5
LETTER_ARCMIN = (100, 70, 50, 35, 25)
CAPTION_ARCMIN = 30
# Sloan's ten letters; no row repeats one.
ROWS = ("NK", "HZR", "DVSC", "KONRH", "ZSVDCO")
GAP = 0.55  # between rows, of the row's letter height
LETTER_SPACING = 1.35

# Distance of the chart's plane from the eye along +y, and where it stands seen from the eye.
CHARTS = (
    # distance_m, right_deg, up_deg
    (0.4, -14.5, -11.5),
    (1.0, 13.5, -11.0),
    (3.0, -8.6, -1.0),
    (10.0, 9.0, 0.2),
    (30.0, 0.3, 7.0),
)


def metres(arcmin: float, distance_m: float) -> float:
    return distance_m * math.tan(math.radians(arcmin / 60))


def build(materials) -> None:
    for distance_m, right_deg, up_deg in CHARTS:
        center = (
            distance_m * math.tan(math.radians(right_deg)),
            distance_m,
            EYE_HEIGHT_M + distance_m * math.tan(math.radians(up_deg)),
        )
        size = _board(distance_m, center, materials)
        _letters(distance_m, center, size[1], materials["ink"])
        _support(distance_m, center, size, materials["iron"])


def _board(distance_m, center, materials):
    """White paper with a dark frame behind; returns its width and height."""
    rows_arcmin = sum(LETTER_ARCMIN) * (1 + GAP) + CAPTION_ARCMIN * (1 + GAP)
    width = metres(max(map(_row_arcmin, ROWS, LETTER_ARCMIN)) + 70, distance_m)
    height = metres(rows_arcmin + 50, distance_m)
    rim, depth = metres(10, distance_m), metres(8, distance_m)
    w, h = width / 2, height / 2
    frame = box((-w - rim, depth * 0.2, -h - rim), (w + rim, depth, h + rim), slot=1)
    paper = box((-w, 0, -h), (w, depth, h))
    mesh = make_mesh("chart", paper + frame, [materials["paper"], materials["iron"]])
    place(f"chart {distance_m:g} m", mesh, center)
    return width, height


def _row_arcmin(row: str, letter_arcmin: float) -> float:
    return letter_arcmin * (0.8 + LETTER_SPACING * (len(row) - 1))


def _letters(distance_m, center, height, ink):
    x, y, z = center
    top = z + height / 2 - metres(40, distance_m)
    front = y - metres(1, distance_m)
    rows = [*zip(ROWS, LETTER_ARCMIN, strict=True), (f"{distance_m:g} m", CAPTION_ARCMIN)]
    for row, letter_arcmin in rows:
        letter_m = metres(letter_arcmin, distance_m)
        is_caption = letter_arcmin == CAPTION_ARCMIN
        pieces = [row] if is_caption else row
        for k, text in enumerate(pieces):
            offset = (k - (len(pieces) - 1) / 2) * LETTER_SPACING * letter_m
            _text(text, (x + offset, front, top - letter_m), letter_m, ink)
        top -= letter_m * (1 + GAP)


def _text(text: str, location, letter_m: float, ink) -> None:
    """Upright, facing the eye, its capitals `letter_m` high."""
    curve = bpy.data.curves.new(f"letters {text}", "FONT")
    curve.body = text
    curve.align_x = "CENTER"
    curve.size = letter_m / _capital_height()
    curve.materials.append(ink)
    place(curve.name, curve, location, (math.pi / 2, 0, 0))


def _capital_height() -> float:
    """Of Blender's own font at size 1, measured once on an H."""
    name = "capital height"
    curve = bpy.data.curves.get(name)
    if curve is None:
        curve = bpy.data.curves.new(name, "FONT")
        curve.body = "H"
        thing = place(name, curve)
        bpy.context.view_layer.update()
        curve["capital_height"] = thing.dimensions.y
        bpy.data.objects.remove(thing)
        curve.use_fake_user = True
    return curve["capital_height"]


def _support(distance_m, center, size, iron):
    """Two legs to the floor; the nearest charts stand on rods of the desk, the farthest hangs."""
    x, y, z = center
    half_w, half_h = size[0] / 2, size[1] / 2
    thick = metres(9, distance_m)
    if distance_m > 20:
        bar = box((-5, 0, -0.06), (5, 0.12, 0.06)), (x, y, z + half_h + 0.15)
        place("rod", make_mesh("rod", bar[0], [iron]), bar[1])
        return
    for side in (-1, 1) if distance_m > 2 else (0,):
        foot = 0.0 if distance_m > 2 else 1.17
        low = (-thick / 2, 0, foot - z)
        leg = box(low, (thick / 2, thick, -half_h))
        place("leg", make_mesh("leg", leg, [iron]), (x + side * half_w * 0.7, y + thick * 0.2, z))
