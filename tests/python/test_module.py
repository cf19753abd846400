"""`import eyecore` in plain Python: arrays in and out, and errors that say what is wrong."""

import eyecore
import numpy as np
import pytest
from materials import add_light, add_picture, add_plain

QUAD = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32)
TRIANGLES = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)


def lit_quad() -> eyecore.Scene:
    """A grey square 2 m before the eye in a world of radiance 1."""
    scene = eyecore.Scene()
    number = add_plain(scene, "paint", "BSDF_DIFFUSE", {"Color": 0.5})
    at = np.eye(4)
    at[2, 3] = -2.0
    uvs = {"UVMap": QUAD[TRIANGLES.ravel(), :2] * 0.5 + 0.5}
    scene.add_instances(scene.add_mesh("quad", QUAD, TRIANGLES, uvs=uvs), at[None], [number])
    scene.set_world((1.0, 1.0, 1.0))
    scene.set_camera(np.eye(4), (-0.2, 0.2, -0.1, 0.1), (16, 8))
    return scene


def edge_before_nothing() -> eyecore.Scene:
    """A shining square whose upper edge lies across the picture."""
    scene = eyecore.Scene()
    paint = add_light(scene, "paint", color=(1.0, 0.5, 0.25))
    at = np.eye(4)
    at[:3, 3] = (0.0, -1.0, -2.0)
    scene.add_instances(scene.add_mesh("quad", QUAD, TRIANGLES), at[None], [paint])
    scene.set_camera(np.eye(4), (-0.1, 0.1, -0.05, 0.05), (16, 8))
    return scene


def test_render_gives_each_pass_as_an_array_of_its_shape() -> None:
    passes = [*eyecore.PASSES, eyecore.SAMPLE_WEIGHT]
    names = [name for name, _, _ in passes]
    images = eyecore.render(
        lit_quad(), eyecore.Observer(pupil=4), eyecore.Settings(samples=4, passes=names)
    )
    for name, channels, channel_ids in passes:
        assert len(channel_ids) == channels
        assert images[name].shape == (8, 16, channels)
        assert images[name].dtype == np.float32
    # Half of the world's radiance; 512 paths estimate it to 0.005.
    assert images["Combined"][:, :, :3].mean() == pytest.approx(0.5, abs=0.02)
    assert images["Depth"] == pytest.approx(2.0, abs=1e-5)
    assert images["Normal"][4, 8] == pytest.approx([0.0, 0.0, 1.0], abs=1e-6)
    assert images["Denoising Albedo"] == pytest.approx(0.5, abs=1e-6)
    assert (images["Sample Weight"] == 4.0).all()


def test_rows_are_bottom_up() -> None:
    scene = eyecore.Scene()
    pixels = np.zeros((2, 2, 4), np.float32)
    pixels[1] = 1.0  # the upper row is white
    texture = scene.add_texture_pixels("half", pixels, interpolation="Closest")
    paint = add_picture(scene, "m", texture)
    assert scene.uv_layers_read([paint]) == [""]
    at = np.eye(4)
    at[2, 3] = -2.0
    uvs = {"UVMap": QUAD[TRIANGLES.ravel(), :2] * 0.5 + 0.5}
    scene.add_instances(scene.add_mesh("quad", QUAD, TRIANGLES, uvs=uvs), at[None], [paint])
    scene.set_camera(np.eye(4), (-0.2, 0.2, -0.2, 0.2), (8, 8))
    image = eyecore.render(scene, eyecore.Observer(model="pinhole"), eyecore.Settings(samples=4))
    column = image["Combined"][:, 4, 0]
    assert column[0] == 0.0 and column[-1] > 0.0


def test_session_is_pulled_and_cancelled() -> None:
    session = eyecore.Session(
        lit_quad(), eyecore.Observer(rx="-12.00DS", pupil=6), eyecore.Settings(samples=1 << 20)
    )
    assert "lens: sampled" in session.plan_text
    session.start()
    assert not session.wait(0.05)
    session.cancel()
    assert session.wait(2.0)
    assert session.error is None
    assert 0 < session.progress < 1
    assert session.snapshot()["Combined"].shape == (8, 16, 4)


def test_rays_of_an_eye_follow_its_power_matrix() -> None:
    eye = eyecore.Eye(rx="-3.00DS", rx_plane="entrance_pupil", pupil_mm=5.0)
    origin, slope, weight, fate = eye.rays([[0.1, 0.0]], [[0.002, 0.001]])
    assert origin == pytest.approx(np.array([[0.002, 0.001, 0.0]]))
    assert slope == pytest.approx(np.array([[0.1 - 3 * 0.002, -3 * 0.001]]))
    assert weight == pytest.approx(np.array([1.0]))
    assert eye.far_point_m == pytest.approx(1 / 3)


def test_missing_image_is_magenta_and_named_in_a_warning() -> None:
    scene = lit_quad()
    texture = scene.add_texture("/nowhere/absent.png")
    paint = add_picture(scene, "m", texture)
    at = np.eye(4)
    at[2, 3] = -1.0
    scene.add_instances(scene.add_mesh("near", QUAD, TRIANGLES), at[None], [paint])
    session = eyecore.Session(
        scene, eyecore.Observer(model="pinhole"), eyecore.Settings(samples=1)
    )
    session.start()
    session.wait(10.0)
    assert any("absent.png" in warning for warning in session.warnings)
    red, green, blue, _ = session.snapshot()["Combined"][4, 8]
    assert red > 0 and green == 0 and blue > 0


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: eyecore.Eye(pupil_mm=12), r"pupil.* is .*12|0\.012"),
        (lambda: eyecore.Eye(model="lens"), r"model is 'lens'; expected one of pinhole, paper"),
        (lambda: eyecore.Eye(rx="-2.00 -0.75"), r"axis"),
        (lambda: eyecore.Prescription(axis_deg=190), r"axis_deg is 190.*; expected 0 to 180"),
        (lambda: eyecore.Observer(pupil="wide"), r"pupil is .wide.; expected .auto. or a number"),
        (lambda: eyecore.Settings(passes=["Shine"]), r"pass 'Shine' does not exist"),
        (
            lambda: eyecore.Scene().add_mesh("m", QUAD[:, :2], TRIANGLES),
            r"positions has shape \(4, 2\); expected \(n, 3\)",
        ),
        (
            lambda: eyecore.Scene().add_mesh("m", QUAD, TRIANGLES + 7),
            r"mesh 'm': triangle 0 has vertex 7; expected 0 to 4",
        ),
        (
            lambda: eyecore.Session(eyecore.Scene(), eyecore.Observer(), eyecore.Settings()),
            r"the scene has no camera",
        ),
        (
            lambda: eyecore.render(lit_quad(), eyecore.Observer(), eyecore.Settings(samples=0)),
            r"samples is 0; expected 1 to",
        ),
        (lambda: eyecore.Observer(rx=3), r"rx is 3; expected a Prescription or a text"),
        (lambda: eyecore.Observer(pupil=None), r"pupil is None; expected 'auto' or a number"),
        (
            lambda: eyecore.Scene().set_world(0.5),
            r"world color is 0.5; expected three numbers",
        ),
        (
            lambda: eyecore.Scene().add_light("l", "SUN", np.eye(4), 0.5),
            r"color of light 'l' is 0.5; expected three numbers",
        ),
        (
            lambda: lit_quad().set_camera(np.zeros((4, 4)), (-1, 1, -1, 1), (8, 8)),
            r"the camera's axes span no space",
        ),
        (lambda: eyecore.pupil_diameter_mm("GUESS", 10.0), r"formula is 'GUESS'; expected one of"),
        (
            lambda: eyecore.pupil_diameter_mm("WINN", -1.0),
            r"luminance_cd_m2 is -1 cd/m2; expected 0 cd/m2 or more",
        ),
        (lambda: eyecore.pupil_diameter_mm("WINN", np.nan), r"luminance_cd_m2 is nan cd/m2"),
    ],
)
def test_refusals_name_value_and_what_is_allowed(call, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        call()


def test_wavefront_observer_without_a_wavefront_has_the_mean_eye() -> None:
    mean = eyecore.Wavefront.population(3.0, "OD")
    rx = eyecore.Prescription.parse("OD -1.00")
    expected = eyecore.Eye(model="wavefront", rx=rx, wavefront=mean, pupil_mm=3.0)
    eye = eyecore.observer_eye(eyecore.Observer(model="wavefront", rx=rx), 3.0)
    edge = ([[0.0, 0.0]], [[0.0015, 0.0]])
    assert eye.rays(*edge)[1].tolist() == expected.rays(*edge)[1].tolist()


def test_things_say_what_they_are() -> None:
    rx = eyecore.Prescription(-2.0, -0.75, 160)
    assert repr(rx) == "Prescription('-2.00DS -0.75DC 160A')"
    eye = eyecore.Eye(rx="-3.00DS", rx_plane="entrance_pupil")
    assert repr(eye) == "Eye(pupil_mm=4, retinal_conjugate_d=((3, 0), (0, 3)))"
    assert repr(eye.blur_ellipse(1 / 3)) == (
        "BlurEllipse(major_arcmin=0, minor_arcmin=0, angle_deg=None)"
    )
    assert repr(eyecore.Observer(rx=rx, focus=0.5, correction="glasses", worn="-1.00")) == (
        "Observer(model='paraxial', rx='-2.00DS -0.75DC 160A', age_years=30, pupil='auto', "
        "focus=0.5, correction='glasses', worn='-1.00DS')"
    )
    assert repr(eyecore.Settings(sample_range=(4, 8), seed=7)) == (
        "Settings(samples=64, sample_range=(4, 8), max_bounces=8, seed=7, pattern='SOBOL')"
    )


def test_render_issues_the_warnings_of_the_scene() -> None:
    scene = lit_quad()
    scene.set_world((0.0, 0.0, 0.0))
    with pytest.warns(UserWarning, match="there is no light in the scene"):
        eyecore.render(scene, eyecore.Observer(pupil=4), eyecore.Settings(samples=1))


def test_numpy_numbers_are_numbers() -> None:
    scene = eyecore.Scene()
    inputs = {"Roughness": np.float32(0.5), "Metallic": np.int64(1)}
    add_plain(scene, "m", "BSDF_PRINCIPLED", inputs)
    eyecore.Observer(pupil=np.float32(3.0), focus=np.float64(2.0))


def test_a_scene_refuses_changes_while_a_session_refers_to_it() -> None:
    scene = lit_quad()
    session = eyecore.Session(scene, eyecore.Observer(pupil=4), eyecore.Settings(samples=1))
    with pytest.raises(ValueError, match="cannot change while a session"):
        scene.add_material("late")
    del session
    scene.add_material("in time")


def test_waiting_forever_is_waiting() -> None:
    session = eyecore.Session(lit_quad(), eyecore.Observer(pupil=4), eyecore.Settings(samples=256))
    session.start()
    assert session.wait(float("inf"))
    with pytest.raises(ValueError, match="timeout_s is nan"):
        session.wait(float("nan"))


@pytest.mark.parametrize("stiles_crawford", [False, True])
@pytest.mark.parametrize("chromatic", [False, True])
@pytest.mark.parametrize("pattern", eyecore.PUPIL_PATTERNS)
def test_sample_ranges_merge_into_the_whole_with_every_pattern(
    pattern: str, chromatic: bool, stiles_crawford: bool
) -> None:
    scene = edge_before_nothing()

    def part(sample_range):
        settings = eyecore.Settings(
            samples=32,
            sample_range=sample_range,
            pattern=pattern,
            chromatic=chromatic,
            stiles_crawford=stiles_crawford,
            film_transparent=True,
            passes=["Combined", "Denoising Albedo", "Sample Weight"],
        )
        observer = eyecore.Observer(rx="-12.00DS", pupil=6)
        passes = eyecore.render(scene, observer, settings)
        weight = passes["Sample Weight"].astype(np.float64)
        return passes["Combined"], passes["Denoising Albedo"], weight

    whole_picture, whole_albedo, whole_weight = part(None)
    parts = [part((0, 3)), part((3, 20)), part((20, 32))]
    weight = sum(weight for _, _, weight in parts)
    picture = sum(weight * picture for picture, _, weight in parts) / weight
    albedo = sum(weight[:, :, 3:] * albedo for _, albedo, weight in parts) / weight[:, :, 3:]
    # Pictures of up to 1 are rounded to float thrice: as parts, as weights and as the whole.
    assert picture == pytest.approx(whole_picture, abs=3 * 2.0**-24)
    assert albedo == pytest.approx(whole_albedo, abs=3 * 2.0**-24)
    assert weight == pytest.approx(whole_weight, rel=2.0**-22)
    assert np.ptp(whole_picture[:, :, 0]) > 0.9, "the edge must show"


def test_aovs_and_light_groups_are_delivered_under_their_names() -> None:
    scene = eyecore.Scene()
    graph = eyecore.NodeGraph()
    paint = graph.add("BSDF_DIFFUSE", {"Color": (0.5, 0.5, 0.5)})["BSDF"]
    tone = graph.add("RGB", value=[0.25, -1.0, 2.0])["Color"]
    material = scene.add_material("m", paint, aovs={"Tone": tone})
    mesh = scene.add_mesh("quad", QUAD, TRIANGLES)
    at = np.eye(4)
    at[2, 3] = -2.0
    scene.add_instances(mesh, at[None], materials=[material])
    scene.set_world((1.0, 1.0, 1.0))
    scene.set_world_light_group("sky")
    above = np.eye(4)
    scene.add_light("l", "POINT", above, (9.0, 9.0, 9.0), light_group="key")
    scene.set_camera(np.eye(4), (-0.1, 0.1, -0.1, 0.1), (2, 2))
    settings = eyecore.Settings(
        samples=4,
        passes=["Combined", "Combined_key", "Combined_sky"],
        aovs={"Tone": "COLOR", "Missing": "VALUE"},
    )
    images = eyecore.render(scene, eyecore.Observer(pupil=4), settings)
    assert images["Tone"][0, 0] == pytest.approx([0.25, -1.0, 2.0, 1.0])
    assert (images["Missing"] == 0.0).all()
    assert images["Missing"].shape == (2, 2, 1)
    groups = images["Combined_key"] + images["Combined_sky"]
    assert images["Combined_key"].max() > 0.0
    assert groups == pytest.approx(images["Combined"][..., :3], rel=1e-6)


NOT_MEANS = {
    *("Depth", "Position", "Object Index", "Material Index", "Defocus", "Blur"),
    "Shadow Catcher",
}
LIGHT = ("Combined", "Emission", "Environment", "Direct", "Indirect")


def test_every_mean_pass_merges_exactly_by_the_sample_weights() -> None:
    """Light is weighed by wavelength, the rest by sample; light over a colour as their product."""
    scene = lit_quad()
    means = [name for name, _, _ in eyecore.PASSES if name not in NOT_MEANS]

    def part(sample_range):
        settings = eyecore.Settings(
            samples=16,
            sample_range=sample_range,
            chromatic=True,
            stiles_crawford=True,
            passes=[*means, "Sample Weight"],
        )
        images = eyecore.render(scene, eyecore.Observer(rx="-12.00DS", pupil=6), settings)
        images = {name: image.astype(np.float64) for name, image in images.items()}
        for name in means:
            kind, _, source = name.partition(" ")
            if source in ("Direct", "Indirect") and kind != "Volume":
                images[name] = images[name] * images[f"{kind} Color"]
        return images

    whole, first, second = part(None), part((0, 5)), part((5, 16))
    for name in means:
        weights = [
            image["Sample Weight"][..., :3]
            if name.endswith(LIGHT)
            else image["Sample Weight"][..., 3:]
            for image in (first, second)
        ]
        channels = slice(0, 3) if name.endswith(LIGHT) else slice(None)
        sums = sum(
            weight * image[name][..., channels]
            for weight, image in zip(weights, (first, second), strict=True)
        )
        # Rounded to float as parts, as weights, as quotients and as the whole.
        assert sums / sum(weights) == pytest.approx(
            whole[name][..., channels], rel=8 * 2.0**-24, abs=2.0**-24
        ), name
