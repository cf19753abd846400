#include "analysis/refraction.h"

#include "base/units.h"

namespace eye_render {

std::vector<ClearRange> clear_ranges(const PowerMatrix& relaxed_d,
                                     const PowerMatrix& accommodated_d)
{
    // A cylinder of a nanodioptre is rounding.
    constexpr double round_d = 1e-9;

    std::vector<ClearRange> ranges{
        {.far_d = relaxed_d.mean_d(), .near_d = accommodated_d.mean_d()}};
    const double half_cylinder_d = relaxed_d.astigmatism_d();
    if (half_cylinder_d < round_d) {
        return ranges;
    }
    // The direction of the larger eigenvalue, whose focus is nearer.
    const double nearer_deg = std::fmod(
        deg_from_rad(0.5 * std::atan2(relaxed_d.j45_d(), relaxed_d.j0_d())) + 180.0, 180.0);
    ranges.push_back({.meridian_deg = std::fmod(nearer_deg + 90.0, 180.0),
                      .far_d = relaxed_d.mean_d() - half_cylinder_d,
                      .near_d = accommodated_d.mean_d() - accommodated_d.astigmatism_d()});
    ranges.push_back({.meridian_deg = nearer_deg,
                      .far_d = relaxed_d.mean_d() + half_cylinder_d,
                      .near_d = accommodated_d.mean_d() + accommodated_d.astigmatism_d()});
    return ranges;
}

}  // namespace eye_render
