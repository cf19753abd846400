// The one table of render passes; the film, the bindings and the add-on read it.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace eye_render {

enum class Pass { Combined, Depth, Normal, Albedo, Defocus, Blur, SampleWeight };

struct PassInfo {
    Pass pass;
    std::string_view name;
    std::string_view channel_ids;
    // True: the mean over all samples, or what belongs to it. False: what the ray through the
    // pixel's centre and the pupil's centre meets, which neither blur nor antialiasing mixes with
    // its neighbours.
    bool is_mean;

    [[nodiscard]] constexpr std::size_t channels() const { return channel_ids.size(); }
};

// Depth of nothing, as Blender's own engines write it.
inline constexpr float background_depth = 1e10f;

inline constexpr std::array pass_table{
    PassInfo{Pass::Combined, "Combined", "RGBA", true},
    // Distance along the viewing axis, scene units.
    PassInfo{Pass::Depth, "Depth", "Z", false},
    PassInfo{Pass::Normal, "Normal", "XYZ", true},
    PassInfo{Pass::Albedo, "Albedo", "RGB", true},
    // Mean of the paraxial E = K - I/x, dioptres: positive where the eye is focused nearer than
    // the surface.
    PassInfo{Pass::Defocus, "Defocus", "X", false},
    // Major diameter of the paraxial blur ellipse, arcmin: of focus and astigmatism as next to the
    // axis, without aberrations of higher order.
    PassInfo{Pass::Blur, "Blur", "X", false},
    // By what Combined was divided, channel by channel, and in A the other means: the number of
    // samples, unless wavelengths or points of the pupil count differently. Pictures I of sample
    // ranges, with weights W, make the whole: sum(W I) / sum(W).
    PassInfo{Pass::SampleWeight, "Sample Weight", "RGBA", true},
};

[[nodiscard]] constexpr const PassInfo& info(Pass pass)
{
    return pass_table[static_cast<std::size_t>(pass)];
}

[[nodiscard]] constexpr std::optional<Pass> pass_named(std::string_view name)
{
    for (const PassInfo& entry : pass_table) {
        if (entry.name == name) {
            return entry.pass;
        }
    }
    return std::nullopt;
}

}  // namespace eye_render
