// Blender's sky of Nishita et al. 1993: a table of the sky's light over the upper hemisphere, and
// the sun's disc. Directions are towards the sky, +Z up.

#pragma once

#include "base/working_space.h"
#include "shading/sky.h"
#include "shading/sky/atmosphere.h"

#include <vector>

namespace eye_render {

struct NishitaSettings {
    bool has_disc = true;
    bool sun_hides_sky = true;       // behind it, as before Blender 5
    double sun_size_rad = 0.009512;  // across
    double sun_intensity = 1.0;
    double sun_elevation_rad = 0.2617993951;
    double sun_rotation_rad = 0.0;  // clockwise seen from above, from +Y
    double altitude_m = 0.0;
    Atmosphere atmosphere;
};

// The disc alone, without the work that the table is.
class NishitaSun {
public:
    NishitaSun(const NishitaSettings& settings, WorkingSpace space);

    // Within the disc's rim, above the horizon; otherwise nothing.
    [[nodiscard]] std::optional<Color3f> radiance(const V3f& direction) const;
    [[nodiscard]] std::optional<SunDisc> disc() const;

private:
    bool has_disc_;
    V3f direction_;
    float elevation_rad_;
    float radius_rad_;
    // The air reddens the lower rim. Unclamped.
    Color3f lower_;
    Color3f upper_;
};

class NishitaSky {
public:
    NishitaSky(const NishitaSettings& settings, WorkingSpace space);

    [[nodiscard]] Color3f radiance(const V3f& direction) const;

private:
    [[nodiscard]] Color3f without_sun(const V3f& direction) const;
    [[nodiscard]] Color3f interpolated(float x, float y) const;

    NishitaSun sun_;
    bool sun_hides_sky_;
    float rotation_rad_;
    // Half the sky, as the sun's side mirrors the other; rows closer at the horizon. Unclamped.
    std::vector<Color3f> table_;
};

}  // namespace eye_render
