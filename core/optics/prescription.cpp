// Prescription algebra; see prescription.h for frames and sources.

#include "optics/prescription.h"

#include "base/error.h"
#include "base/units.h"

namespace eye_render {

namespace {

// Below this an astigmatism is rounding noise of its own conversion and its axis is undefined.
constexpr double no_astigmatism_d = 1e-12;

// How near to a lens's focus its plane may be moved, as a fraction of the focal length.
constexpr double nearest_focus_fraction = 0.1;

}  // namespace

void require_valid(const Prescription& rx)
{
    require_range("sphere_d", rx.sphere_d, -max_sphere_d, max_sphere_d, "D");
    require_range("cylinder_d", rx.cylinder_d, -max_cylinder_d, max_cylinder_d, "D");
    require_range("axis_deg", rx.axis_deg, 0.0, 180.0, "");
    require_range("add_d", rx.add_d, 0.0, max_add_d, "D");
    require_range("base_in_pd", rx.base_in_pd, -max_prism_pd, max_prism_pd, "prism dioptres");
    require_range("base_up_pd", rx.base_up_pd, -max_prism_pd, max_prism_pd, "prism dioptres");
}

void require_prescribable(const PowerMatrix& power, std::string_view name)
{
    constexpr double rounded_up = 1.0 + 1e-12;
    constexpr double max_mean_d = rounded_up * (max_sphere_d + 0.5 * max_cylinder_d);
    const std::string of = " of " + std::string(name);
    require_range("mean sphere" + of, power.mean_d(), -max_mean_d, max_mean_d, "D");
    require_range("cylinder" + of, 2.0 * power.astigmatism_d(), 0.0, rounded_up * max_cylinder_d,
                  "D");
}

V2d prism_slope(const Prescription& rx)
{
    constexpr double slope_per_pd = 0.01;
    if (rx.base_in_pd == 0.0) {
        return {0.0, slope_per_pd * rx.base_up_pd};
    }
    if (rx.eye != EyeSide::Right && rx.eye != EyeSide::Left) {
        throw std::invalid_argument("a prism of " + number_text(rx.base_in_pd) +
                                    " prism dioptres base in needs to know whose nose it points "
                                    "to; expected a prescription with OD or OS");
    }
    const double towards_nose = rx.eye == EyeSide::Right ? -1.0 : 1.0;
    return V2d(towards_nose * rx.base_in_pd, rx.base_up_pd) * slope_per_pd;
}

double normalized_axis_deg(double axis_deg)
{
    const double axis = std::fmod(axis_deg, 180.0);
    // Adding 180 to a tiny negative angle rounds to 180 itself, which is in range.
    return axis > 0.0 ? axis : axis + 180.0;
}

Prescription transposed(const Prescription& rx)
{
    Prescription result = rx;
    result.sphere_d = rx.sphere_d + rx.cylinder_d;
    result.cylinder_d = -rx.cylinder_d;
    result.axis_deg = normalized_axis_deg(rx.axis_deg + 90.0);
    return result;
}

PowerVector power_vector(const Prescription& rx)
{
    const double twice_axis_rad = 2.0 * rad_from_deg(rx.axis_deg);
    const double half_cylinder_d = 0.5 * rx.cylinder_d;
    return {rx.sphere_d + half_cylinder_d, -half_cylinder_d * std::cos(twice_axis_rad),
            -half_cylinder_d * std::sin(twice_axis_rad)};
}

Prescription prescription_from(const PowerVector& power, CylinderForm form)
{
    const double j_d = std::hypot(power.j0_d, power.j45_d);
    if (j_d < no_astigmatism_d) {
        return {.sphere_d = power.m_d};
    }
    const double sign = form == CylinderForm::Minus ? 1.0 : -1.0;
    return {
        .sphere_d = power.m_d + sign * j_d,
        .cylinder_d = -2.0 * sign * j_d,
        .axis_deg = normalized_axis_deg(
            deg_from_rad(0.5 * std::atan2(sign * power.j45_d, sign * power.j0_d))),
    };
}

Prescription prescription_from(const PowerMatrix& power_tabo, CylinderForm form)
{
    return prescription_from(
        PowerVector{power_tabo.mean_d(), power_tabo.j0_d(), power_tabo.j45_d()}, form);
}

PowerMatrix power_matrix_tabo(const Prescription& rx)
{
    const PowerVector power = power_vector(rx);
    return {power.m_d + power.j0_d, power.j45_d, power.m_d - power.j0_d};
}

PowerMatrix power_matrix_camera(const Prescription& rx) { return mirrored(power_matrix_tabo(rx)); }

double camera_angle_deg(double axis_deg) { return 180.0 - normalized_axis_deg(axis_deg); }

Prescription crossed(const Prescription& a, const Prescription& b)
{
    Prescription sum = prescription_from(power_matrix_tabo(a) + power_matrix_tabo(b));
    sum.add_d = a.add_d + b.add_d;
    sum.base_in_pd = a.base_in_pd + b.base_in_pd;
    sum.base_up_pd = a.base_up_pd + b.base_up_pd;
    sum.eye = a.eye;
    return sum;
}

MeridionalPower meridional_power(const PowerMatrix& power, double meridian_deg)
{
    const double angle_rad = rad_from_deg(meridian_deg);
    const V2d along(std::cos(angle_rad), std::sin(angle_rad));
    const V2d across(-along.y, along.x);
    const V2d bent = power * along;
    return {along.dot(bent), across.dot(bent)};
}

PowerMatrix moved_toward_eye(const PowerMatrix& power, double distance_m)
{
    for (const double sign : {-1.0, 1.0}) {
        const double principal_d = power.mean_d() + sign * power.astigmatism_d();
        if (!(1.0 - distance_m * principal_d >= nearest_focus_fraction)) {
            throw std::invalid_argument(
                "a lens of " + number_text(principal_d) + " D cannot be referred to a plane " +
                number_text(mm_from_m(distance_m)) +
                " mm nearer to the eye, at or behind its own focus; expected at " +
                (distance_m < 0.0 ? "least " : "most ") +
                number_text((1.0 - nearest_focus_fraction) / distance_m) + " D");
        }
    }
    // F (I - dF)^-1 = (F - d det(F) I) / det(I - dF): the adjugate of I - dF is I - d adj(F).
    const double det = power.xx_d * power.yy_d - power.xy_d * power.xy_d;
    const double scale =
        1.0 / (1.0 - 2.0 * distance_m * power.mean_d() + distance_m * distance_m * det);
    return {(power.xx_d - distance_m * det) * scale, power.xy_d * scale,
            (power.yy_d - distance_m * det) * scale};
}

}  // namespace eye_render
