// Evaluation and sampling of velvet and of Ashikhmin & Shirley's lobe.

#include "shading/glossy_lobe.h"

#include "base/warp.h"
#include "shading/frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr float pi_f = std::numbers::pi_v<float>;
constexpr float inv_pi = std::numbers::inv_pi_v<float>;

[[nodiscard]] float square(float x) { return x * x; }

// Exponents of the Phong-like lobe along the tangent and across it.
struct Exponents {
    float x, y;

    explicit Exponents(const Lobe& lobe)
        : x(2.0f / square(lobe.alpha_x) - 2.0f), y(2.0f / square(lobe.alpha_y) - 2.0f)
    {
    }

    // For half vectors of this azimuth.
    [[nodiscard]] float at(float cos_phi, float sin_phi) const
    {
        return x * square(cos_phi) + y * square(sin_phi);
    }
};

[[nodiscard]] Frame lobe_frame(const Lobe& lobe)
{
    return lobe.alpha_x == lobe.alpha_y ? Frame(lobe.normal) : Frame(lobe.normal, lobe.tangent);
}

}  // namespace

Lobe velvet_lobe(const Color3f& weight, const V3f& normal, float sigma)
{
    constexpr float smallest_sigma = 0.01f;
    Lobe lobe = plain_lobe(LobeKind::Velvet, weight, normal);
    lobe.a = 1.0f / square(std::max(sigma, smallest_sigma));
    return lobe;
}

BsdfValue evaluate_velvet(const Lobe& lobe, const V3f& wo, const V3f& wi)
{
    const float cos_o = lobe.normal.dot(wo);
    const float cos_i = lobe.normal.dot(wi);
    if (!(cos_o > 0.0f && cos_i > 0.0f)) {
        return {};
    }
    BsdfValue result{.pdf = 0.5f * inv_pi};
    const V3f h = (wo + wi).normalized();
    const float cos_h = lobe.normal.dot(h);
    const float cos_oh = wo.dot(h);
    const float sin2_h = 1.0f - cos_h * cos_h;
    // No fibre lies that flat: the density falls to zero long before.
    constexpr float flat = 1e-5f;
    if (sin2_h < flat || cos_oh < flat) {
        return result;
    }
    const float density =
        std::exp(-lobe.a * cos_h * cos_h / sin2_h) * lobe.a * inv_pi / square(sin2_h);
    const float grooves = 2.0f * cos_h / cos_oh * std::min(cos_o, cos_i);
    result.value = lobe.weight * (0.25f * density * std::min(1.0f, grooves) / cos_o);
    return result;
}

V3f sample_velvet(const Lobe& lobe, const V2f& u)
{
    return Frame(lobe.normal).world_from_local(sample_uniform_cone(u, 1.0f));
}

BsdfValue evaluate_ashikhmin_shirley(const Lobe& lobe, const V3f& wo, const V3f& wi)
{
    const float cos_o = lobe.normal.dot(wo);
    const float cos_i = lobe.normal.dot(wi);
    if (!(cos_o > 0.0f && cos_i > 0.0f)) {
        return {};
    }
    const V3f h = lobe_frame(lobe).local_from_world((wo + wi).normalized());
    const Exponents exponents(lobe);
    const float sin2 = h.x * h.x + h.y * h.y;
    const float exponent =
        sin2 > 0.0f ? (exponents.x * h.x * h.x + exponents.y * h.y * h.y) / sin2 : exponents.x;
    const float density = std::sqrt((exponents.x + 1.0f) * (exponents.y + 1.0f)) * 0.125f *
                          inv_pi * std::pow(std::clamp(h.z, 0.0f, 1.0f), exponent);
    constexpr float grazing = 1e-6f;
    const float pdf = density / std::max(grazing, (wo + wi).length() * 0.5f);
    return {lobe.weight * (pdf * cos_i / std::max(cos_o, cos_i)), pdf};
}

std::optional<V3f> sample_ashikhmin_shirley(const Lobe& lobe, const V3f& wo, const V2f& u)
{
    // Eq. 9 and 10 of the paper, for the whole turn: the tangent stretches within each quadrant.
    const Exponents exponents(lobe);
    const float stretch = std::sqrt((exponents.x + 1.0f) / (exponents.y + 1.0f));
    const float turn = 2.0f * pi_f * u.x;
    const float phi = std::atan2(stretch * std::sin(turn), std::cos(turn));
    const float cos_phi = std::cos(phi);
    const float sin_phi = std::sin(phi);
    const float cos_h = std::pow(1.0f - u.y, 1.0f / (exponents.at(cos_phi, sin_phi) + 1.0f));
    const float sin_h = std::sqrt(std::max(0.0f, 1.0f - cos_h * cos_h));
    const V3f h = lobe_frame(lobe).world_from_local(V3f(sin_h * cos_phi, sin_h * sin_phi, cos_h));
    const float cos_oh = wo.dot(h);
    if (!(cos_oh > 0.0f)) {
        return std::nullopt;
    }
    return h * (2.0f * cos_oh) - wo;
}

}  // namespace eye_render
