// Sum over the orders of interference, each integrated over the spectrum in closed form.

#include "shading/thin_film.h"

#include "shading/fresnel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr float pi_f = std::numbers::pi_v<float>;

// A boundary for light polarised one way: the share reflected, and the phase that it turns by.
struct Polarized {
    float reflectance;
    float phase_rad;

    explicit Polarized(float amplitude)
        : reflectance(amplitude * amplitude), phase_rad(amplitude < 0.0f ? pi_f : 0.0f)
    {
    }
};

struct PolarizedBoundary {
    Polarized across;
    Polarized parallel;
    float cos_transmitted;

    // Not for total reflection.
    PolarizedBoundary(float cos_i, float cos_t, float ior)
        : across((cos_i - ior * cos_t) / (cos_i + ior * cos_t)),
          parallel((ior * cos_i - cos_t) / (ior * cos_i + cos_t)), cos_transmitted(cos_t)
    {
    }
};

// The eye's matching functions in XYZ for a spectrum that ripples with this path difference, over
// what they are for an even one: the paper's fit by Gaussians over wave number, whose Fourier
// transforms are Gaussians again.
[[nodiscard]] V3f ripple_response(float path_nm, float shift_rad)
{
    struct Gaussian {
        float height, center, variance;  // centre in 1/m, variance in 1/m^2
    };
    constexpr auto lobes = std::to_array<Gaussian>({{5.4856e-13f, 1.6810e6f, 4.3278e9f},
                                                    {4.4201e-13f, 1.7953e6f, 9.3046e9f},
                                                    {5.2481e-13f, 2.2084e6f, 6.6121e9f}});
    constexpr Gaussian second_red = {9.7470e-14f, 2.2399e6f, 4.5282e9f};
    constexpr float even = 1.0685e-7f;  // of all of Y

    const float phase = 2.0f * pi_f * path_nm * 1e-9f;
    const auto response = [&](const Gaussian& g) {
        return g.height * std::sqrt(2.0f * pi_f * g.variance) *
               std::cos(g.center * phase + shift_rad) * std::exp(-g.variance * phase * phase) /
               even;
    };
    return {response(lobes[0]) + response(second_red), response(lobes[1]), response(lobes[2])};
}

// Eq. 10 of the paper: Airy's sum, cut off after the third order.
[[nodiscard]] V3f airy_sum(const Polarized& top, const Polarized& bottom, float path_nm)
{
    const float transmitted = 1.0f - top.reflectance;
    const float round_trip = top.reflectance * bottom.reflectance;
    const float inner = transmitted * transmitted * bottom.reflectance / (1.0f - round_trip);
    const float shift_rad = pi_f - top.phase_rad + bottom.phase_rad;

    V3f sum(top.reflectance + inner);
    float amplitude = 2.0f * (inner - transmitted);
    for (int order = 1; order <= 3; ++order) {
        amplitude *= std::sqrt(round_trip);
        const auto m = static_cast<float>(order);
        sum += ripple_response(m * path_nm, m * shift_rad) * amplitude;
    }
    return sum;
}

// An even spectrum is white: XYZ are scaled by the white point's first.
[[nodiscard]] Color3f rgb_from_even_xyz(const V3f& even, WorkingSpace space)
{
    const V3f white = xyz_from_rgb(Color3f(1.0f), space);
    const Color3f rgb = rgb_from_xyz(even * white, space);
    return {std::clamp(rgb.x, 0.0f, 1.0f), std::clamp(rgb.y, 0.0f, 1.0f),
            std::clamp(rgb.z, 0.0f, 1.0f)};
}

// Films thinner than this are faded out, as waves no longer tell them from none.
constexpr float thin_nm = 30.0f;

[[nodiscard]] float faded_ior(float film_ior, float thickness_nm)
{
    const float t = std::clamp(thickness_nm / thin_nm, 0.0f, 1.0f);
    return 1.0f + (film_ior - 1.0f) * t * t * (3.0f - 2.0f * t);
}

}  // namespace

Color3f film_reflectance(float cos_incident,
                         float film_thickness_nm,
                         float film_ior,
                         float base_ior,
                         WorkingSpace space)
{
    const float ior = faded_ior(film_ior, film_thickness_nm);
    const DielectricFresnel into_film = fresnel_dielectric(cos_incident, ior);
    const float cos_film = into_film.cos_transmitted;
    const DielectricFresnel into_base =
        cos_film > 0.0f ? fresnel_dielectric(cos_film, base_ior / ior) : DielectricFresnel{};
    if (!(into_base.cos_transmitted > 0.0f)) {
        return Color3f(1.0f);
    }
    const PolarizedBoundary top(cos_incident, cos_film, ior);
    const PolarizedBoundary bottom(cos_film, into_base.cos_transmitted, base_ior / ior);
    const float path_nm = 2.0f * ior * film_thickness_nm * cos_film;
    return rgb_from_even_xyz((airy_sum(top.across, bottom.across, path_nm) +
                              airy_sum(top.parallel, bottom.parallel, path_nm)) *
                                 0.5f,
                             space);
}

Color3f tinted_film_reflectance(float cos_incident,
                                float film_thickness_nm,
                                float film_ior,
                                float base_ior,
                                const Color3f& f0,
                                WorkingSpace space)
{
    Color3f reflectance =
        film_reflectance(cos_incident, film_thickness_nm, film_ior, base_ior, space);
    const float untinted = f0_from_ior(base_ior);
    constexpr float least_f0 = 1e-5f;  // there is nothing to scale below it
    if (untinted <= least_f0 || reflectance == Color3f(1.0f)) {
        return reflectance;
    }
    // The film may reflect less than the boundary alone, so the tint scales: fully where as much
    // is reflected as at normal incidence, and not at all where all is. As in Cycles.
    for (int c = 0; c < 3; ++c) {
        const float share = std::clamp((1.0f - reflectance[c]) / (1.0f - untinted), 0.0f, 1.0f);
        reflectance[c] *= 1.0f + (f0[c] / untinted - 1.0f) * share;
    }
    return reflectance;
}

}  // namespace eye_render
