// What an eye makes of a point, for the outside: analysis/ in the user's units, arguments checked.

#pragma once

#include "analysis/blur_ellipse.h"
#include "analysis/pupil_trace.h"
#include "analysis/refraction.h"
#include "eye/eye_model.h"
#include "optics/chromatic.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace eye_render {

// A point, and how its light is sampled.
struct PointView {
    double distance_m = std::numeric_limits<double>::infinity();  // along the axis
    V2d field_deg{0.0};  // to the right and up from the axis, as the patient sees
    double wavelength_nm = reference_wavelength_nm;
    std::uint32_t samples = 65536;
};

// All throw std::invalid_argument with name, value, unit and range.

struct SpotDiagram {
    std::vector<V2d> points_arcmin;
    std::vector<double> weights;
    RayCounts counts;
};

[[nodiscard]] SpotDiagram spot_diagram(const EyeModel& eye, const PointView& view);

[[nodiscard]] BlurEllipse spot_ellipse(const EyeModel& eye, const PointView& view);

// As `point_spread`.
[[nodiscard]] std::vector<double> psf(const EyeModel& eye,
                                      const PointView& view,
                                      double size_arcmin,
                                      int resolution);

// As `geometric_mtf` or, with `diffraction`, `wave_mtf`.
[[nodiscard]] std::vector<double> mtf(const EyeModel& eye,
                                      const PointView& view,
                                      std::span<const double> frequencies_cpd,
                                      double meridian_deg,
                                      bool diffraction);

// RMS radius of the spot at each object vergence; the view's distance is not read.
[[nodiscard]] std::vector<double> through_focus_arcmin(const EyeModel& eye,
                                                       const PointView& view,
                                                       std::span<const double> vergences_d);

[[nodiscard]] double pupil_mm(const EyeModel& eye);

// On the axis at 555 nm. The optional is empty for an eye that focuses nowhere.
[[nodiscard]] std::optional<double> best_focus_d(const EyeModel& eye);

[[nodiscard]] bool is_diffraction_limited(const EyeModel& eye, const PointView& view);

// Of two states of one eye.
[[nodiscard]] std::vector<ClearRange> clear_ranges(const EyeModel& relaxed,
                                                   const EyeModel& accommodated);

// Pupils above 0 mm.
[[nodiscard]] std::vector<double> diffraction_mtf(std::span<const double> frequencies_cpd,
                                                  double pupil_mm,
                                                  double wavelength_nm);
[[nodiscard]] double airy_radius_arcmin(double pupil_mm, double wavelength_nm);
[[nodiscard]] double quarter_wave_d(double pupil_mm, double wavelength_nm);

}  // namespace eye_render
