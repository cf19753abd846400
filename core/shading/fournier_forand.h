// How particles in water scatter: Fournier and Forand's phase function of a cloud of spheres whose
// sizes follow a power law, as Fournier & Jonasz 1999, "Computer-Based Underwater Imaging
// Analysis", write it by the particles' index of refraction and the share of light they scatter
// backwards.

#pragma once

namespace eye_render {

struct FournierForand {
    double delta_behind = 0.0;  // its delta, which is as sin^2(theta / 2), straight behind
    double exponent = 0.0;      // its v, negative
    double rebound = 0.0;       // factor of the part that makes up for the smallest particles

    bool operator==(const FournierForand&) const = default;
};

// `ior` over the water's, `backscatter` the share of light that turns by more than 90 degrees:
// both are brought into the range where the model is one.
[[nodiscard]] FournierForand fournier_forand(float ior, float backscatter);

// Per unit solid angle. Infinite straight ahead, where the angle counts as a millionth of a
// radian.
[[nodiscard]] float fournier_forand_pdf(const FournierForand& particles, float one_minus_cos);

// sin^2(theta / 2) that a share `u` in [0, 1) of the light stays below.
[[nodiscard]] double sample_fournier_forand(const FournierForand& particles, double u);

}  // namespace eye_render
