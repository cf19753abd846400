// A search by golden section, ended by the parabola through what is left. The square of the RMS
// radius is a parabola in the accommodation as far as this changes nothing but the focus.

#include "analysis/least_blur.h"

#include "analysis/spot.h"

#include <limits>
#include <stdexcept>

namespace eye_render {

namespace {

constexpr double unseen = std::numeric_limits<double>::infinity();

// Mean square of the spot's radius; infinite where there is no such eye, or no light in it.
double blur_rad2(const EyeAtAccommodation& eye_at,
                 double accommodation_d,
                 double object_vergence_d)
{
    // The same points every time, so their unevenness hardly moves the least of the blurs.
    constexpr std::uint32_t points = 128;
    try {
        const auto eye = eye_at(accommodation_d);
        const Spot spot = make_spot(trace_pupil(*eye, {.samples = points}), object_vergence_d);
        const SpotMoments moments = spot_moments(spot);
        return spot.weight > 0.0 ? moments.xx + moments.yy : unseen;
    } catch (const std::invalid_argument&) {
        return unseen;
    }
}

struct Blur {
    double accommodation_d = 0.0;
    double rad2 = 0.0;
};

// Where the parabola through three points has its vertex, or the middle one when it has none
// between the outer two.
double vertex_d(const Blur& low, const Blur& middle, const Blur& high)
{
    const double to_low_d = low.accommodation_d - middle.accommodation_d;
    const double to_high_d = high.accommodation_d - middle.accommodation_d;
    const double slope_low = (low.rad2 - middle.rad2) / to_low_d;
    const double slope_high = (high.rad2 - middle.rad2) / to_high_d;
    const double curvature = (slope_high - slope_low) / (to_high_d - to_low_d);
    const double step_d = 0.5 * (to_low_d - slope_low / curvature);
    const bool is_between = curvature > 0.0 && step_d >= to_low_d && step_d <= to_high_d;
    return middle.accommodation_d + (is_between ? step_d : 0.0);
}

}  // namespace

double least_blur_accommodation_d(const EyeAtAccommodation& eye_at,
                                  double object_vergence_d,
                                  double amplitude_d)
{
    // Over so little the parabola is right to a hundredth of a dioptre.
    constexpr double bracket_d = 0.3;
    constexpr double golden = 0.6180339887498949;

    const auto blur = [&](double accommodation_d) {
        return Blur{accommodation_d, blur_rad2(eye_at, accommodation_d, object_vergence_d)};
    };
    Blur low = blur(0.0);
    Blur high = blur(amplitude_d);
    const auto inside = [&](double share) {
        return blur(std::lerp(low.accommodation_d, high.accommodation_d, share));
    };
    Blur lower = inside(1.0 - golden);
    Blur upper = inside(golden);
    while (high.accommodation_d - low.accommodation_d > bracket_d) {
        // Of two that cannot be had the lower is nearer to what can.
        if (lower.rad2 <= upper.rad2) {
            high = upper;
            upper = lower;
            lower = inside(1.0 - golden);
        } else {
            low = lower;
            lower = upper;
            upper = inside(golden);
        }
    }
    const Blur& middle = lower.rad2 <= upper.rad2 ? lower : upper;
    Blur best = low;
    for (const Blur& candidate : {middle, blur(vertex_d(low, middle, high)), high}) {
        if (candidate.rad2 < best.rad2) best = candidate;
    }
    return best.accommodation_d;
}

}  // namespace eye_render
