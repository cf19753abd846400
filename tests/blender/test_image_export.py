import bpy
import numpy as np
import pytest
from eye_render.export.image import ImageTable
from scenes import RecordingScene


@pytest.fixture
def table(scene):
    recording = RecordingScene()
    recording.warnings = []
    return ImageTable(recording, recording.warnings.append), recording


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
    assert images.texture(file_image) == 0
    (texture,) = recording.textures
    assert texture.path == str(tmp_path / "drawn.png")
    assert texture.colorspace == "sRGB"


def test_a_path_written_on_windows_is_found(table, file_image, tmp_path):
    images, recording = table
    file_image.filepath_raw = f"{tmp_path}\\.\\drawn.png"
    images.texture(file_image)
    assert recording.textures[0].path == str(tmp_path / "drawn.png")


def test_the_same_use_of_an_image_is_one_texture(table, file_image):
    images, recording = table
    assert images.texture(file_image) == images.texture(file_image) == 0
    assert images.texture(file_image, "CLIP", "Closest") == 1
    assert recording.textures[1].extension == "CLIP"
    assert recording.textures[1].interpolation == "Closest"


def test_packed_images_go_by_their_pixels(table, file_image):
    images, recording = table
    file_image.pack()
    images.texture(file_image)
    (texture,) = recording.textures
    assert texture.pixels.shape == (2, 4, 4)
    assert texture.pixels.dtype == np.uint8


def test_generated_pixels_are_bottom_up_bytes(table):
    images, recording = table
    image = bpy.data.images.new("Generated", 2, 2)
    image.pixels.foreach_set(np.array([[1, 0, 0, 1]] * 2 + [[0, 0, 1, 1]] * 2, np.float32).ravel())
    images.texture(image)
    pixels = recording.textures[0].pixels
    assert pixels[0, 0].tolist() == [255, 0, 0, 255]
    assert pixels[1, 0].tolist() == [0, 0, 255, 255]


def test_float_images_are_linear(table):
    images, recording = table
    image = bpy.data.images.new("Bright", 2, 2, float_buffer=True)
    image.pixels.foreach_set(np.full(16, 7.5, np.float32))
    images.texture(image)
    (texture,) = recording.textures
    assert texture.colorspace == "Linear"
    assert np.all(texture.pixels == 7.5)


def test_data_images_are_left_as_they_are(table, file_image):
    images, recording = table
    file_image.colorspace_settings.name = "Non-Color"
    images.texture(file_image)
    assert recording.textures[0].colorspace == "Non-Color"


def test_tiles_and_sequences_are_named(table):
    images, recording = table
    image = bpy.data.images.new("Tiles", 2, 2, tiled=True)
    assert images.texture(image) is None
    assert images.texture(image) is None
    (warning,) = recording.warnings
    assert "Tiles" in warning
    assert "magenta" in warning
