// Evaluation and sampling of light on a fibre. Angles: theta is the elevation from the plane
// across the fibre, phi the azimuth around it from the viewer; gamma is between the normal of a
// surface point across the fibre and the ray.

#include "shading/fibre_lobe.h"

#include "shading/fibre_spread.h"
#include "shading/frame.h"
#include "shading/fresnel.h"
#include "shading/input_range.h"

#include <array>
#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr float pi_f = std::numbers::pi_v<float>;

// R, TT, TRT, and all that is reflected inside more than once.
constexpr std::size_t orders = 4;
constexpr std::size_t last_order = orders - 1;

// Along the fibre, to the viewer across it, and the third.
struct FibreFrame {
    V3f along;
    V3f front;
    V3f side;

    FibreFrame(const Lobe& lobe, const V3f& wo)
        : along(lobe.tangent), front(unit_or(wo - along * along.dot(wo), Frame(along).s)),
          side(along.cross(front))
    {
    }
};

// What is known of a fibre from one side.
struct View {
    std::array<Elevation, orders> theta_o;  // by the scales' tilt for each order
    std::array<float, orders> phi;  // where each goes, but for the last, which goes all around
    std::array<Color3f, orders> attenuation;

    View(const Lobe& lobe, const FibreFrame& frame, const V3f& wo)
    {
        const Elevation level = Elevation::of_sine(frame.along.dot(wo));
        theta_o = {level.turned(2.0f * lobe.b), level.turned(-lobe.b),
                   level.turned(-4.0f * lobe.b), level};

        const V2f across(lobe.normal.dot(frame.front), lobe.normal.dot(frame.side));
        const float length = across.length();
        const float sin_gamma_o =
            length > 0.0f ? std::clamp(-across.y / length, -1.0f, 1.0f) : 0.0f;
        const float cos_gamma_o = Elevation::of_sine(sin_gamma_o).cosine;
        // Refraction in the plane across the fibre has an index that grows with elevation.
        const float sin_gamma_t = std::clamp(
            sin_gamma_o * level.cosine / std::sqrt(lobe.ior * lobe.ior - level.sine * level.sine),
            -1.0f, 1.0f);
        for (std::size_t p = 0; p < orders; ++p) {
            const auto order = static_cast<float>(p);
            phi[p] = 2.0f * order * std::asin(sin_gamma_t) - 2.0f * std::asin(sin_gamma_o) +
                     order * pi_f;
        }

        // In radii.
        const float way = 2.0f * Elevation::of_sine(sin_gamma_t).cosine /
                          Elevation::of_sine(level.sine / lobe.ior).cosine;
        const Color3f passed(std::exp(-lobe.f0.x * way), std::exp(-lobe.f0.y * way),
                             std::exp(-lobe.f0.z * way));
        const float f = fresnel_dielectric(level.cosine * cos_gamma_o, lobe.ior).reflectance;
        attenuation[0] = Color3f(f);
        attenuation[1] = passed * ((1.0f - f) * (1.0f - f));
        attenuation[2] = attenuation[1] * passed * f;
        // The rest of the geometric series; all of the light is reflected where it grazes.
        attenuation[3] =
            f < 1.0f ? attenuation[2] * passed * f / (Color3f(1.0f) - passed * f) : Color3f(0.0f);
    }

    // Of each order, to be drawn.
    [[nodiscard]] std::array<float, orders> shares() const
    {
        std::array<float, orders> share;
        float sum = 0.0f;
        for (std::size_t p = 0; p < orders; ++p) {
            sum += share[p] = luminance(attenuation[p]);
        }
        for (float& s : share) {
            s /= sum;
        }
        return share;
    }
};

[[nodiscard]] float variance_of(const Lobe& lobe, std::size_t order)
{
    return order == 0 ? lobe.edge.x : order == 1 ? lobe.edge.y : lobe.edge.z;
}

// Artists' roughness to a variance: Chiang et al. 2016, eq. 7.
[[nodiscard]] float variance_from(float roughness)
{
    const float r = roughness;
    const float root = 0.726f * r + 0.812f * r * r + 3.7f * std::pow(r, 20.0f);
    return root * root;
}

// And to the logistic distribution's scale: eq. 8.
[[nodiscard]] float scale_from(float roughness)
{
    const float r = roughness;
    constexpr float root_of_pi_8th = 0.626657069f;
    return root_of_pi_8th * (0.265f * r + 1.194f * r * r + 5.372f * std::pow(r, 22.0f));
}

// Of what is neither reflected nor passed at once, relative to the variance of a single passage.
constexpr float passed_narrowing = 0.25f;
constexpr float inner_widening = 4.0f;

}  // namespace

Lobe fibre_lobe(float weight, const Fibre& fibre, const V3f& along, const V3f& ng)
{
    constexpr float smoothest = 1e-3f;
    const float roughness = in_range(fibre.roughness, smoothest, 1.0f);
    const float variance = variance_from(roughness);
    Lobe lobe = plain_lobe(LobeKind::Fibre, Color3f(weight), ng);
    lobe.tangent = unit_or(along, Frame(ng).s);
    lobe.f0 = positive_range(fibre.absorption);
    lobe.ior = in_range(fibre.ior, 1.0f + smoothest, largest_ior);
    lobe.edge = {
        variance_from(in_range(unit_range(fibre.gloss_roughness) * roughness, smoothest, 1.0f)),
        passed_narrowing * variance, inner_widening * variance};
    lobe.a = scale_from(in_range(fibre.radial_roughness, smoothest, 1.0f));
    lobe.b = fibre.tilt_rad;
    return lobe;
}

FibreAlbedo fibre_albedo(const Lobe& lobe, const V3f& wo)
{
    const View view(lobe, FibreFrame(lobe, wo), wo);
    return {.reflected = lobe.weight * view.attenuation[0],
            .transmitted =
                lobe.weight * (view.attenuation[1] + view.attenuation[2] + view.attenuation[3])};
}

BsdfValue evaluate_fibre(const Lobe& lobe, const V3f& wo, const V3f& wi)
{
    const FibreFrame frame(lobe, wo);
    const View view(lobe, frame, wo);
    const std::array<float, orders> shares = view.shares();
    const Elevation theta_i = Elevation::of_sine(frame.along.dot(wi));
    const float phi = std::atan2(frame.side.dot(wi), frame.front.dot(wi));
    BsdfValue sum;
    for (std::size_t p = 0; p < orders; ++p) {
        const float around = p < last_order ? around_density(phi - view.phi[p], lobe.a)
                                            : 0.5f * std::numbers::inv_pi_v<float>;
        const float density =
            around * along_density(theta_i, view.theta_o[p], variance_of(lobe, p));
        sum.value += lobe.weight * view.attenuation[p] * density;
        sum.pdf += shares[p] * density;
    }
    return sum;
}

V3f sample_fibre(const Lobe& lobe, const V3f& wo, float u_choice, const V2f& u)
{
    const FibreFrame frame(lobe, wo);
    const View view(lobe, frame, wo);
    const std::array<float, orders> shares = view.shares();
    std::size_t p = 0;
    float rest = u_choice;
    while (p < last_order && rest >= shares[p]) {
        rest -= shares[p++];
    }

    // The last may have no share, and be drawn by rounding.
    const float u_along = shares[p] > 0.0f ? std::min(rest / shares[p], 1.0f) : 0.5f;
    const Elevation i = sample_along(u_along, u.y, view.theta_o[p], variance_of(lobe, p));
    const float phi =
        p < last_order ? view.phi[p] + sample_around(u.x, lobe.a) : 2.0f * pi_f * u.x;
    return frame.along * i.sine +
           (frame.front * std::cos(phi) + frame.side * std::sin(phi)) * i.cosine;
}

void blur_fibre(Lobe& lobe, float least)
{
    const float variance = std::max(lobe.edge.z / inner_widening, least);
    lobe.edge = {std::max(lobe.edge.x, least), passed_narrowing * variance,
                 inner_widening * variance};
    lobe.a = std::max(lobe.a, least);
}

}  // namespace eye_render
