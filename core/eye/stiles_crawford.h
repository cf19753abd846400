// The Stiles-Crawford effect of the first kind: cones see light the less, the farther from their
// favourite point of the pupil it entered. For photopic vision; rods show next to none of it.
//
// eta = 10^(-rho_x x^2 - rho_y y^2), x and y in millimetres of the entrance pupil from the peak:
// Applegate & Lakshminarayanan 1993, "Parametric representation of Stiles-Crawford functions" (J.
// Opt. Soc. Am. A 10), eq. 1 and the means of their normal eyes, fitted to 3 mm from the centre.
// With log10, as printed; over e their rho would be 0.115 per square millimetre.

#pragma once

#include "base/vector.h"
#include "optics/prescription.h"

#include <array>
#include <string_view>

namespace eye_render {

// What becomes of the light that the cones see less of.
enum class StilesCrawfordMode {
    Off,         // all of the pupil counts the same
    Brightness,  // the weights have the mean 1: blur is shaped, the picture keeps its brightness
    Energy,      // the picture darkens by effective_area_ratio, and where the eye loses rays
};

inline constexpr std::array stiles_crawford_modes{
    StilesCrawfordMode::Off, StilesCrawfordMode::Brightness, StilesCrawfordMode::Energy};

// "OFF", "BRIGHTNESS", "ENERGY".
[[nodiscard]] std::string_view to_string(StilesCrawfordMode mode);

struct ConeDirectivity {
    double rho_x_per_mm2 = 0.047;  // horizontal
    double rho_y_per_mm2 = 0.053;  // vertical
    V2d peak_m{0.0};               // camera frame

    // eta, 1 at the peak.
    [[nodiscard]] double efficiency(const V2d& pupil_point_m) const;
};

// How far from the pupil's centre the fit goes. Farther out, eta falls on as it does.
inline constexpr double max_measured_radius_m = 3e-3;

// The mean peak lies 0.51 mm towards the nose and 0.20 mm up. Without one side, where the nose
// would be unknown, it is the mean of both eyes: on the vertical meridian.
[[nodiscard]] ConeDirectivity cone_directivity(EyeSide eye);

// The weights of the points of one pupil.
//
// A weight serves any pupil pattern as it is. Measured against it, in variance of the mean over
// the pupil by 64 Sobol points: a radial warp towards eta that leaves the rest to a weight gains
// 1.1 times with a pupil of 4 mm and 1.4 times with 6 mm for an edge and for stripes, 4.9 and 1.3
// times for a concentric disk of half the area.
class StilesCrawford {
public:
    StilesCrawford(const ConeDirectivity& directivity, double pupil_diameter_m);

    // Has the mean 1 over the evenly filled pupil: it shapes blur and leaves brightness alone.
    [[nodiscard]] double weight(const V2d& pupil_point_m) const
    {
        return directivity_.efficiency(pupil_point_m) / effective_area_ratio_;
    }

    // The mean of eta: what part of the pupil's area would do as well if all of it were peak.
    [[nodiscard]] double effective_area_ratio() const { return effective_area_ratio_; }

private:
    ConeDirectivity directivity_;
    double effective_area_ratio_;
};

}  // namespace eye_render
