// The pupil patterns.

#include "eye/pupil_pattern.h"

#include "base/units.h"
#include "base/warp.h"

namespace eye_render {

namespace {

// r = DistantIndex / DistantFactor, phi = 2 pi / AngleFactor (AngleIndex + r): consecutive samples
// run out along one arm.
V2d circinate_point(const PupilPattern& pattern, std::uint32_t sample)
{
    const std::uint32_t distant_index = sample % pattern.distant_factor;
    const std::uint32_t angle_index = sample / pattern.distant_factor % pattern.angle_factor;
    const double r = static_cast<double>(distant_index) / pattern.distant_factor;
    const double phi_rad = 2.0 * pi / pattern.angle_factor * (angle_index + r);
    return {r * std::cos(phi_rad), r * std::sin(phi_rad)};
}

}  // namespace

std::string_view to_string(PupilPatternKind kind)
{
    switch (kind) {
    case PupilPatternKind::Sobol: return "SOBOL";
    case PupilPatternKind::Circinate: return "CIRCINATE";
    }
    return "";
}

PupilPattern make_pupil_pattern(PupilPatternKind kind, std::uint32_t samples)
{
    const auto rings = static_cast<std::uint32_t>(std::lround(std::sqrt(double(samples))));
    return {.kind = kind, .distant_factor = rings, .angle_factor = (samples + rings - 1) / rings};
}

V2d pupil_point(const PupilPattern& pattern, std::uint32_t sample, const V2f& u)
{
    if (pattern.kind == PupilPatternKind::Circinate) {
        return circinate_point(pattern, sample);
    }
    const V2f p = sample_uniform_disk(u);
    return {p.x, p.y};
}

}  // namespace eye_render
