"""The report on an eye, in plain Python: numbers with units, a picture, and one line."""

import json
import math
import sys
from pathlib import Path

import eyecore
import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "addon/eye_render"))
import report  # noqa: E402  (it lies in the add-on, which needs Blender)

AMPLITUDE_D = 9.0


def subject(rx: str, pupil_mm: float = 4.0, accommodation_d: float = 0.0) -> report.Subject:
    def eye_at(power_d: float) -> eyecore.Eye:
        return eyecore.Eye(
            rx=rx, rx_plane="entrance_pupil", pupil_mm=pupil_mm, accommodation_d=power_d
        )

    return report.Subject(eye_at, accommodation_d, AMPLITUDE_D, {"rx": rx})


def written_numbers(about: report.Subject, distances_m: list[float], path: Path) -> dict:
    return json.loads(report.write_report(about, distances_m, path).numbers.read_text())


def test_a_report_has_the_numbers_of_the_closed_forms(tmp_path: Path) -> None:
    numbers = written_numbers(
        subject("-2.00DS -1.00DC 160A"), [0.5, math.inf], tmp_path / "eye.json"
    )
    assert numbers["observer"]["rx"] == "-2.00DS -1.00DC 160A"
    assert numbers["far_point_m"] == pytest.approx(0.4)
    assert numbers["near_point_m"] == pytest.approx(1 / 11.5, rel=1e-5)
    assert [each["meridian_deg"] for each in numbers["meridians"]] == pytest.approx([20.0, 110.0])
    assert numbers["best_focus_d"] == pytest.approx(2.5, abs=1e-3)

    near, far = numbers["distances"]
    assert (near["distance_m"], far["distance_m"]) == (0.5, None)
    # At 0.5 m the meridian along 20 degrees is in focus: a line across it, 1 D long.
    assert near["defocus_d"] == pytest.approx(0.5, abs=1e-3)
    assert near["blur_major_arcmin"] == pytest.approx(13.751, rel=1e-3)
    assert near["blur_minor_arcmin"] == pytest.approx(0.0, abs=0.01)
    assert near["blur_angle_deg"] == pytest.approx(110.0, abs=0.1)
    along, across = near["mtf"]
    assert along["meridian_deg"] == pytest.approx(110.0, abs=0.1)
    frequencies = along["frequencies_cpd"]
    assert frequencies == [1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 30.0]
    assert across["of_rays"] == pytest.approx([1.0] * 7, abs=1e-3)
    assert across["with_diffraction"] == pytest.approx(
        eyecore.diffraction_mtf(frequencies, 4.0), abs=2e-3
    )
    # An evenly filled line of 13.751' blurs to 2 J1(x) / x, x = pi 13.751/60 per cycle a degree.
    assert along["of_rays"][0] == pytest.approx(0.936, abs=2e-3)
    assert along["of_rays"][4] < 0.2


def test_the_curve_through_focus_is_in_the_numbers(tmp_path: Path) -> None:
    curve = written_numbers(subject("-2.00DS"), [0.3, math.inf], tmp_path / "eye.json")[
        "through_focus"
    ]
    vergences_d, radii = curve["object_vergence_d"], curve["rms_radius_arcmin"]
    assert (vergences_d[0], vergences_d[-1]) == pytest.approx((-0.5, 1 / 0.3 + 0.5), rel=1e-5)
    assert vergences_d == sorted(vergences_d)
    sharpest = radii.index(min(radii))
    assert vergences_d[sharpest] == pytest.approx(2.0, abs=0.026)
    # 4 mm at 2 D: a disc of 27.5', whose RMS radius is its diameter / sqrt(8).
    at_infinity = min(zip(vergences_d, radii, strict=True), key=lambda point: abs(point[0]))
    assert at_infinity[1] == pytest.approx(
        4e-3 * (2.0 - at_infinity[0]) * 3437.75 / 8**0.5, rel=0.01
    )


@pytest.mark.parametrize(
    ("told", "title"),
    [
        ({"worn": "full correction"}, "glasses worn: full correction"),
        (
            {"worn": "full correction", "worn_part": "near"},
            "glasses worn: full correction, seen through their near part",
        ),
    ],
)
def test_the_title_says_what_is_worn(told: dict, title: str) -> None:
    pytest.importorskip("matplotlib")
    from report.figure import _title

    observer = {"rx": "OD +2.00DS add +2.50", "correction": "glasses", **told}
    assert _title({"observer": observer, "pupil_mm": 4.0}).endswith(f"pupil 4 mm, {title}")


def test_an_emmetropes_report_speaks_of_infinity_and_diffraction(tmp_path: Path) -> None:
    numbers = written_numbers(subject("Plano", 2.0), [6.0, math.inf], tmp_path / "eye.json")
    assert numbers["far_point_m"] is None and numbers["best_focus_m"] is None
    assert numbers["airy_radius_arcmin"] == pytest.approx(1.16353, abs=1e-5)
    # A sixth of a dioptre is less than the third that makes an Airy disk through 2 mm.
    assert [each["is_diffraction_limited"] for each in numbers["distances"]] == [True, True]


def test_full_correction_leaves_no_blur_and_no_direction_of_it(tmp_path: Path) -> None:
    about = report.Subject(
        lambda power_d: eyecore.Eye(
            rx="+3.00 -0.75 x 20", correction="glasses", accommodation_d=power_d
        ),
        0.0,
        AMPLITUDE_D,
    )
    (far,) = written_numbers(about, [math.inf], tmp_path / "eye.json")["distances"]
    assert far["blur_major_arcmin"] == far["blur_minor_arcmin"] == far["defocus_d"] == 0.0
    assert far["blur_angle_deg"] is None


def test_the_picture_lies_beside_the_numbers(tmp_path: Path) -> None:
    image = pytest.importorskip("matplotlib.image")
    about = subject("-2.00DS -0.75DC 160A")
    written = report.write_report(about, [math.inf], tmp_path / "eye.json")
    assert written.picture == tmp_path / "eye.png" and written.note == ""
    pixels = image.imread(written.picture)
    assert pixels.shape[:2] == (900, 1600)
    assert pixels.std() > 0.1  # not blank


def test_without_matplotlib_the_numbers_are_written_and_a_sentence_says_why(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in [name for name in sys.modules if name.split(".")[0] == "matplotlib"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.delitem(sys.modules, "report.figure", raising=False)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    written = report.write_report(subject("Plano"), [1.0], tmp_path / "eye.json")
    assert written.numbers.exists() and written.picture is None
    assert not (tmp_path / "eye.png").exists()
    assert "python3-matplotlib" in written.note


def test_an_eye_without_a_pupil_has_no_report(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="pupil_mm is 0; expected above 0"):
        report.write_report(subject("Plano", 0.0), [1.0], tmp_path / "eye.json")
    assert not (tmp_path / "eye.json").exists()


@pytest.mark.parametrize(
    ("rx", "accommodation_d", "focus_m", "line"),
    [
        (
            "-2.00DS",
            0.0,
            1.0,
            "Blur 13.8′ at 1.00 m, 27.5′ at infinity; far point 0.50 m, near point 0.09 m; "
            "pupil 4.0 mm",
        ),
        (
            "+2.00DS",
            2.0,
            math.inf,
            "Blur 0.0′ at infinity; far point 0.50 m behind the eye, near point 0.14 m; "
            "pupil 4.0 mm",
        ),
    ],
)
def test_one_line_sums_up(rx: str, accommodation_d: float, focus_m: float, line: str) -> None:
    about = subject(rx, accommodation_d=accommodation_d)
    assert report.summary_line(about, focus_m) == line


def test_a_subject_is_what_a_session_found() -> None:
    observer = eyecore.Observer(rx="-2.00DS", rx_plane="entrance_pupil", pupil=3.5, focus=0.3)
    scene = eyecore.Scene()
    scene.set_camera([[float(i == j) for j in range(4)] for i in range(4)], (-1, 1, -1, 1), (1, 1))
    about = report.subject_of(observer, eyecore.Session(scene, observer, eyecore.Settings()).facts)
    assert about.eye.pupil_mm == 3.5
    assert about.eye.far_point_m == pytest.approx(0.3)
    assert about.amplitude_d == eyecore.accommodation_amplitude_d(30)
    assert about.description["rx"] == "-2.00DS"
    assert about.description["focus_m"] == 0.3
    assert report.distances_of(about) == [0.3, 0.4, 1.0, 6.0, math.inf]
