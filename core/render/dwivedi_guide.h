// Directions and flights that lead light out of a half space: Dwivedi's zero-variance scheme in
// the form of Meng, Hanika & Dachsbacher 2016, "Improving the Dwivedi Sampling Scheme", eq. 9 and
// 10, with the diffusion length of d'Eon & Krivanek 2020, "Zero-Variance Theory for Efficient
// Subsurface Scattering", eq. 67. Cosines are against the way out.

#pragma once

#include "shading/frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

class DwivediGuide {
public:
    // By the albedo of a single scattering, in [0.2, 1).
    explicit DwivediGuide(float albedo)
        : diffusion_length_(1.0f / std::sqrt(1.0f - std::pow(albedo,
                                                             2.44294f - 0.0215813f * albedo +
                                                                 0.578637f / albedo))),
          log_ratio_(std::log((diffusion_length_ + 1.0f) / (diffusion_length_ - 1.0f)))
    {
    }

    // In mean free paths.
    [[nodiscard]] float diffusion_length() const { return diffusion_length_; }

    // Both of u in [0, 1).
    [[nodiscard]] V3f sample(const V3f& outwards, const V2f& u) const
    {
        const float cosine = std::clamp(diffusion_length_ - (diffusion_length_ + 1.0f) *
                                                                std::exp(-u.x * log_ratio_),
                                        -1.0f, 1.0f);
        const float sine = std::sqrt(1.0f - cosine * cosine);
        const float azimuth = 2.0f * std::numbers::pi_v<float> * u.y;
        return Frame(outwards).world_from_local(
            {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine});
    }
    // Per unit solid angle.
    [[nodiscard]] float pdf(float cosine) const
    {
        return 0.5f * std::numbers::inv_pi_v<float> / ((diffusion_length_ - cosine) * log_ratio_);
    }
    // By which the extinction is drawn from: light flies farther on its way out.
    [[nodiscard]] float extinction_factor(float cosine) const
    {
        return 1.0f - cosine / diffusion_length_;
    }

private:
    float diffusion_length_;
    float log_ratio_;
};

}  // namespace eye_render
