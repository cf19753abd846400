// An eye behind a thin lens, exact to first order: the ray that the eye sends out advances to the
// lens, is bent there by slope' = slope - F p, and leaves from there. Spectacle magnification, the
// vertex distance of either prescription and crossed cylinders follow from that and need no
// formula of their own.

#include "eye/worn_lens.h"

#include "base/error.h"
#include "base/units.h"
#include "eye/models.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

class CorrectedEye final : public EyeModel {
public:
    CorrectedEye(std::unique_ptr<const EyeModel> eye, WornLens lens)
        : eye_(std::move(eye)), lens_(std::move(lens))
    {
    }

    [[nodiscard]] EyeRay ray(const V2d& chief_slope,
                             const V2d& pupil_point_m,
                             double wavelength_nm) const override
    {
        EyeRay ray = eye_->ray(chief_slope, pupil_point_m, wavelength_nm);
        // Forward is -Z.
        const double advance_m = ray.origin_eye_m.z + lens_.distance_m;
        const V2d at_lens_m = V2d(ray.origin_eye_m.x, ray.origin_eye_m.y) + ray.slope * advance_m;
        ray.origin_eye_m = {at_lens_m.x, at_lens_m.y, -lens_.distance_m};
        ray.slope += lens_.prism_slope - lens_.power_d * at_lens_m;
        return ray;
    }

    // The prescription that is left, as seen for distant objects.
    [[nodiscard]] PowerMatrix retinal_conjugate_d() const override { return error_d(0.0); }

    // With d the lens's distance, a = 1 - d X and F its power, light from X reaches the pupil with
    // the vergence (I - d a F)^-1 (X I - a F): no case of its own for X = 1/d, an object at the
    // lens. What is nearer than that is not seen through it, and counts as a = 0. An object
    // has X >= 0, so 0 <= a <= 1, and the vergence is singular only for a lens whose focus is the
    // pupil. For X < 0, light that converges to behind the pupil, as where a hyperope's far point
    // is sought, a is more than 1, and a lens is singular that focuses it in the pupil.
    [[nodiscard]] PowerMatrix error_d(double object_vergence_d) const override
    {
        const double d = lens_.distance_m;
        const double a = std::max(0.0, 1.0 - d * object_vergence_d);
        const PowerMatrix& f = lens_.power_d;
        // Both matrices have F's axes, so the vergence is a sphere and a multiple of F's own
        // astigmatism.
        const double axis = f.astigmatism_d();
        const auto vergence = [&](double f_d) {
            return (object_vergence_d - a * f_d) / (1.0 - d * a * f_d);
        };
        const double most = vergence(f.mean_d() + axis);
        const double least = vergence(f.mean_d() - axis);
        const double mean = 0.5 * (most + least);
        const double j_per_j = axis > 0.0 ? 0.5 * (most - least) / axis : 0.0;
        const PowerMatrix arriving{mean + j_per_j * f.j0_d(), j_per_j * f.j45_d(),
                                   mean - j_per_j * f.j0_d()};
        return eye_->retinal_conjugate_d() - arriving;
    }

    [[nodiscard]] double pupil_diameter_m() const override { return eye_->pupil_diameter_m(); }

    [[nodiscard]] bool is_chromatic() const override { return eye_->is_chromatic(); }

    [[nodiscard]] bool is_first_order() const override { return eye_->is_first_order(); }

    [[nodiscard]] std::optional<double> fitted_field_deg() const override
    {
        return eye_->fitted_field_deg();
    }

    [[nodiscard]] double max_accommodation_d() const override
    {
        return eye_->max_accommodation_d();
    }

    // The lens turns an error of the eye's slope by I - d F, and by -F what it is off at the
    // pupil, which the eye's ray reaches from the cornea with that error.
    [[nodiscard]] double approximation_arcmin() const override
    {
        const PowerMatrix& f = lens_.power_d;
        const auto gain = [&](double f_d) {
            return std::abs(1.0 - lens_.distance_m * f_d) +
                   cornea_to_entrance_pupil_m * std::abs(f_d);
        };
        return eye_->approximation_arcmin() * std::max(gain(f.mean_d() + f.astigmatism_d()),
                                                       gain(f.mean_d() - f.astigmatism_d()));
    }

private:
    std::unique_ptr<const EyeModel> eye_;
    WornLens lens_;
};

// Throws std::invalid_argument for a lens that neither glasses() nor contact_lens() can have made.
void require_valid(const WornLens& lens)
{
    constexpr double max_distance_m = max_vertex_m + cornea_to_entrance_pupil_m;
    constexpr double rounded_up = 1.0 + 1e-12;
    constexpr double max_prism_slope = rounded_up * 0.01 * max_prism_pd;
    require_range("distance of the worn lens", mm_from_m(lens.distance_m), 0.0,
                  mm_from_m(max_distance_m), "mm");
    require_prescribable(lens.power_d, "the worn lens");
    for (const double slope : {lens.prism_slope.x, lens.prism_slope.y}) {
        require_range("prism slope of the worn lens", slope, -max_prism_slope, max_prism_slope,
                      "");
    }
}

}  // namespace

WornLens glasses(const Prescription& rx, double vertex_m)
{
    require_valid(rx);
    require_range("vertex_mm", mm_from_m(vertex_m), 0.0, mm_from_m(max_vertex_m), "mm");
    WornLens lens{.power_d = power_matrix_camera(rx),
                  .distance_m = vertex_m + cornea_to_entrance_pupil_m,
                  .prism_slope = prism_slope(rx)};
    const double strongest_d = lens.power_d.mean_d() + lens.power_d.astigmatism_d();
    // Beyond that the pupil lies at the lens's focus and sees no picture.
    constexpr double nearest_focal_lengths = 0.9;
    if (strongest_d * lens.distance_m > nearest_focal_lengths) {
        throw std::invalid_argument("glasses of " + number_text(strongest_d) + " D worn " +
                                    number_text(mm_from_m(vertex_m)) +
                                    " mm before the eye have their focus at the pupil; expected "
                                    "at most " +
                                    number_text(nearest_focal_lengths / lens.distance_m) + " D");
    }
    return lens;
}

WornLens contact_lens(const Prescription& rx)
{
    require_valid(rx);
    return {.power_d = power_matrix_camera(rx),
            .distance_m = cornea_to_entrance_pupil_m,
            .prism_slope = prism_slope(rx)};
}

std::unique_ptr<EyeModel> make_corrected_eye(std::unique_ptr<const EyeModel> eye,
                                             const WornLens& lens)
{
    require_valid(lens);
    return std::make_unique<CorrectedEye>(std::move(eye), lens);
}

}  // namespace eye_render
