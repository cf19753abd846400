// The pupil patterns.

#include "eye/pupil_pattern.h"

#include "base/sobol.h"
#include "base/units.h"
#include "base/warp.h"

namespace eye_render {

namespace {

struct GridIndex {
    std::uint32_t distant = 0;
    std::uint32_t angle = 0;
};

GridIndex grid_index(const PupilPattern& pattern, std::uint32_t number)
{
    return {number % pattern.distant_factor,
            number / pattern.distant_factor % pattern.angle_factor};
}

V2d disk_point(const V2f& u)
{
    const V2f p = sample_uniform_disk(u);
    return {p.x, p.y};
}

// r = DistantIndex / DistantFactor, phi = 2 pi / AngleFactor (AngleIndex + r): consecutive samples
// run out along one arm.
V2d circinate_point(const PupilPattern& pattern, std::uint32_t number)
{
    const GridIndex index = grid_index(pattern, number);
    const double r = static_cast<double>(index.distant) / pattern.distant_factor;
    const double phi_rad = 2.0 * pi / pattern.angle_factor * (index.angle + r);
    return {r * std::cos(phi_rad), r * std::sin(phi_rad)};
}

V2f grid_cell_centre(const PupilPattern& pattern, std::uint32_t number)
{
    const GridIndex index = grid_index(pattern, number);
    const auto position = [](std::uint32_t cell, std::uint32_t cells) {
        return static_cast<float>((cell + 0.5) / cells);
    };
    return {position(index.distant, pattern.distant_factor),
            position(index.angle, pattern.angle_factor)};
}

// A hash of pixel and sample number that sobol_4d makes no use of.
V2f random_pair(const PupilSample& sample)
{
    const std::uint64_t bits =
        detail::mix_bits(detail::mix_bits(sample.pixel_key) + sample.number);
    // 24 bits each: what a float holds exactly, so that rounding never yields 1.
    return V2f(static_cast<float>(bits >> 40),
               static_cast<float>(static_cast<std::uint32_t>(bits) >> 8)) *
           0x1p-24f;
}

}  // namespace

std::string_view to_string(PupilPatternKind kind)
{
    switch (kind) {
    case PupilPatternKind::Sobol: return "SOBOL";
    case PupilPatternKind::Circinate: return "CIRCINATE";
    case PupilPatternKind::UniformRandom: return "UNIFORM_RANDOM";
    case PupilPatternKind::Grid: return "GRID";
    }
    return "";
}

PupilPattern make_pupil_pattern(PupilPatternKind kind, std::uint32_t samples)
{
    const auto rings = static_cast<std::uint32_t>(std::lround(std::sqrt(double(samples))));
    return {.kind = kind, .distant_factor = rings, .angle_factor = (samples + rings - 1) / rings};
}

V2d pupil_point(const PupilPattern& pattern, const PupilSample& sample)
{
    switch (pattern.kind) {
    case PupilPatternKind::Sobol: return disk_point(sample.u);
    case PupilPatternKind::Circinate: return circinate_point(pattern, sample.number);
    case PupilPatternKind::UniformRandom: return disk_point(random_pair(sample));
    case PupilPatternKind::Grid: return disk_point(grid_cell_centre(pattern, sample.number));
    }
    return {0.0, 0.0};
}

}  // namespace eye_render
