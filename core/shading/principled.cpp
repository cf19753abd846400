// The layers of the Principled BSDF from the top, as Cycles 4.3 stacks them: what one layer takes
// is gone for those below.

#include "shading/principled.h"

#include "shading/diffuse_lobe.h"
#include "shading/fresnel.h"
#include "shading/ggx_surface.h"
#include "shading/input_range.h"
#include "shading/node.h"
#include "shading/subsurface.h"
#include "shading/thin_film.h"
#include "shading/visible_normal.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

constexpr float largest_specular = 1e3f;

// What the specular level makes of the index: it scales the reflectance at normal incidence, and
// 0.5 leaves it. An index below 1 stays below.
[[nodiscard]] float adjusted_ior(float ior, float specular)
{
    if (specular == 0.5f) {
        return ior;
    }
    const float denser = ior_from_f0(f0_from_ior(ior) * 2.0f * specular);
    return ior < 1.0f ? 1.0f / denser : denser;
}

[[nodiscard]] Color3f sqrt_of(const Color3f& c)
{
    return {std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z)};
}

// What a layer that keeps `albedo` leaves for those below.
[[nodiscard]] float left_below(float albedo) { return unit_range(1.0f - albedo); }

// Adds the fibres; returns what they leave.
[[nodiscard]] float add_sheen_layer(Bsdf& bsdf,
                                    const PrincipledInputs& inputs,
                                    const Color3f& weight,
                                    const V3f& normal,
                                    const ShadingPoint& point)
{
    const Color3f sheen = positive_range(inputs.sheen_tint) * positive_range(inputs.sheen_weight);
    return left_below(max_component(sheen) * add_sheen(bsdf, sheen * weight,
                                                       unit_range(inputs.sheen_roughness), normal,
                                                       point.ns, point.wo));
}

// Adds the coat; returns what it leaves, after light passed its tint.
[[nodiscard]] Color3f add_coat_layer(Bsdf& bsdf,
                                     const PrincipledInputs& inputs,
                                     const Color3f& weight,
                                     const V3f& normal,
                                     const ShadingPoint& point)
{
    const float coat = positive_range(inputs.coat_weight);
    const float ior = in_range(inputs.coat_ior, 1.0f, largest_ior);
    const V3f mirror_normal = visible_normal(normal, point.wo, point.ng);
    const GgxSurface surface{.normal = mirror_normal,
                             .cos_o = mirror_normal.dot(point.wo),
                             .roughness = unit_range(inputs.coat_roughness),
                             .multiple_scattering = false};
    Color3f left(1.0f);
    if (inputs.shows_reflections) {
        left *= left_below(coat * add_coat(bsdf, surface, weight * coat, ior));
    }

    const Color3f tint = positive_range(inputs.coat_tint);
    if (tint != Color3f(1.0f)) {
        // Beer's law along the refracted view; the tint is that of a view from straight above.
        const float cos2 = surface.cos_o * surface.cos_o;
        const float depth = 1.0f / std::sqrt(1.0f - (1.0f - std::min(cos2, 1.0f)) / (ior * ior));
        for (int c = 0; c < 3; ++c) {
            left[c] *= 1.0f + (std::pow(tint[c], depth) - 1.0f) * coat;
        }
    }
    return left;
}

// Sheen and coat; returns what they leave of `weight`.
[[nodiscard]] Color3f add_top_layers(Bsdf& bsdf,
                                     const PrincipledInputs& inputs,
                                     Color3f weight,
                                     const V3f& normal,
                                     const ShadingPoint& point)
{
    const bool has_coat = inputs.coat_weight > 0.0f;
    const V3f coat_normal = has_coat ? unit_normal(inputs.coat_normal, point.ns) : normal;
    if (inputs.sheen_weight > 0.0f) {
        // Fibres stand on the coat as far as there is one.
        const V3f& fallback = normal;
        const V3f between = normal + (coat_normal - normal) * unit_range(inputs.coat_weight);
        weight *= add_sheen_layer(bsdf, inputs, weight, unit_normal(between, fallback), point);
    }
    if (has_coat) {
        weight *= add_coat_layer(bsdf, inputs, weight, coat_normal, point);
    }
    return weight;
}

[[nodiscard]] GgxSurface base_surface(const PrincipledInputs& inputs,
                                      const V3f& normal,
                                      const ShadingPoint& point)
{
    const V3f mirror_normal = visible_normal(normal, point.wo, point.ng);
    GgxSurface surface{
        .normal = mirror_normal,
        .cos_o = mirror_normal.dot(point.wo),
        .roughness = unit_range(inputs.roughness),
        .multiple_scattering = inputs.multiple_scattering,
    };
    if (inputs.anisotropic > 0.0f) {
        const float aspect = std::sqrt(1.0f - 0.9f * unit_range(inputs.anisotropic));
        brush(surface, 1.0f / aspect, aspect, inputs.tangent, inputs.anisotropic_rotation, normal);
    }
    return surface;
}

void add_diffuse(Bsdf& bsdf,
                 const PrincipledInputs& inputs,
                 const Color3f& color,
                 const Color3f& weight,
                 const V3f& normal,
                 const ShadingPoint& point)
{
    const float roughness = unit_range(inputs.diffuse_roughness);
    if (roughness > 0.0f) {
        const LobeAndAlbedo rough =
            oren_nayar_lobe(color * weight, color, roughness, normal, point.ns, point.wo);
        bsdf.add(rough.lobe, rough.albedo);
    } else {
        bsdf.add(diffuse_lobe(color * weight, normal, point.ns), color * weight);
    }
}

// Lets light below the surface; returns what it leaves above.
[[nodiscard]] float add_subsurface_layer(Bsdf& bsdf,
                                         const PrincipledInputs& inputs,
                                         float polish_ior,
                                         const Color3f& weight,
                                         const V3f& normal,
                                         const ShadingPoint& point)
{
    const float share = unit_range(inputs.subsurface_weight);
    const Color3f color = unit_range(inputs.base_color);
    const float roughness = unit_range(inputs.roughness);
    const bool is_skin = inputs.subsurface_method == LobeKind::RandomWalkSkin;
    add_subsurface(bsdf,
                   {.method = inputs.subsurface_method,
                    .color = color,
                    .radius = Color3f(inputs.subsurface_radius) * inputs.subsurface_scale,
                    .alpha = roughness * roughness,
                    .ior = is_skin ? inputs.subsurface_ior : polish_ior,
                    .anisotropy = inputs.subsurface_anisotropy,
                    .always_walks = inputs.subsurface_always_walks},
                   color * weight * share, normal, point, inputs.after_diffuse);
    return 1.0f - share;
}

}  // namespace

void add_principled(Bsdf& bsdf,
                    const PrincipledInputs& inputs,
                    float whole_weight,
                    const ShadingPoint& point)
{
    const float alpha = unit_range(inputs.alpha);
    if (alpha < 1.0f) {
        const Color3f passing((1.0f - alpha) * whole_weight);
        bsdf.add(straight_lobe(passing), passing);
    }
    if (alpha * whole_weight == 0.0f) {
        return;
    }

    const V3f normal = unit_normal(inputs.normal, point.ns);
    Color3f weight = add_top_layers(bsdf, inputs, Color3f(alpha * whole_weight), normal, point);

    const Color3f base_color = positive_range(inputs.base_color);
    const Color3f clamped_color = unit_range(base_color);
    const Color3f specular_tint = positive_range(inputs.specular_tint);
    const float metallic = unit_range(inputs.metallic);
    const float transmission = unit_range(inputs.transmission_weight);
    const float ior = ior_range(inputs.ior);
    const float film_thickness_nm =
        inputs.thin_film_thickness_nm > thinnest_film_nm ? inputs.thin_film_thickness_nm : 0.0f;
    const float film_ior = ior_range(inputs.thin_film_ior);
    const GgxSurface surface = base_surface(inputs, normal, point);

    if (metallic > 0.0f) {
        if (inputs.shows_reflections) {
            add_metal(bsdf, surface, weight * metallic, clamped_color, unit_range(specular_tint));
        }
        weight *= 1.0f - metallic;
    }
    if (transmission > 0.0f && metallic < 1.0f) {
        GgxSurface unbrushed = surface;
        unbrushed.stretch_x = unbrushed.stretch_y = 1.0f;
        add_glass(bsdf, unbrushed, weight * transmission,
                  Color3f(inputs.shows_reflections ? 1.0f : 0.0f),
                  inputs.shows_refractions ? sqrt_of(clamped_color) : Color3f(0.0f),
                  {.ior = point.backfacing ? 1.0f / ior : ior,
                   .specular_tint = specular_tint,
                   .film_thickness_nm = film_thickness_nm,
                   .film_ior = point.backfacing ? film_ior / ior : film_ior,
                   .film_space = inputs.working_space});
        weight *= 1.0f - transmission;
    }
    if (max_component(weight) > 0.0f) {
        const float specular = in_range(inputs.specular_ior_level, 0.0f, largest_specular);
        const float polish_ior = adjusted_ior(ior, specular);
        if (inputs.shows_reflections && (polish_ior != 1.0f || film_thickness_nm > 0.0f)) {
            weight *= left_below(add_dielectric(bsdf, surface, weight,
                                                {.ior = polish_ior,
                                                 .specular_tint = specular_tint,
                                                 .film_thickness_nm = film_thickness_nm,
                                                 .film_ior = film_ior,
                                                 .film_space = inputs.working_space}));
        }
        if (inputs.subsurface_weight > 0.0f) {
            weight *= add_subsurface_layer(bsdf, inputs, polish_ior, weight, normal, point);
        }
        add_diffuse(bsdf, inputs, base_color, weight, normal, point);
    }
}

Color3f principled_emission(const PrincipledInputs& inputs, const ShadingPoint& point)
{
    const Color3f radiance = positive_range(inputs.emission_color) *
                             positive_range(inputs.emission_strength) * unit_range(inputs.alpha);
    if (!(inputs.sheen_weight > 0.0f || inputs.coat_weight > 0.0f)) {
        return radiance;
    }
    // Seen through the layers that lie on it.
    Bsdf unused(point.wo, point.ng);
    return radiance * add_top_layers(unused, inputs, Color3f(1.0f),
                                     unit_normal(inputs.normal, point.ns), point);
}

}  // namespace eye_render
