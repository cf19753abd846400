import bpy
import numpy as np
import pytest
from eye_render.export.image import ImageTable
from scenes import RecordingScene

FRAME = 12  # of the scene
USER = None  # who shows an image, where that does not matter


@pytest.fixture
def table(scene):
    recording = RecordingScene()
    recording.warnings = []
    return ImageTable(recording, FRAME, recording.warnings.append), recording


@pytest.fixture
def file_image(scene, tmp_path) -> bpy.types.Image:
    """A PNG, loaded from where it lies."""
    drawn = bpy.data.images.new("drawn", 4, 2)
    drawn.filepath_raw = str(tmp_path / "drawn.png")
    drawn.file_format = "PNG"
    drawn.save()
    return bpy.data.images.load(drawn.filepath_raw)


def test_a_file_goes_by_its_absolute_path(table, file_image, tmp_path):
    images, recording = table
    assert images.texture(file_image, USER) == 0
    (texture,) = recording.textures
    assert texture.path == str(tmp_path / "drawn.png")
    assert texture.colorspace == "sRGB"


def test_a_path_written_on_windows_is_found(table, file_image, tmp_path):
    images, recording = table
    file_image.filepath_raw = f"{tmp_path}\\.\\drawn.png"
    images.texture(file_image, USER)
    assert recording.textures[0].path == str(tmp_path / "drawn.png")


def test_the_same_use_of_an_image_is_one_texture(table, file_image):
    images, recording = table
    assert images.texture(file_image, USER) == images.texture(file_image, USER) == 0
    assert images.texture(file_image, USER, "CLIP", "Closest") == 1
    assert recording.textures[1].extension == "CLIP"
    assert recording.textures[1].interpolation == "Closest"


def test_the_ways_to_interpolate_and_to_read_alpha_are_cycles(table, file_image):
    images, recording = table
    for way, core_way in (("Cubic", "Cubic"), ("Smart", "Cubic"), ("Linear", "Linear")):
        images.texture(file_image, USER, "REPEAT", way)
        assert recording.textures[-1].interpolation == core_way
    for mode, core_mode in (("NONE", "NONE"), ("CHANNEL_PACKED", "CHANNEL_PACKED"),
                            ("PREMUL", "STRAIGHT"), ("STRAIGHT", "STRAIGHT")):  # fmt: skip
        file_image.alpha_mode = mode
        images.texture(file_image, USER, "EXTEND", f"as {mode}")
        assert recording.textures[-1].alpha == core_mode


def test_packed_images_go_by_their_pixels(table, file_image):
    images, recording = table
    file_image.pack()
    images.texture(file_image, USER)
    (texture,) = recording.textures
    assert texture.pixels.shape == (2, 4, 4)
    assert texture.pixels.dtype == np.uint8


def test_generated_pixels_are_bottom_up_bytes(table):
    images, recording = table
    image = bpy.data.images.new("Generated", 2, 2)
    image.pixels.foreach_set(np.array([[1, 0, 0, 1]] * 2 + [[0, 0, 1, 1]] * 2, np.float32).ravel())
    images.texture(image, USER)
    pixels = recording.textures[0].pixels
    assert pixels[0, 0].tolist() == [255, 0, 0, 255]
    assert pixels[1, 0].tolist() == [0, 0, 255, 255]


def test_float_images_are_linear(table):
    images, recording = table
    image = bpy.data.images.new("Bright", 2, 2, float_buffer=True)
    image.pixels.foreach_set(np.full(16, 7.5, np.float32))
    images.texture(image, USER)
    (texture,) = recording.textures
    assert texture.colorspace == "Linear"
    assert np.all(texture.pixels == 7.5)


def test_bright_files_of_other_colour_spaces_are_made_linear_by_blender(table, tmp_path):
    images, recording = table
    drawn = bpy.data.images.new("drawn", 2, 2, float_buffer=True)
    drawn.pixels.foreach_set(np.full(16, 0.5, np.float32))
    drawn.filepath_raw, drawn.file_format = str(tmp_path / "drawn.exr"), "OPEN_EXR"
    drawn.save()
    image = bpy.data.images.load(drawn.filepath_raw)
    image.colorspace_settings.name = "Filmic sRGB"
    images.texture(image, USER)
    (texture,) = recording.textures
    assert texture.colorspace == "Linear"
    assert not np.allclose(texture.pixels[..., 0], 0.5, atol=0.01)
    assert recording.warnings == []


def test_data_images_are_left_as_they_are(table, file_image):
    images, recording = table
    file_image.colorspace_settings.name = "Non-Color"
    images.texture(file_image, USER)
    assert recording.textures[0].colorspace == "Non-Color"


@pytest.fixture
def user(scene) -> bpy.types.ImageUser:
    material = bpy.data.materials.new("Screen")
    material.use_nodes = True
    user = material.node_tree.nodes.new("ShaderNodeTexImage").image_user
    user.frame_duration, user.frame_start, user.frame_offset = 100, 1, 0
    return user


@pytest.mark.parametrize(
    ("settings", "number"),
    [
        ({}, 12),
        ({"frame_offset": 20}, 32),
        ({"frame_start": 11}, 2),
        ({"frame_duration": 5}, 5),
        ({"frame_duration": 5, "use_cyclic": True}, 2),
        ({"frame_start": 20}, 0),
    ],
)
def test_a_sequence_shows_the_file_of_the_frame(table, user, tmp_path, settings, number):
    for name, value in settings.items():
        setattr(user, name, value)
    images, recording = table
    image = bpy.data.images.new("Film", 2, 2)
    image.source, image.filepath_raw = "SEQUENCE", str(tmp_path / "v2" / "film_0001_b.png")
    images.texture(image, user)
    assert recording.textures[0].path == str(tmp_path / "v2" / f"film_{number:04}_b.png")


def test_two_frames_of_a_sequence_are_two_textures(table, user, scene, tmp_path):
    images, _ = table
    image = bpy.data.images.new("Film", 2, 2)
    image.source, image.filepath_raw = "SEQUENCE", str(tmp_path / "0001.png")
    other = bpy.data.materials[0].node_tree.nodes.new("ShaderNodeTexImage").image_user
    other.frame_duration, other.frame_start, other.frame_offset = 100, 1, 5
    assert [images.texture(image, user), images.texture(image, other)] == [0, 1]


@pytest.mark.parametrize("name", ["skin.<UDIM>.png", "skin_<UVTILE>.png"])
def test_udim_tiles_are_textures_by_number(table, tmp_path, name):
    images, recording = table
    image = bpy.data.images.new("Tiles", 2, 2, tiled=True)
    image.tiles.new(tile_number=1012)
    image.source, image.filepath_raw = "TILED", str(tmp_path / name)
    assert images.tiles(image) == [1001, 0, 1012, 1]
    marks = ("1001", "1012") if "UDIM" in name else ("u1_v1", "u2_v2")
    places = [name.replace("<UDIM>", mark).replace("<UVTILE>", mark) for mark in marks]
    assert [texture.path for texture in recording.textures] == [
        str(tmp_path / place) for place in places
    ]


def test_tiles_that_are_not_in_files_are_named(table):
    images, recording = table
    image = bpy.data.images.new("Tiles", 2, 2, tiled=True)
    assert images.tiles(image) == []
    (warning,) = recording.warnings
    assert "Tiles" in warning
    assert "magenta" in warning
