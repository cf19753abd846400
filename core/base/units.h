// Units at the edges. Inside the core everything is SI (metres, radians, nanometres for
// wavelengths) and dioptres (1/m); millimetres and degrees exist at the user's edge and in
// published tables, and are converted with these functions only.

#pragma once

#include <numbers>

namespace eye_render {

inline constexpr double pi = std::numbers::pi;

// A division, so that 9 mm is the double nearest to 0.009 m and comes back as 9 mm.
[[nodiscard]] constexpr double m_from_mm(double length_mm) { return length_mm / 1e3; }
[[nodiscard]] constexpr double mm_from_m(double length_m) { return length_m * 1e3; }
[[nodiscard]] constexpr double m_from_um(double length_um) { return length_um / 1e6; }
[[nodiscard]] constexpr double rad_from_deg(double angle_deg) { return angle_deg * (pi / 180.0); }
[[nodiscard]] constexpr double deg_from_rad(double angle_rad) { return angle_rad * (180.0 / pi); }
[[nodiscard]] constexpr double arcmin_from_rad(double angle_rad)
{
    return angle_rad * (180.0 * 60.0 / pi);
}

}  // namespace eye_render
