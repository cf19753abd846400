// Where in the pupil a sample's ray goes.

#pragma once

#include "base/vector.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace eye_render {

enum class PupilPatternKind {
    Sobol,          // fills the pupil evenly, differently in each pixel
    Circinate,      // Wang & Xiao 2013 eq. 9-13: spiral arms, the same in every pixel
    UniformRandom,  // independent points: the plain Monte Carlo to compare with
    Grid,           // rows and columns of points of equal areas, the same in every pixel
};

inline constexpr std::array pupil_pattern_kinds{
    PupilPatternKind::Sobol, PupilPatternKind::Circinate, PupilPatternKind::UniformRandom,
    PupilPatternKind::Grid};

// "SOBOL", "CIRCINATE", "UNIFORM_RANDOM", "GRID".
[[nodiscard]] std::string_view to_string(PupilPatternKind kind);

struct PupilPattern {
    PupilPatternKind kind = PupilPatternKind::Sobol;
    // Of the circinate pattern: rings and arms; of the grid: columns and rows. After as many
    // samples as their product these patterns repeat.
    std::uint32_t distant_factor = 8;
    std::uint32_t angle_factor = 8;
};

// Factors for `samples` samples a pixel, at least 1: as many rings as arms, or nearly. Where
// their product is more than `samples`, the last arm or row is not complete.
[[nodiscard]] PupilPattern make_pupil_pattern(PupilPatternKind kind, std::uint32_t samples);

// A pixel's sample, of which each pattern uses what it needs.
struct PupilSample {
    std::uint64_t pixel_key = 0;  // as sobol_key gives it
    std::uint32_t number = 0;
    V2f u{0.0f};  // the sample's own pair of Sobol numbers
};

// The pupil point of a sample, in units of the pupil's radius.
//
// The circinate pattern is printed as is: its ring 0 is the centre alone, its outermost ring lies
// at 1 - 1/distant_factor, and its density falls as 1/r, so it blurs less than a filled pupil
// (RMS radius 0.52 against 0.71 with 8 rings). The grid is a square one that the concentric map of
// Shirley & Chiu bends into the disk, which keeps the areas equal.
[[nodiscard]] V2d pupil_point(const PupilPattern& pattern, const PupilSample& sample);

}  // namespace eye_render
