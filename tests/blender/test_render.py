"""Whole renders: what arrives in Blender's result and in its files."""

import re
import subprocess

import bpy
import numpy as np
import pytest
from eye_render import batch
from scenes import add_object, emitter, layer_pixels, quad_mesh, write_multilayer

RED = (1.0, 0.0, 0.0)
GREEN = (0.0, 1.0, 0.0)
PUPIL_MM = 4.0  # the property's default
ARCMIN_PER_MM_D = 60 * 180 / np.pi / 1000


def wall(color: tuple[float, float, float], x: float = 0.0, size: float = 10.0):
    """A glowing square two metres ahead of the camera."""
    mesh = quad_mesh(size=size)
    mesh.materials.append(emitter(color))
    shown = add_object(mesh)
    shown.location = (x, 0.0, -2.0)
    return shown


def file_info(path: str) -> str:
    command = ["oiiotool", "--info", "-v", path]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def channel_averages(path: str) -> dict[str, float]:
    """The mean of every channel of every part of a file."""
    command = ["oiiotool", "-a", "--info", "-v", "--stats", path]
    report = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    names = re.findall("channel list: (.*)", report)
    averages = re.findall(r"Stats Avg: (.*) \(float\)", report)
    return {
        name: float(average)
        for part_names, part_averages in zip(names, averages, strict=True)
        for name, average in zip(part_names.split(", "), part_averages.split(), strict=True)
    }


@pytest.fixture
def sharp(scene):
    """Without blur and with a narrow filter, so that single pixels can be told."""
    scene.camera.data.eye_render.model = "PINHOLE"
    scene.cycles.filter_width = 0.01
    return scene


def test_a_second_render_has_the_settings_of_now(scene, render):
    """One sample of an edge is noise, which another seed makes another."""
    wall(RED, x=5.0)
    scene.eye_render.samples = 1
    pictures = []
    for seed in (1, 2, 1):
        scene.eye_render.seed = seed
        pictures.append(render())
    assert not np.array_equal(pictures[0], pictures[1])
    assert np.array_equal(pictures[0], pictures[2])


def test_a_glowing_wall_has_its_colour_everywhere(render):
    wall((0.5, 0.25, 2.0))
    assert np.allclose(render(), (0.5, 0.25, 2.0, 1.0), atol=1e-5)


def test_left_and_up_are_where_they_belong(sharp, render):
    sharp.camera.data.angle = np.pi / 2  # the window is 4 m by 2 m at the wall
    wall(RED, size=1.0).location = (-1.5, 0.5, -2.0)
    lit = render()[..., 0] > 0.5
    rows, columns = np.nonzero(lit)
    assert (rows.min(), rows.max()) == (4, 7)
    assert (columns.min(), columns.max()) == (0, 3)


def test_a_hidden_object_is_not_rendered(render):
    wall(RED).hide_render = True
    assert np.all(render()[..., :3] == 0.0)


def test_a_border_is_the_same_cut_out_of_the_whole(sharp, render):
    wall(RED, x=-0.3, size=0.5)
    wall(GREEN, x=0.3, size=0.5)
    whole = render()
    sharp.render.use_border = True
    sharp.render.border_min_x, sharp.render.border_max_x = 0.27, 0.77
    sharp.render.border_min_y, sharp.render.border_max_y = 0.3, 0.9
    sharp.render.use_crop_to_border = True
    part = render()
    assert whole.shape == (8, 16, 4)
    assert part.shape == (5, 8, 4)
    assert np.array_equal(part, whole[2:7, 4:12])


def test_resolution_percentage_scales_the_picture(scene, render):
    scene.render.resolution_percentage = 50
    assert render().shape == (4, 8, 4)


def test_every_enabled_pass_arrives_in_the_file(scene, tmp_path):
    wall(RED)
    view_layer = scene.view_layers[0]
    view_layer.use_pass_z = view_layer.use_pass_normal = True
    switches = view_layer.eye_render
    view_layer.cycles.denoising_store_passes = switches.use_pass_defocus = (
        switches.use_pass_blur
    ) = True
    write_multilayer(scene, str(tmp_path / "passes.exr"))
    bpy.ops.render.render(write_still=True)
    average = {
        name.removeprefix(f"{view_layer.name}."): value
        for name, value in channel_averages(scene.render.filepath).items()
    }
    assert average["Combined.R"] == pytest.approx(1.0, rel=1e-3)
    assert average["Depth.Z"] == pytest.approx(2.0, rel=1e-3)
    assert average["Normal.Z"] == pytest.approx(1.0, rel=1e-3)
    assert average["Denoising Albedo.R"] == pytest.approx(1.0)  # what shines is its light
    assert average["Defocus.X"] == pytest.approx(-0.5, rel=1e-3)  # a relaxed eye, 2 m away
    assert average["Blur.X"] == pytest.approx(0.5 * PUPIL_MM * ARCMIN_PER_MM_D, rel=1e-3)


def test_the_file_carries_the_observer(scene, render):
    scene.camera.data.eye_render.right.text = "-2.00DS -0.75DC 160A"
    scene.camera.data.eye_render.pupil_mm = 3.5
    render()
    info = file_info(scene.render.filepath)
    assert 'eye_render:rx: "OD -2.00DS -0.75DC 160A"' in info
    assert 'eye_render:eye: "right"' in info
    assert 'eye_render:model: "paraxial"' in info
    assert 'eye_render:pupil_mm: "3.5' in info


def test_each_stereo_view_has_its_own_eye_and_place(sharp, tmp_path):
    sharp.render.use_multiview = True
    sharp.render.image_settings.file_format = "OPEN_EXR"
    sharp.render.image_settings.views_format = "INDIVIDUAL"
    sharp.camera.data.eye_render.right.text = "-1.00"
    sharp.camera.data.eye_render.left.text = "-3.00"
    sharp.camera.data.stereo.interocular_distance = 0.2
    sharp.camera.data.stereo.convergence_mode = "PARALLEL"
    sharp.camera.data.stereo.pivot = "CENTER"
    wall(RED, size=0.4)
    sharp.render.filepath = str(tmp_path / "stereo.exr")
    bpy.ops.render.render(write_still=True)

    centres = {}
    for view, suffix in (("left", "_L"), ("right", "_R")):
        path = str(tmp_path / f"stereo{suffix}.exr")
        info = file_info(path)
        assert f'eye_render:eye.{view}: "{view}"' in info
        assert f'eye_render:rx.{view}: "{"OS -3" if view == "left" else "OD -1"}.00DS' in info
        # Blender loads no picture that calls itself one of several views.
        subprocess.run(["oiiotool", path, "--eraseattrib", "multiView", "-o", path], check=True)
        image = bpy.data.images.load(path)
        pixels = np.empty((8, 16, 4), np.float32)
        image.pixels.foreach_get(pixels.ravel())
        centres[view] = np.nonzero(pixels[..., 0] > 0.5)[1].mean()
    assert centres["left"] > centres["right"], "the left eye sees the wall further to the right"


def test_each_view_layer_renders_its_own_objects(scene, tmp_path):
    red, green = bpy.data.collections.new("Red"), bpy.data.collections.new("Green")
    for collection, color in ((red, RED), (green, GREEN)):
        shown = wall(color)
        scene.collection.objects.unlink(shown)
        collection.objects.link(shown)
        scene.collection.children.link(collection)
    second = scene.view_layers.new("Second")
    scene.view_layers[0].layer_collection.children["Green"].exclude = True
    second.layer_collection.children["Red"].exclude = True
    write_multilayer(scene, str(tmp_path / "layers.exr"))
    bpy.ops.render.render(write_still=True)
    average = channel_averages(scene.render.filepath)
    for layer, color in ((scene.view_layers[0].name, RED), ("Second", GREEN)):
        rendered = [average[f"{layer}.Combined.{channel}"] for channel in "RGB"]
        assert rendered == pytest.approx(color, abs=1e-3)


def test_the_seed_changes_the_noise_and_nothing_else_does(scene, render):
    wall(RED, x=0.1, size=0.5)
    first = render()
    assert np.array_equal(first, render())
    scene.eye_render.seed = 1
    assert not np.array_equal(first, render())


def test_a_transparent_film_has_no_alpha_where_nothing_is(scene, render):
    scene.render.film_transparent = True
    assert np.all(render()[..., 3] == 0.0)


def test_a_picture_of_many_samples_ends_at_once_when_cancelled(run_blender, picture):
    script = (
        "import os, signal, threading, time\n"
        'scene.eye_render.quality = "REFERENCE"\n'
        "scene.render.resolution_x = scene.render.resolution_y = 1024\n"
        "threading.Timer(1.5, os.kill, (os.getpid(), signal.SIGINT)).start()\n"
    )
    ended = run_blender(script=script)
    assert ended.returncode == 1
    assert not picture.exists()


def test_parts_of_the_samples_merge_exactly_by_their_weights(scene, tmp_path):
    """Each sample has a wavelength of its own, so that channels count samples differently."""
    wall(GREEN, x=5.0)
    scene.eye_render.chromatic = True
    scene.camera.data.eye_render.right.text = "-20.00DS"

    def part(samples: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
        path = str(tmp_path / f"{samples[1]}.exr")
        write_multilayer(scene, path)
        scene.render.image_settings.color_depth = "32"
        batch.overrides.sample_range = samples
        try:
            bpy.ops.render.render(write_still=True)
        finally:
            batch.overrides.sample_range = None
        return layer_pixels(path, "Combined"), layer_pixels(path, "Sample Weight")

    (first, first_weight), (second, second_weight) = part((0, 3)), part((3, 8))
    whole, whole_weight = part((0, 8))
    merged_weight = first_weight + second_weight
    merged = (first * first_weight + second * second_weight) / merged_weight
    assert not np.array_equal(first_weight[..., 0], first_weight[..., 1])
    assert np.allclose(merged_weight, whole_weight, rtol=1e-5)
    assert np.allclose(merged, whole, rtol=1e-4, atol=1e-5)  # single precision, clipped at 0
