"""`./run eyes` measures what it says: its part in plain Python, with few rays."""

import sys
from pathlib import Path

import eyecore
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "bench"))

import eye_rays


@pytest.mark.parametrize("model", eye_rays.SCHEMATIC)
def test_a_fitted_ray_costs_between_a_thin_and_an_exact_one(model: str) -> None:
    """Found: 17 times as long as a thin eye's, the copy included, and 0.15 of an exact one's."""

    def ns(*of, **more) -> float:
        return min(eye_rays.ray_ns(eye_rays.make_eye(*of, **more), 555.0, 1000) for _ in range(5))

    fitted_ns = ns(model)
    assert fitted_ns < 30.0 * ns("paraxial")
    assert fitted_ns < 0.5 * ns(model, exact_trace=True)


@pytest.mark.parametrize("wavelength_nm", eye_rays.WAVELENGTHS_NM)
@pytest.mark.parametrize("model", eyecore.EYE_MODELS)
def test_a_ray_is_as_exact_as_its_model(model: str, wavelength_nm: float) -> None:
    error = eye_rays.ray_error(model, wavelength_nm, 200)
    assert error.other_fates == 0
    assert 0.0 <= error.median_arcmin <= error.largest_arcmin
    if model in ("paraxial", "wavefront"):
        assert error.largest_arcmin < 1e-9  # rounding
    elif model in eye_rays.SCHEMATIC:
        assert 0.0 < error.largest_arcmin < 0.02  # what the fit may be off by
    else:
        assert error.median_arcmin > 0.1  # no blur, or the paper's
