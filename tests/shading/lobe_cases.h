// Lobes of every kind, alone and in a mixture, and random numbers to sample them with.

#pragma once

#include "scattering.h"
#include "shading/diffuse_lobe.h"
#include "shading/fibre_lobe.h"
#include "shading/frame.h"
#include "shading/glossy_lobe.h"

#include <optional>
#include <random>
#include <string>
#include <vector>

namespace eye_render::test {

inline const V3f tilted = direction_at(25.0, 70.0);

struct Case {
    std::string name;
    std::vector<Lobe> lobes;
};

[[nodiscard]] inline Lobe brushed(Lobe lobe)
{
    lobe.alpha_x *= 0.6f;
    lobe.alpha_y /= 0.6f;
    lobe.tangent = Frame(lobe.normal).world_from_local(V3f(0.8f, 0.6f, 0.0f));
    return lobe;
}

[[nodiscard]] inline Lobe beckmann(Lobe lobe)
{
    lobe.facets = FacetModel::Beckmann;
    return lobe;
}

// A sheen's transform as the table has it at a roughness of one half, seen at 45 degrees.
[[nodiscard]] inline Lobe sheen(const Color3f& weight, const V3f& normal)
{
    Lobe lobe = plain_lobe(LobeKind::Sheen, weight, normal);
    lobe.smooth_normal = up;
    lobe.a = 0.44f;
    lobe.b = -0.06f;
    return lobe;
}

// What depends on the viewer is made for one at 50 degrees, which any viewer may see.
[[nodiscard]] inline std::vector<Case> wide_cases()
{
    const Color3f orange(0.9f, 0.5f, 0.2f);
    const auto oren_nayar = [&](const V3f& normal) {
        return oren_nayar_lobe(orange, orange, 0.7f, normal, up, direction_at(50.0)).lobe;
    };
    return {
        {"Oren-Nayar", {oren_nayar(up)}},
        {"Oren-Nayar, mapped normal", {oren_nayar(tilted)}},
        {"translucent", {translucent_lobe(orange, up, up)}},
        {"translucent, mapped normal", {translucent_lobe(orange, tilted, up)}},
        {"sheen", {sheen(orange, up)}},
        {"sheen, mapped normal", {sheen(orange, tilted)}},
        {"diffuse toon", {toon_lobe(LobeKind::DiffuseToon, orange, 0.6f, 0.3f, up, up)}},
        {"velvet", {velvet_lobe(orange, up, 0.7f)}},
    };
}

// Rough enough for a grid of directions to resolve.
[[nodiscard]] inline std::vector<Case> lobe_cases()
{
    const Color3f orange(0.9f, 0.5f, 0.2f);
    const Lobe diffuse = diffuse_lobe(orange, up, up);
    const Lobe glossy = glossy_lobe(orange, up, 0.25f);
    const Lobe metal = metal_lobe(Color3f(1.1f), up, 0.5f, orange);
    const Lobe dielectric = dielectric_lobe(Color3f(1.0f), up, 0.2f, 1.5f);
    const Lobe glass_in = glass_lobe(Color3f(1.0f), orange, up, 0.3f, 1.45f);
    const Lobe glass_out = glass_lobe(orange, orange, up, 0.3f, 1.0f / 1.45f);
    const Lobe straight = straight_lobe(Color3f(0.3f));
    Lobe tinted = glass_in;
    tinted.kind = LobeKind::TintedGlass;
    tinted.f0 = orange * 0.05f;
    Lobe film = tinted;
    film.film_thickness_nm = 400.0f;
    film.film_ior = 1.3f;
    Lobe conductor = plain_lobe(LobeKind::Conductor, Color3f(1.0f), up, 0.3f);
    conductor.f0 = Color3f(0.2f, 0.9f, 1.4f);
    conductor.edge = Color3f(3.9f, 2.4f, 2.0f);
    const Lobe phong = plain_lobe(LobeKind::AshikhminShirley, orange, up, 0.4f);
    const Fibre brown{.absorption = {0.2f, 0.5f, 1.1f},
                      .roughness = 0.6f,
                      .radial_roughness = 0.7f,
                      .gloss_roughness = 0.8f,
                      .tilt_rad = 0.05f};
    const Lobe fibre = fibre_lobe(0.8f, brown, V3f(0.4f, 1.0f, 0.0f), up);
    std::vector<Case> cases = wide_cases();
    const std::vector<Case> facets{
        {"tinted glass", {tinted}},
        {"glass under a film", {film}},
        {"conductor", {conductor}},
        {"brushed metal", {brushed(metal)}},
        {"brushed metal, mapped normal", {brushed(metal_lobe(orange, tilted, 0.4f, orange))}},
        {"Beckmann's facets", {beckmann(glossy)}},
        {"Beckmann's facets, brushed", {beckmann(brushed(metal))}},
        {"Beckmann's glass", {beckmann(glass_in)}},
        {"refraction", {refraction_lobe(orange, up, 0.45f, 1.45f)}},
        {"refraction from inside", {refraction_lobe(orange, up, 0.3f, 1.0f / 1.45f)}},
        {"Ashikhmin & Shirley's", {phong}},
        {"Ashikhmin & Shirley's, brushed", {brushed(phong)}},
        {"fibre", {fibre}},
        {"fibre on diffuse", {fibre, diffuse}},
        {"diffuse", {diffuse}},
        {"glossy", {glossy}},
        {"metal", {metal}},
        {"dielectric", {dielectric}},
        {"glass from outside", {glass_in}},
        {"glass from inside", {glass_out}},
        {"diffuse, mapped normal", {diffuse_lobe(orange, tilted, up)}},
        {"glossy, mapped normal", {glossy_lobe(orange, tilted, 0.3f)}},
        {"glass, mapped normal", {glass_lobe(orange, orange, tilted, 0.4f, 1.45f)}},
        {"all", {straight, metal, glass_in, dielectric, diffuse, phong, brushed(glossy)}},
    };
    cases.insert(cases.end(), facets.begin(), facets.end());
    return cases;
}

[[nodiscard]] inline Bsdf mixture(const Case& c, const V3f& wo)
{
    Bsdf bsdf(wo, up);
    for (const Lobe& lobe : c.lobes) {
        bsdf.add(lobe, lobe.weight + lobe.second_weight);
    }
    return bsdf;
}

class Random {
public:
    explicit Random(unsigned seed) : generator_(seed) {}
    float next() { return uniform_(generator_); }
    std::optional<BsdfSample> sample(const Bsdf& bsdf)
    {
        const float u_lobe = next();
        const float x = next();
        return bsdf.sample(u_lobe, {x, next()});
    }

private:
    std::mt19937 generator_;
    std::uniform_real_distribution<float> uniform_{0.0f, 1.0f};
};

}  // namespace eye_render::test
