// How far light flies through a medium: distances drawn by the exponential laws of its three
// channels together, each weighed by what it matters, as one-sample multiple importance sampling
// has it (Veach 1997, 9.2.4). Densities are per unit length.

#pragma once

#include "base/vector.h"

namespace eye_render {

class FreeFlight {
public:
    // Through at most `length`, which may be infinite. `importance` is not negative and positive
    // in a channel.
    FreeFlight(const Color3f& extinction, const Color3f& importance, float length);

    // To the next collision; `length` or more if there is none. Both of u in [0, 1).
    [[nodiscard]] float sample(float u_channel, float u) const;
    [[nodiscard]] float pdf(float distance) const;
    // The probability that there is none so far.
    [[nodiscard]] float survival(float distance) const;

    // The same, given that there is one: only where what matters is taken from, in each channel.
    [[nodiscard]] float sample_within(float u_channel, float u) const;
    [[nodiscard]] float pdf_within(float distance) const;

private:
    [[nodiscard]] int choose_channel(float u) const;

    Color3f extinction_;
    Color3f share_;  // of each channel, 1 in all
    float length_;
};

// Distances by the angle under which a point sees them, which makes up for the light that is
// brighter near a lamp (Kulla and Fajardo 2012, "Importance Sampling Techniques for Path Tracing
// in Participating Media", eq. 6).
class EquiangularDistance {
public:
    // Along a ray from the origin, up to `length`, which may be infinite.
    EquiangularDistance(const V3f& origin, const V3f& direction, float length, const V3f& pivot);

    [[nodiscard]] float sample(float u) const;
    [[nodiscard]] float pdf(float distance) const;

private:
    float nearest_;  // the distance at which the pivot is nearest
    float height_;   // the pivot's from the ray
    float first_rad_;
    float last_rad_;
    float length_;
};

}  // namespace eye_render
