// Photometric profiles of luminaires: IESNA LM-63 files (1986 to 2019), types A, B and C.
//
// What becomes of a file is what Blender's Cycles makes of it: type B is laid out with its angles
// exchanged, type A turned to the circle of type C, quarters and halves are mirrored where they
// follow from symmetry, and candela become the watts of a lamp that sends as much everywhere, by
// the efficacy of daylight (D65).

#pragma once

#include <string_view>
#include <vector>

namespace eye_render {

class IesProfile {
public:
    // Both lists of angles ascend and have at least one entry; `watts` has one row of vertical
    // angles for each horizontal one.
    IesProfile(std::vector<float> horizontal_rad,
               std::vector<float> vertical_rad,
               std::vector<float> watts);

    // Cubic interpolation (Catmull and Rom) across both angles: horizontal from 0 to 2 pi around
    // the lamp's axis, vertical from the axis. 0 outside of what was measured; never negative.
    // As in Blender 4.3, the neighbour that an interval lacks at the end of a table is dark, but
    // below the nadir the table is mirrored. So a profile that is the same all around is up to an
    // eighth brighter opposite to its one row.
    [[nodiscard]] float at(float horizontal_rad, float vertical_rad) const;

private:
    [[nodiscard]] float along_vertical(std::size_t row, std::size_t first, float share) const;

    std::vector<float> horizontal_rad_;
    std::vector<float> vertical_rad_;
    std::vector<float> watts_;
    bool has_nadir_;  // as the first vertical angle
};

// 1 candela in all directions, as watts of a lamp.
inline constexpr double watts_per_candela = 0.0706650768394;  // 4 pi / 177.83 lm/W

// Throws std::invalid_argument that says what of the text is not a profile.
[[nodiscard]] IesProfile parse_ies(std::string_view text);

}  // namespace eye_render
