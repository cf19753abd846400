// Evaluation and sampling of wide lobes.

#include "shading/diffuse_lobe.h"

#include "base/warp.h"
#include "shading/frame.h"
#include "shading/input_range.h"
#include "shading/sheen.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr float pi_f = std::numbers::pi_v<float>;
constexpr float inv_pi = std::numbers::inv_pi_v<float>;
constexpr float half_pi = 0.5f * pi_f;

// Fujii's G: the albedo of the slope's term over cos.
[[nodiscard]] float oren_nayar_slope_albedo(float cosine)
{
    // Below it the tangent grows out of a float's hands, and the series' first two terms do.
    constexpr float grazing = 1e-6f;
    if (cosine < grazing) {
        return half_pi - 2.0f / 3.0f - cosine;
    }
    const float c = std::min(cosine, 1.0f);
    const float sine = std::sqrt(1.0f - c * c);
    return sine * (std::acos(c) - 2.0f / 3.0f - sine * c) +
           2.0f / 3.0f * (sine / c) * (1.0f - sine * sine * sine);
}

// G at grazing light: the constant 1 / a of the model is pi plus roughness times this.
constexpr float grazing_slope_albedo = half_pi - 2.0f / 3.0f;

// The share of light that does not leave after one meeting, 1 - a pi - b G, over b: written so, it
// does not drown in roundings where the roughness, and b with it, goes to zero.
[[nodiscard]] float oren_nayar_loss_over_b(float cosine)
{
    return grazing_slope_albedo - oren_nayar_slope_albedo(std::max(cosine, 0.0f));
}

// The same, cosine-weighted over all directions.
constexpr float oren_nayar_mean_loss_over_b = grazing_slope_albedo - (2.0f * pi_f - 5.6f) / 3.0f;

[[nodiscard]] BsdfValue evaluate_oren_nayar(const Lobe& lobe,
                                            const V3f& wo,
                                            const V3f& wi,
                                            float cos_i)
{
    const float cos_o = std::max(lobe.normal.dot(wo), 0.0f);
    float t = wi.dot(wo) - cos_i * cos_o;
    if (t > 0.0f) {
        t /= std::max(cos_i, cos_o);
    }
    const float once = lobe.a + lobe.b * t;
    const float lost = lobe.b * oren_nayar_loss_over_b(cos_i);
    return {(lobe.weight * once + lobe.second_weight * lost) * cos_i,
            cosine_hemisphere_pdf(cos_i)};
}

// The frame of SheenTransform.
[[nodiscard]] Frame sheen_frame(const Lobe& lobe, const V3f& wo)
{
    const V3f side = wo - lobe.normal * lobe.normal.dot(wo);
    const float length = side.length();
    // Seen from straight above the lobe is the same all around.
    constexpr float above = 1e-6f;
    return length > above ? Frame(lobe.normal, side / length) : Frame(lobe.normal);
}

[[nodiscard]] BsdfValue evaluate_sheen(const Lobe& lobe, const V3f& wo, const V3f& wi)
{
    const V3f w = sheen_frame(lobe, wo).local_from_world(wi);
    const V3f inverse(lobe.a * w.x + lobe.b * w.z, lobe.a * w.y, w.z);
    const float ratio = lobe.a / inverse.length2();
    const float pdf = inv_pi * w.z * ratio * ratio;
    return {lobe.weight * pdf, pdf};
}

// 1 - cos of the angle at which nothing is left of a toon's cone.
[[nodiscard]] float toon_extent(const Lobe& lobe)
{
    const float half_sine = std::sin(0.5f * std::min(lobe.a + lobe.b, half_pi));
    return 2.0f * half_sine * half_sine;
}

// By the chord, because a float's cosine tells no angles below 3e-4 apart. Both unit.
[[nodiscard]] BsdfValue evaluate_toon(const Lobe& lobe, const V3f& axis, const V3f& wi)
{
    const float angle = 2.0f * std::asin(std::min(0.5f * (wi - axis).length(), 1.0f));
    if (angle >= std::min(lobe.a + lobe.b, half_pi)) {
        return {};
    }
    const float pdf = uniform_cone_pdf(toon_extent(lobe));
    return {lobe.weight * (angle < lobe.a ? pdf : pdf * (1.0f - (angle - lobe.a) / lobe.b)), pdf};
}

// Softens the edge between light and shadow where a normal map turns the normal far from the
// smooth one: Chiang et al. 2019, "Taming the Shadow Terminator".
[[nodiscard]] float terminator_softening(const Lobe& lobe, const V3f& wi, float cos_i)
{
    const float cos_smooth = lobe.smooth_normal.dot(wi);
    const float g = cos_smooth / (cos_i * lobe.smooth_normal.dot(lobe.normal));
    if (g >= 1.0f) {
        return 1.0f;
    }
    return g > 0.0f ? g * (1.0f + g * (1.0f - g)) : 0.0f;
}

[[nodiscard]] BsdfValue evaluate_on_smooth(const Lobe& lobe,
                                           const V3f& wo,
                                           const V3f& wi,
                                           float cos_i)
{
    switch (lobe.kind) {
    case LobeKind::OrenNayar: return evaluate_oren_nayar(lobe, wo, wi, cos_i);
    case LobeKind::Sheen: return evaluate_sheen(lobe, wo, wi);
    case LobeKind::DiffuseToon: return evaluate_toon(lobe, lobe.normal, wi);
    default: {
        const float pdf = cosine_hemisphere_pdf(cos_i);
        return {lobe.weight * pdf, pdf};
    }
    }
}

}  // namespace

LobeAndAlbedo oren_nayar_lobe(const Color3f& weight,
                              const Color3f& color,
                              float roughness,
                              const V3f& normal,
                              const V3f& smooth_normal,
                              const V3f& wo)
{
    Lobe lobe = plain_lobe(LobeKind::OrenNayar, weight, normal);
    lobe.smooth_normal = smooth_normal;
    lobe.a = 1.0f / (pi_f + roughness * grazing_slope_albedo);
    lobe.b = roughness * lobe.a;

    const Color3f tint = unit_range(color);
    const float loss_over_b = oren_nayar_loss_over_b(normal.dot(wo));
    const float mean_lost = lobe.b * oren_nayar_mean_loss_over_b;
    // What is lost on the way to wo over the mean of what is lost: b is in neither.
    const float relative_loss = loss_over_b / oren_nayar_mean_loss_over_b;
    const Color3f again =
        tint * tint * ((1.0f - mean_lost) * relative_loss) / (Color3f(1.0f) - tint * mean_lost);
    lobe.second_weight = weight * again * inv_pi;
    return {lobe, weight * (Color3f(1.0f - lobe.b * loss_over_b) + again * mean_lost)};
}

float add_sheen(Bsdf& bsdf,
                const Color3f& weight,
                float roughness,
                const V3f& normal,
                const V3f& smooth_normal,
                const V3f& wo)
{
    constexpr float smallest_roughness = 1e-3f;
    const SheenTransform transform =
        sheen_transform(std::max(roughness, smallest_roughness), normal.dot(wo));
    // Where the table has no lobe.
    constexpr float nothing = 1e-5f;
    if (transform.a < nothing || transform.albedo < nothing) {
        return 0.0f;
    }
    Lobe lobe = plain_lobe(LobeKind::Sheen, weight * transform.albedo, normal);
    lobe.smooth_normal = smooth_normal;
    lobe.a = transform.a;
    lobe.b = transform.b;
    bsdf.add(lobe, lobe.weight);
    return transform.albedo;
}

Lobe translucent_lobe(const Color3f& weight, const V3f& normal, const V3f& smooth_normal)
{
    Lobe lobe = plain_lobe(LobeKind::Translucent, weight, -normal);
    lobe.smooth_normal = -smooth_normal;
    return lobe;
}

Lobe toon_lobe(LobeKind kind,
               const Color3f& weight,
               float size,
               float smooth,
               const V3f& normal,
               const V3f& smooth_normal)
{
    constexpr float smallest_size = 1e-5f;
    Lobe lobe = plain_lobe(kind, weight, normal);
    lobe.smooth_normal = smooth_normal;
    lobe.a = in_range(size, smallest_size, 1.0f) * half_pi;
    lobe.b = unit_range(smooth) * half_pi;
    return lobe;
}

BsdfValue evaluate_diffuse(const Lobe& lobe, const V3f& wo, const V3f& wi)
{
    const float cos_i = lobe.normal.dot(wi);
    if (!(cos_i > 0.0f)) {
        return {};
    }
    BsdfValue value = evaluate_on_smooth(lobe, wo, wi, cos_i);
    if (lobe.normal != lobe.smooth_normal) {
        value.value *= terminator_softening(lobe, wi, cos_i);
    }
    return value;
}

V3f sample_diffuse(const Lobe& lobe, const V3f& wo, const V2f& u)
{
    switch (lobe.kind) {
    case LobeKind::Sheen: {
        const V3f w = sample_cosine_hemisphere(u);
        return sheen_frame(lobe, wo).world_from_local(
            V3f(w.x - w.z * lobe.b, w.y, w.z * lobe.a).normalized());
    }
    case LobeKind::DiffuseToon:
        return Frame(lobe.normal).world_from_local(sample_uniform_cone(u, toon_extent(lobe)));
    default: return Frame(lobe.normal).world_from_local(sample_cosine_hemisphere(u));
    }
}

BsdfValue evaluate_glossy_toon(const Lobe& lobe, const V3f& wo, const V3f& wi)
{
    const float cos_o = lobe.normal.dot(wo);
    if (!(cos_o > 0.0f && lobe.normal.dot(wi) > 0.0f)) {
        return {};
    }
    return evaluate_toon(lobe, lobe.normal * (2.0f * cos_o) - wo, wi);
}

V3f sample_glossy_toon(const Lobe& lobe, const V3f& wo, const V2f& u)
{
    const V3f mirrored = lobe.normal * (2.0f * lobe.normal.dot(wo)) - wo;
    return Frame(mirrored).world_from_local(sample_uniform_cone(u, toon_extent(lobe)));
}

}  // namespace eye_render
