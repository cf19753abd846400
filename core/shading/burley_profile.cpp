#include "shading/burley_profile.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

// The share of light that leaves within burley_cutoff.
constexpr float share_within_cutoff = 0.9963790093708328f;

}  // namespace

float burley_pdf(float scale, float distance)
{
    if (!(distance < burley_cutoff * scale)) {
        return 0.0f;
    }
    const float slow = std::exp(-distance / (3.0f * scale));
    return (slow * slow * slow + slow) / (4.0f * scale * share_within_cutoff);
}

float sample_burley_distance(float scale, float u)
{
    // What leaves farther away is (x^3 + 3 x) / 4 with x = exp(-r / 3 d), which Cardano's formula
    // inverts (Golubev 2019, "Sampling Burley's Normalized Diffusion Profiles").
    const float farther = 1.0f - u * share_within_cutoff;
    const float x = 2.0f * std::sinh(std::asinh(2.0f * farther) / 3.0f);
    return -3.0f * scale * std::log(std::min(x, 1.0f));
}

}  // namespace eye_render
