"""`./run eyes` measures what it says: its part in plain Python, with few rays."""

import sys
from pathlib import Path

import eyecore
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "bench"))

import eye_rays


@pytest.mark.parametrize("model", eyecore.EYE_MODELS)
def test_a_ray_takes_time(model: str) -> None:
    assert eye_rays.ray_ns(eye_rays.make_eye(model), 555.0, 200) > 0.0


@pytest.mark.parametrize("wavelength_nm", eye_rays.WAVELENGTHS_NM)
@pytest.mark.parametrize("model", eyecore.EYE_MODELS)
def test_a_ray_is_as_exact_as_its_model(model: str, wavelength_nm: float) -> None:
    error = eye_rays.ray_error(model, wavelength_nm, 200)
    assert 0.0 <= error.median_arcmin <= error.largest_arcmin
    if model in ("paraxial", "wavefront"):
        assert error.largest_arcmin < 1e-9  # rounding
    elif model in eye_rays.SCHEMATIC:
        assert 0.0 < error.largest_arcmin < 0.02  # what the fit may be off by
    else:
        assert error.median_arcmin > 0.1  # no blur, or the paper's
