// The RGB that all colours of a scene are in: linear, by the primaries and the white of a
// standard.
//
// X, Y and Z are of CIE 1931 with D65 as white, whatever the space's own is: that is adapted by
// Bradford's transform (Lam 1985), as OpenColorIO's configurations have it.

#pragma once

#include "base/vector.h"

#include <cstdint>

namespace eye_render {

enum class WorkingSpace : std::uint8_t {
    Rec709,   // ITU-R BT.709, the primaries of sRGB
    Rec2020,  // ITU-R BT.2020
    AcesCg,   // SMPTE ST 2065-1 Annex D's AP1, of a warmer white
};

// Colours out of the gamut have negative channels.
[[nodiscard]] Color3f rgb_from_xyz(const V3f& xyz, WorkingSpace space);
[[nodiscard]] V3f xyz_from_rgb(const Color3f& rgb, WorkingSpace space);

// The colour that linear Rec. 709 calls so.
[[nodiscard]] Color3f rgb_from_rec709(const Color3f& rec709, WorkingSpace space);

// Y of each channel at 1: their sum is 1.
[[nodiscard]] V3f luminance_weights(WorkingSpace space);

}  // namespace eye_render
