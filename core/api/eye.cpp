#include "api/eye.h"

#include "analysis/through_focus.h"
#include "base/error.h"
#include "base/units.h"

#include <cmath>
#include <stdexcept>

namespace eye_render {

namespace {

// The eye's own prescription as a lens in the plane of the correction, so that it sees well.
Prescription full_correction(const EyeDescription& description)
{
    const double lens_m = description.correction == Correction::Glasses
                              ? m_from_mm(description.vertex_mm) + cornea_to_entrance_pupil_m
                              : cornea_to_entrance_pupil_m;
    const double written_m = description.rx_plane == RxPlane::Spectacle
                                 ? m_from_mm(description.vertex_mm) + cornea_to_entrance_pupil_m
                             : description.rx_plane == RxPlane::Cornea ? cornea_to_entrance_pupil_m
                                                                       : 0.0;
    Prescription lens = description.rx;
    if (lens_m != written_m) {
        const Prescription moved = prescription_from(
            moved_toward_eye(power_matrix_tabo(description.rx), written_m - lens_m));
        lens.sphere_d = moved.sphere_d;
        lens.cylinder_d = moved.cylinder_d;
        lens.axis_deg = moved.axis_deg;
    }
    if (description.correction == Correction::Contacts) {
        // A contact lens turns on the eye, so nobody orders one with a prism.
        lens.base_in_pd = lens.base_up_pd = 0.0;
    }
    return lens;
}

std::optional<WornLens> worn_lens(const EyeDescription& description)
{
    if (description.near_part && description.correction != Correction::Glasses) {
        throw std::invalid_argument("near_part is set with correction '" +
                                    std::string(to_string(description.correction)) +
                                    "'; expected 'glasses', which alone have a part for reading");
    }
    if (description.correction == Correction::None) {
        if (description.worn) {
            throw std::invalid_argument(
                "worn is given with correction 'none'; expected 'glasses' or 'contacts'");
        }
        return std::nullopt;
    }
    Prescription rx = description.worn ? *description.worn : full_correction(description);
    if (description.correction == Correction::Contacts) {
        return contact_lens(rx);
    }
    if (description.near_part) {
        rx.sphere_d += rx.add_d;
    }
    return glasses(rx, m_from_mm(description.vertex_mm));
}

}  // namespace

std::string_view to_string(Correction correction)
{
    switch (correction) {
    case Correction::None: return "none";
    case Correction::Glasses: return "glasses";
    case Correction::Contacts: return "contacts";
    }
    return "";
}

std::unique_ptr<EyeModel> make_eye(const EyeDescription& description)
{
    require_range("vertex_mm", description.vertex_mm, 0.0, mm_from_m(max_vertex_m), "mm");
    return make_eye(EyeSpec{.model = description.model,
                            .rx = description.rx,
                            .rx_plane = description.rx_plane,
                            .vertex_m = m_from_mm(description.vertex_mm),
                            .pupil_diameter_m = m_from_mm(description.pupil_mm),
                            .accommodation_d = description.accommodation_d,
                            .zero = description.refraction_zero,
                            .exact_trace = description.exact_trace,
                            .wavefront = description.wavefront,
                            .worn = worn_lens(description)});
}

double object_vergence_d(double distance_m)
{
    // Written so that NaN is refused.
    if (!(distance_m >= min_object_distance_m)) {
        throw std::invalid_argument("distance_m is " + number_text(distance_m) +
                                    " m; expected at least " + number_text(min_object_distance_m) +
                                    " m");
    }
    return 1.0 / distance_m;
}

BlurEllipse blur_at(const EyeModel& eye, double distance_m)
{
    return blur_ellipse(eye.error_d(object_vergence_d(distance_m)), eye.pupil_diameter_m());
}

double line_spread_arcmin(const EyeModel& eye, double line_deg, double distance_m)
{
    require_range("line_deg", line_deg, -360.0, 360.0, "degrees");
    return line_spread_rms_arcmin(eye.error_d(object_vergence_d(distance_m)),
                                  eye.pupil_diameter_m(), line_deg);
}

std::string wavefront_text(const Wavefront& wavefront)
{
    std::string list;
    for (const double coefficient_um : wavefront.coefficients_um) {
        list += (list.empty() ? "" : ", ") + number_text(coefficient_um);
    }
    return "Wavefront([" + list +
           "], pupil_mm=" + number_text(mm_from_m(wavefront.pupil_diameter_m)) +
           ", wavelength_nm=" + number_text(wavefront.wavelength_nm) + ")";
}

double far_point_m(const EyeModel& eye)
{
    constexpr double rounding_d = 1e-9;  // a million kilometres
    const auto rounded_distance_m = [](double vergence_d) {
        return distance_m(std::abs(vergence_d) < rounding_d ? 0.0 : vergence_d);
    };
    const ThroughFocus focus = through_focus(eye);
    if (focus.best_focus_d) return rounded_distance_m(focus.conjugate_d.mean_d());
    // No light through a closed pupil: where its blur would be least if it opened a little.
    // Newton's method: at once for a bare eye, whose error falls by 1 D for each dioptre of the
    // object's vergence; behind a lens it is nearly so.
    double vergence_d = 0.0;
    for (int step = 0; step < 20; ++step) {
        const double error_d = eye.error_d(vergence_d).mean_d();
        vergence_d += error_d / (error_d - eye.error_d(vergence_d + 1.0).mean_d());
    }
    return rounded_distance_m(vergence_d);
}

double pupil_diameter_mm(PupilFormula formula, const PupilConditions& conditions)
{
    // Written so that NaN is refused.
    if (!(conditions.luminance_cd_m2 >= 0.0)) {
        throw std::invalid_argument("luminance_cd_m2 is " +
                                    number_text(conditions.luminance_cd_m2) +
                                    " cd/m2; expected 0 cd/m2 or more");
    }
    return mm_from_m(pupil_size(formula, conditions).diameter_m);
}

}  // namespace eye_render
