// The spot of a point: where its rays appear in the picture, and their moments.
//
// A pixel gathers light from the slope s at which its rays leave the eye, so a point in the
// direction of the chief ray is scattered the other way: by +E p for the error matrix E = K - X I
// and the pupil point p. Angles are the picture's, relative to the chief ray, to first order in
// the blur: each ray's miss is divided by how much its own slope follows the pixel's. The axes are
// the camera's, turned by the smallest turn that brings -Z onto the chief ray.

#pragma once

#include "analysis/blur_ellipse.h"
#include "analysis/pupil_trace.h"

namespace eye_render {

struct SpotPoint {
    V2d pupil_point_m{0.0};
    V2d angle_rad{0.0};
    double weight = 1.0;
};

struct Spot {
    std::vector<SpotPoint> points;
    double weight = 0.0;       // their sum
    double transmitted = 0.0;  // the mean weight of all rays, lost ones included, 0 to 1
};

[[nodiscard]] Spot make_spot(const PupilTrace& trace, double object_vergence_d);

struct SpotMoments {
    V2d mean_rad{0.0};
    double xx = 0.0;  // central second moments, radians squared
    double xy = 0.0;
    double yy = 0.0;

    [[nodiscard]] double rms_radius_rad() const { return std::sqrt(xx + yy); }
};

// All 0 when nothing is transmitted.
[[nodiscard]] SpotMoments spot_moments(const Spot& spot);

// The evenly filled ellipse with these second moments. For an eye without higher aberrations and
// with an evenly filled pupil it is the blur itself.
[[nodiscard]] BlurEllipse spot_ellipse(const SpotMoments& moments);

}  // namespace eye_render
