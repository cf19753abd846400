// How a rough fibre spreads light along itself and around itself: normalised densities, with their
// inverses. Angles: theta is the elevation from the plane across the fibre, phi the azimuth around
// it, rad.

#pragma once

namespace eye_render {

struct Elevation {
    float sine;
    float cosine;  // not negative

    [[nodiscard]] static Elevation of_sine(float sine);
    // Folded back where it passes the fibre's ends.
    [[nodiscard]] Elevation turned(float angle_rad) const;
};

// Per unit solid angle, times 2 pi: d'Eon, Francois, Hill, Letteri & Aubry 2011, "An
// Energy-Conserving Hair Reflectance Model", eq. 7. Brightest where light leaves as from a mirror.
[[nodiscard]] float along_density(const Elevation& i, const Elevation& o, float variance);
// d'Eon, Marschner & Hanika 2013, "Importance Sampling for Physically-Based Hair Fiber Models",
// section 4.1; u_drop and u_turn in [0, 1].
[[nodiscard]] Elevation sample_along(float u_drop,
                                     float u_turn,
                                     const Elevation& o,
                                     float variance);

// Per radian, from -pi to pi: the logistic distribution cut off there and made whole again
// (Chiang, Bitterli, Tappan & Burley 2016, eq. 8). `phi` counts modulo 2 pi.
[[nodiscard]] float around_density(float phi, float scale);
[[nodiscard]] float sample_around(float u, float scale);

}  // namespace eye_render
