// What an eye does with an evenly filled pupil, traced once. Spot, PSF, MTF and through-focus
// curve are arithmetic on it, at any object distance.
//
// A ray that crosses the pupil's plane at o (metres) with slope s meets the plane at distance 1/X
// where the slope s + X o, seen from the centre of the pupil, meets it: linear in the object's
// vergence X. The point that is looked at lies on the chief ray of 555 nm.

#pragma once

#include "eye/eye_model.h"
#include "optics/chromatic.h"

#include <cstdint>
#include <vector>

namespace eye_render {

// A line in object space, or the difference of two.
struct ObjectLine {
    V2d slope{0.0};
    V2d crossing_m{0.0};  // with the pupil's plane

    [[nodiscard]] V2d slope_at(double object_vergence_d) const
    {
        return slope + crossing_m * object_vergence_d;
    }
};

struct TracedRay {
    V2d pupil_point_m{0.0};  // that the eye was asked for
    ObjectLine line;
    ObjectLine change_x;  // per unit of chief slope along X,
    ObjectLine change_y;  // and along Y: what glasses magnify, and a wide pupil's coma
    double weight = 1.0;
};

struct RayCounts {
    std::uint32_t transmitted = 0;
    std::uint32_t vignetted = 0;
    std::uint32_t missed = 0;
    std::uint32_t total_reflection = 0;

    [[nodiscard]] double all() const
    {
        return double(transmitted) + vignetted + missed + total_reflection;
    }
};

struct PupilTrace {
    V2d chief_slope{0.0};         // in the picture
    ObjectLine chief;             // the ray through the centre of the pupil
    std::vector<TracedRay> rays;  // the transmitted ones
    RayCounts counts;
};

struct PupilTraceOptions {
    V2d chief_slope{0.0};
    double wavelength_nm = reference_wavelength_nm;
    std::uint32_t samples = 65536;  // a power of 2 fills the pupil most evenly
};

// Pupil points are Owen-scrambled Sobol points under a fixed key: the same every time. Where the
// eye blocks the chief ray, the picture's own slopes stand for it.
[[nodiscard]] PupilTrace trace_pupil(const EyeModel& eye, const PupilTraceOptions& options = {});

}  // namespace eye_render
