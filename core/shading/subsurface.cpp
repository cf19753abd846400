#include "shading/subsurface.h"

#include "base/warp.h"
#include "shading/frame.h"
#include "shading/input_range.h"
#include "shading/microfacet.h"
#include "shading/node.h"
#include "shading/visible_normal.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eye_render {

namespace {

// As Cycles has them: what goes less far than a quarter of a pixel is not to be seen, and lengths
// below the least are not to be told from none.
constexpr float seen_share_of_pixel = 0.25f;
constexpr float least_radius = 1e-8f;

constexpr float largest_legacy_anisotropy = 0.9f;
constexpr float largest_anisotropy = 0.99f;
constexpr float smallest_subsurface_ior = 1.01f;
constexpr float largest_subsurface_ior = 3.8f;

// A walk in a medium that takes nothing would be left to chance.
constexpr float largest_walk_albedo = 0.999999f;

using Polynomial = std::array<float, 8>;

[[nodiscard]] float value_of(const Polynomial& coefficients, float x)
{
    float sum = 0.0f;
    for (std::size_t i = coefficients.size(); i-- > 0;) {
        sum = sum * x + coefficients[i];
    }
    return sum;
}

// Wrenninge et al. 2017: the fit's parameters by the anisotropy. B and E have theirs in an
// exponent.
constexpr Polynomial fit_a{1.8260523782f,   -1.28451056436f, -1.79904629312f, 9.19393289202f,
                           -22.8215585862f, 32.0234874259f,  -23.6264803333f, 7.21067002658f};
constexpr Polynomial fit_b{
    0.0f,           31.1491581433f,  -201.847017512f, 841.576016723f, -2018.09288505f,
    2731.71560286f, -1935.41424244f, 559.009054474f};
constexpr Polynomial fit_c{1.09686102424f, -0.394704063468f, 1.05258115941f, -8.83963712726f,
                           28.8643230661f, -46.8802913581f,  38.5402837518f, -12.7181042538f};
constexpr Polynomial fit_d{0.496310210422f, 0.360146581622f, -2.15139309747f, 17.8896899217f,
                           -55.2984010333f, 82.065982243f,   -58.5106008578f, 15.8478295021f};
constexpr Polynomial fit_e{
    0.0f,           76.7316253952f,  -594.356773233f, 2448.8834203f, -5576.68528998f,
    7116.60171912f, -4763.54467887f, 1303.5318055f};
constexpr Polynomial fit_f{2.40602999408f, -2.51814844609f, 9.18494908356f, -79.2191708682f,
                           259.082868209f, -403.613804597f, 302.85712436f,  -87.4370473567f};

// Jensen et al. 2001, "A Practical Model for Subsurface Light Transport", eq. 15: the diffuse
// reflectance of a half space, by the reduced albedo.
[[nodiscard]] float dipole_reflectance(float albedo, float boundary)
{
    const float s = std::sqrt(3.0f * (1.0f - albedo));
    return 0.5f * albedo * (1.0f + std::exp(-boundary * s)) * std::exp(-s);
}

[[nodiscard]] float dipole_albedo(float color, float boundary)
{
    // The limits and the steps are Cycles', which make it a table of 2^12 albedos.
    constexpr float black = 1e-4f;
    constexpr float white = 0.995f;
    constexpr int bisections = 12;
    if (color < black) {
        return 0.0f;
    }
    if (color >= white) {
        return largest_walk_albedo;
    }
    float low = 0.0f;
    float high = 1.0f;
    float middle = 0.0f;
    for (int i = 0; i < bisections; ++i) {
        middle = 0.5f * (low + high);
        (dipole_reflectance(middle, boundary) < color ? low : high) = middle;
    }
    return middle;
}

// Of skin the radius is the distance over which light dies away, by the dipole.
[[nodiscard]] float skin_mean_free_path(float radius, float color, float ior)
{
    // Egan & Hilgeman's mean reflectance of the boundary, from within.
    const float mean_reflectance = (-1.440f / ior + 0.710f) / ior + 0.668f + 0.0636f * ior;
    const float boundary = 4.0f / 3.0f * (1.0f + mean_reflectance) / (1.0f - mean_reflectance);
    return radius * std::sqrt(3.0f * (1.0f - dipole_albedo(color, boundary)));
}

[[nodiscard]] float legacy_mean_free_path(const Lobe& lobe, float radius, float color)
{
    return lobe.kind == LobeKind::RandomWalkSkin ? skin_mean_free_path(radius, color, lobe.ior)
                                                 : radius * mean_free_path_of_radius;
}

}  // namespace

void add_subsurface(Bsdf& bsdf,
                    const SubsurfaceInputs& inputs,
                    const Color3f& weight,
                    const V3f& normal,
                    const ShadingPoint& point,
                    bool after_diffuse)
{
    const Color3f radius = positive_range(inputs.radius);
    const float least = inputs.always_walks
                            ? least_radius
                            : std::max(seen_share_of_pixel * point.footprint, least_radius);
    const bool stays =
        after_diffuse && (!inputs.always_walks || inputs.method == LobeKind::Burley);
    Color3f below = weight;
    for (int c = 0; c < 3; ++c) {
        if (stays || radius[c] < least) {
            below[c] = 0.0f;
        }
    }
    if (max_component(below) > 0.0f) {
        Lobe lobe = plain_lobe(
            inputs.method, below, visible_normal(normal, point.wo, point.ng),
            inputs.method == LobeKind::RandomWalkSkin ? 1.0f : unit_range(inputs.alpha));
        lobe.smooth_normal = point.ns;
        lobe.ior = in_range(inputs.ior, smallest_subsurface_ior, largest_subsurface_ior);
        lobe.f0 = unit_range(inputs.color);
        lobe.edge = radius;
        lobe.a = inputs.method == LobeKind::RandomWalk
                     ? in_range(inputs.anisotropy, -largest_anisotropy, largest_anisotropy)
                     : in_range(inputs.anisotropy, 0.0f, largest_legacy_anisotropy);
        bsdf.add(lobe, below);
    }
    if (below != weight) {
        const Color3f left = weight - below;
        bsdf.add(diffuse_lobe(left, normal, point.ns), left);
    }
}

float single_scattering_albedo(float color, float anisotropy)
{
    const float s =
        4.09712f + 4.20863f * color - std::sqrt(9.59217f + color * (41.6808f + 17.7126f * color));
    const float s2 = s * s;
    return in_range((1.0f - s2) / (1.0f - anisotropy * s2), 0.0f, largest_walk_albedo);
}

float legacy_single_scattering_albedo(float color, float anisotropy)
{
    const float g = anisotropy;
    const float a = value_of(fit_a, g);
    const float b = 4.98511194385f + 0.127355959438f * std::exp(value_of(fit_b, g));
    const float c = value_of(fit_c, g);
    const float d = value_of(fit_d, g);
    const float e = 4.23190299701f + 0.00310603949088f * std::exp(value_of(fit_e, g));
    const float f = value_of(fit_f, g);
    const float blend = std::sqrt(std::sqrt(color));
    const float albedo = (1.0f - blend) * a * std::pow(std::atan(b * color), c) +
                         blend * d * std::pow(std::atan(e * color), f);
    return in_range(albedo, 0.0f, largest_walk_albedo);
}

SubsurfaceMedium subsurface_medium(const Lobe& lobe)
{
    SubsurfaceMedium medium{.anisotropy = lobe.a};
    for (int c = 0; c < 3; ++c) {
        const float color = lobe.f0[c];
        // Lobes without a channel may have any radius there.
        const float radius = std::max(lobe.edge[c], least_radius);
        float albedo = 0.0f;
        if (lobe.kind == LobeKind::RandomWalk) {
            albedo = single_scattering_albedo(color, lobe.a);
            medium.extinction[c] = 1.0f / radius;
        } else {
            albedo = legacy_single_scattering_albedo(color, lobe.a);
            medium.extinction[c] =
                1.0f / (legacy_mean_free_path(lobe, radius, color) * (1.0f - lobe.a));
        }
        medium.albedo[c] = std::max(albedo, least_walk_albedo);
        medium.entering[c] =
            color > 0.0f ? std::min(albedo / least_walk_albedo, 1.0f) / color : 0.0f;
    }
    return medium;
}

SubsurfaceMedium even_medium(const SubsurfaceMedium& medium)
{
    SubsurfaceMedium even = medium;
    even.anisotropy = 0.0f;
    for (int c = 0; c < 3; ++c) {
        const float scattering =
            medium.extinction[c] * medium.albedo[c] * (1.0f - medium.anisotropy);
        even.extinction[c] = medium.extinction[c] * (1.0f - medium.albedo[c]) + scattering;
        even.albedo[c] = scattering / even.extinction[c];
    }
    return even;
}

V3f sample_entry(const Lobe& lobe, const V3f& wo, float u_choice, const V2f& u)
{
    const Frame frame(lobe.normal);
    constexpr float lambert_share = 0.5f;
    if (lobe.kind == LobeKind::RandomWalkSkin && u_choice < lambert_share) {
        return -frame.world_from_local(sample_cosine_hemisphere(u));
    }
    const V3f facet =
        frame.world_from_local(sample_visible_normal(frame.local_from_world(wo), lobe.alpha_x, u));
    const float cos_o = facet.dot(wo);
    const float inverse_ior = 1.0f / lobe.ior;
    const float cos_i =
        std::sqrt(1.0f - inverse_ior * inverse_ior * std::max(0.0f, 1.0f - cos_o * cos_o));
    return (facet * (inverse_ior * cos_o - cos_i) - wo * inverse_ior).normalized();
}

}  // namespace eye_render
