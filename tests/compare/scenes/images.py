"""Image textures and where their pictures come from."""

import tempfile
from pathlib import Path

import bpy
import numpy as np
from features import feature
from stage import (
    BALL_CENTRE,
    GREY,
    add,
    ball_mesh,
    camera,
    dressed,
    shows,
    tiles,
    wall,
    world,
)
from tools.meshes import cube_mesh
from tree import Tree, out

SIZE = 8


def pixels(seed: int = 5, size: int = SIZE) -> np.ndarray:
    """Blocks of any colour, a brighter row below and a darker column at the left."""
    picture = np.ones((size, size, 4), np.float32)
    picture[..., :3] = np.random.default_rng(seed).uniform(0.1, 0.9, (size, size, 3))
    picture[0, :, 0] = 1.0
    picture[:, 0, 1] = 0.05
    return picture


def packed(name: str, picture: np.ndarray, colorspace: str = "sRGB") -> bpy.types.Image:
    height, width, _ = picture.shape
    image = bpy.data.images.new(name, width, height, alpha=True)
    image.colorspace_settings.name = colorspace
    image.pixels.foreach_set(picture.ravel())
    image.pack()
    return image


def saved(name: str, picture: np.ndarray, folder: Path, form: str = "PNG") -> Path:
    """The picture as a file of that name, its numbers as sRGB has them."""
    height, width, _ = picture.shape
    image = bpy.data.images.new(name, width, height, alpha=True)
    image.pixels.foreach_set(picture.ravel())
    image.filepath_raw, image.file_format = str(folder / name), form
    image.save()
    bpy.data.images.remove(image)
    return folder / name


def scratch() -> Path:
    """A folder that lasts as long as Blender does."""
    return Path(tempfile.mkdtemp(dir=bpy.app.tempdir))


def image_texture(
    image: bpy.types.Image, low: float = 0.0, high: float = 1.0, output="Color", **properties
):
    """Paints with UVs from `low` to `high`."""

    def paint(tree: Tree):
        uv = out(tree.node("TexCoord"), "UV")
        node = tree.node("TexImage", {"Vector": tree.scaled(uv, high - low, low)}, **properties)
        node.image = image
        return out(node, output)

    return paint


@feature()
def interpolation():
    """Linear, closest, cubic and smart interpolation"""
    image = packed("Blocks", pixels())
    kinds = ("Linear", "Closest", "Cubic", "Smart")
    tiles([image_texture(image, interpolation=kind) for kind in kinds])


@feature()
def extension():
    """Repeat, extend, clip, and in Blender 4 mirror"""
    image = packed("Blocks", pixels())
    kinds = ("REPEAT", "EXTEND", "CLIP")
    tiles([image_texture(image, -0.7, 1.8, extension=kind) for kind in kinds])


@feature(since=(3, 5))
def extension_mirror():
    """Mirrored repetition"""
    wall(image_texture(packed("Blocks", pixels()), -0.7, 1.8, extension="MIRROR"))


@feature()
def color_spaces():
    """A picture read as sRGB, as raw and as linear"""
    linear = ("Linear", "Linear Rec.709")[bpy.app.version >= (4, 0, 0)]
    spaces = ("sRGB", "Non-Color", linear)
    folder = scratch()
    path = saved("blocks.png", pixels(), folder)
    paints = []
    for space in spaces:
        image = bpy.data.images.load(str(path))
        image.colorspace_settings.name = space
        paints.append(image_texture(image, interpolation="Closest"))
    tiles(paints)


@feature()
def alpha():
    """Colour and alpha of a picture that is part transparent, straight and premultiplied"""
    picture = pixels()
    picture[..., 3] = np.linspace(0.1, 1.0, SIZE)[:, None]
    straight, premultiplied = packed("Straight", picture), packed("Premultiplied", picture)
    premultiplied.alpha_mode = "PREMUL"
    tiles(
        [
            image_texture(image, output=output)
            for image in (straight, premultiplied)
            for output in ("Color", "Alpha")
        ]
    )


@feature()
def alpha_modes():
    """Colour and alpha of a file whose alpha is packed, and of one whose alpha is ignored"""
    picture = pixels()
    picture[..., 3] = np.linspace(0.1, 1.0, SIZE)[:, None]
    path = saved("alpha.png", picture, scratch())
    paints = []
    for mode in ("CHANNEL_PACKED", "NONE"):
        image = bpy.data.images.load(str(path))
        image.alpha_mode = mode
        paints += [image_texture(image, output=output) for output in ("Color", "Alpha")]
    tiles(paints)


def projected(projection: str, **properties):
    """Paints by the object's coordinates."""

    def paint(tree: Tree):
        vector = tree.scaled(out(tree.node("TexCoord"), "Object"), 0.5, 0.5)
        node = tree.node("TexImage", {"Vector": vector}, projection=projection, **properties)
        node.image = packed("Blocks", pixels())
        return out(node, "Color")

    return paint


def projected_on(mesh: bpy.types.Mesh, paint) -> None:
    camera()
    world(GREY)
    add(dressed(mesh, shows(paint)), BALL_CENTRE).rotation_euler = (0.2, 0.1, 0.5)


@feature()
def projection_box():
    """Box projection on a ball, blended"""
    projected_on(ball_mesh(), projected("BOX", projection_blend=0.3))


@feature()
def projection_box_of_cube():
    """Box projection on a cube, not blended"""
    projected_on(cube_mesh(1.3), projected("BOX", projection_blend=0.0))


@feature()
def projection_sphere():
    """Projection from a sphere"""
    projected_on(ball_mesh(), projected("SPHERE"))


@feature()
def projection_tube():
    """Projection from a tube"""
    projected_on(ball_mesh(), projected("TUBE"))


@feature()
def generated():
    """Images that Blender generates: a colour, a grid, a coloured grid"""
    paints = []
    for kind in ("BLANK", "UV_GRID", "COLOR_GRID"):
        image = bpy.data.images.new(kind, 256, 256)
        image.generated_type, image.generated_color = kind, (0.8, 0.3, 0.1, 1.0)
        paints.append(image_texture(image))
    tiles(paints)


@feature()
def float_picture():
    """Half-float EXR, brighter than one"""
    folder = scratch()
    image = bpy.data.images.new("Bright", SIZE, SIZE, float_buffer=True)
    image.pixels.foreach_set((pixels() * 1.6).ravel())
    image.filepath_raw, image.file_format = str(folder / "bright.exr"), "OPEN_EXR"
    image.save()
    loaded = bpy.data.images.load(str(folder / "bright.exr"))

    def paint(tree: Tree):
        return tree.scaled(image_texture(loaded)(tree), 0.5, 0.0)

    wall(paint)


@feature()
def jpeg():
    """A JPEG file"""
    path = saved("blocks.jpg", pixels().repeat(8, axis=0).repeat(8, axis=1), scratch(), "JPEG")
    wall(image_texture(bpy.data.images.load(str(path))))


@feature()
def udim():
    """Four UDIM tiles"""
    folder = scratch()
    for index, tile in enumerate((1001, 1002, 1011, 1012)):
        saved(f"tile.{tile}.png", pixels(seed=tile + index), folder)
    image = bpy.data.images.load(str(folder / "tile.1001.png"))
    image.source = "TILED"
    for tile in (1002, 1011, 1012):
        image.tiles.new(tile)
    image.filepath = str(folder / "tile.<UDIM>.png")
    wall(image_texture(image, 0.0, 2.0))


@feature()
def sequence():
    """Frame 3 of a sequence"""
    folder = scratch()
    for frame in (1, 2, 3, 4):
        saved(f"frame{frame:04}.png", pixels(seed=frame), folder)
    image = bpy.data.images.load(str(folder / "frame0001.png"))
    image.source = "SEQUENCE"
    bpy.context.scene.frame_set(3)

    def paint(tree: Tree):
        color = image_texture(image)(tree)
        user = color.node.image_user
        user.frame_duration, user.frame_start, user.use_auto_refresh = 4, 1, True
        return color

    wall(paint)


@feature()
def mapping_of_node():
    """The mapping of old files, kept within the texture node"""

    def paint(tree: Tree):
        color = image_texture(packed("Blocks", pixels()))(tree)
        color.node.texture_mapping.scale = (2.0, 1.5, 1.0)
        color.node.texture_mapping.translation = (0.2, 0.1, 0.0)
        return color

    wall(paint)


@feature()
def missing():
    """A picture that is not there: magenta"""
    image = bpy.data.images.new("Gone", 4, 4)
    image.source, image.filepath = "FILE", "/nonexistent/gone.png"
    wall(image_texture(image))
