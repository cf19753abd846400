#include "api/eye_analysis.h"

#include "analysis/diffraction.h"
#include "analysis/mtf.h"
#include "analysis/psf.h"
#include "analysis/through_focus.h"
#include "api/eye.h"
#include "base/error.h"
#include "base/units.h"
#include "eye/eye_factory.h"

#include <cmath>

namespace eye_render {

namespace {

void require_wavelength(double wavelength_nm)
{
    require_range("wavelength_nm", wavelength_nm, min_wavelength_nm, max_wavelength_nm, "nm");
}

void require_pupil(double pupil_mm)
{
    require_range("pupil_mm", pupil_mm, 0.01, mm_from_m(max_pupil_diameter_m), "mm");
}

void require_frequencies(std::span<const double> frequencies_cpd)
{
    for (const double frequency_cpd : frequencies_cpd) {
        require_range("frequencies_cpd", frequency_cpd, 0.0, 1e4, "cycles/degree");
    }
}

PupilTrace trace(const EyeModel& eye, const PointView& view)
{
    constexpr double widest_field_deg = 80.0;
    constexpr double most_samples = 1 << 24;
    require_range("field_deg", view.field_deg.x, -widest_field_deg, widest_field_deg, "degrees");
    require_range("field_deg", view.field_deg.y, -widest_field_deg, widest_field_deg, "degrees");
    require_wavelength(view.wavelength_nm);
    require_range("samples", view.samples, 1.0, most_samples, "rays");
    return trace_pupil(eye, {.chief_slope = {std::tan(rad_from_deg(view.field_deg.x)),
                                             std::tan(rad_from_deg(view.field_deg.y))},
                             .wavelength_nm = view.wavelength_nm,
                             .samples = view.samples});
}

Spot spot(const EyeModel& eye, const PointView& view)
{
    const double vergence_d = object_vergence_d(view.distance_m);
    return make_spot(trace(eye, view), vergence_d);
}

}  // namespace

SpotDiagram spot_diagram(const EyeModel& eye, const PointView& view)
{
    const double vergence_d = object_vergence_d(view.distance_m);
    const PupilTrace rays = trace(eye, view);
    SpotDiagram diagram;
    diagram.counts = rays.counts;
    for (const SpotPoint& point : make_spot(rays, vergence_d).points) {
        diagram.points_arcmin.push_back(point.angle_rad * arcmin_from_rad(1.0));
        diagram.weights.push_back(point.weight);
    }
    return diagram;
}

BlurEllipse spot_ellipse(const EyeModel& eye, const PointView& view)
{
    return spot_ellipse(spot_moments(spot(eye, view)));
}

std::vector<double> psf(const EyeModel& eye,
                        const PointView& view,
                        double size_arcmin,
                        int resolution)
{
    require_range("size_arcmin", size_arcmin, 1e-3, 180.0 * 60.0, "arcmin");
    require_range("resolution", resolution, 1.0, 4096.0, "pixels");
    return point_spread(spot(eye, view), {.size_rad = size_arcmin / arcmin_from_rad(1.0),
                                          .resolution = resolution});
}

std::vector<double> mtf(const EyeModel& eye,
                        const PointView& view,
                        std::span<const double> frequencies_cpd,
                        double meridian_deg,
                        bool diffraction)
{
    require_frequencies(frequencies_cpd);
    require_range("meridian_deg", meridian_deg, -360.0, 360.0, "degrees");
    if (!diffraction) {
        return geometric_mtf(spot(eye, view), meridian_deg, frequencies_cpd);
    }
    require_pupil(pupil_mm(eye));
    return wave_mtf(spot(eye, view),
                    {.diameter_m = eye.pupil_diameter_m(), .wavelength_nm = view.wavelength_nm},
                    meridian_deg, frequencies_cpd);
}

std::vector<double> through_focus_arcmin(const EyeModel& eye,
                                         const PointView& view,
                                         std::span<const double> vergences_d)
{
    const PupilTrace rays = trace(eye, view);
    std::vector<double> radii_arcmin;
    for (const double vergence_d : vergences_d) {
        require_range("vergences_d", vergence_d, -100.0, 100.0, "D");
        radii_arcmin.push_back(
            arcmin_from_rad(spot_moments(make_spot(rays, vergence_d)).rms_radius_rad()));
    }
    return radii_arcmin;
}

double pupil_mm(const EyeModel& eye) { return mm_from_m(eye.pupil_diameter_m()); }

std::optional<double> best_focus_d(const EyeModel& eye) { return through_focus(eye).best_focus_d; }

bool is_diffraction_limited(const EyeModel& eye, const PointView& view)
{
    require_pupil(pupil_mm(eye));
    return diffraction_dominates(spot_moments(spot(eye, view)), eye.pupil_diameter_m(),
                                 view.wavelength_nm);
}

std::vector<ClearRange> clear_ranges(const EyeModel& relaxed, const EyeModel& accommodated)
{
    return clear_ranges(through_focus(relaxed).conjugate_d,
                        through_focus(accommodated).conjugate_d);
}

std::vector<double> diffraction_mtf(std::span<const double> frequencies_cpd,
                                    double pupil_mm,
                                    double wavelength_nm)
{
    require_frequencies(frequencies_cpd);
    require_pupil(pupil_mm);
    require_wavelength(wavelength_nm);
    std::vector<double> values;
    values.reserve(frequencies_cpd.size());
    for (const double frequency_cpd : frequencies_cpd) {
        values.push_back(diffraction_mtf(frequency_cpd, m_from_mm(pupil_mm), wavelength_nm));
    }
    return values;
}

double airy_radius_arcmin(double pupil_mm, double wavelength_nm)
{
    require_pupil(pupil_mm);
    require_wavelength(wavelength_nm);
    return arcmin_from_rad(airy_radius_rad(m_from_mm(pupil_mm), wavelength_nm));
}

double quarter_wave_d(double pupil_mm, double wavelength_nm)
{
    require_pupil(pupil_mm);
    require_wavelength(wavelength_nm);
    return quarter_wave_defocus_d(m_from_mm(pupil_mm), wavelength_nm);
}

}  // namespace eye_render
