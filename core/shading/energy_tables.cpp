// Computation and interpolation of the albedo tables; what they mean is in the header.

#include "shading/energy_tables.h"

#include "shading/facet_view.h"
#include "shading/fresnel.h"
#include "shading/lookup_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace eye_render {

namespace {

constexpr std::size_t fine = 32;    // nodes an axis of the tables without ior
constexpr std::size_t coarse = 16;  // nodes an axis of the tables with ior

// Spreads the indices from 1 to infinity over [0, 1], with most nodes where most materials are.
// The reciprocal of an index has the same place.
[[nodiscard]] float ior_parameter(float ior)
{
    return std::sqrt(std::abs((ior - 1.0f) / (ior + 1.0f)));
}

[[nodiscard]] float ior_at_node(std::size_t z)
{
    // At the ends the index would be 1, where Fresnel's equations blend from 0 to 0, and infinite.
    const float parameter = std::clamp(node<coarse>(z), 0.01f, 0.99f);
    return ior_from_f0(parameter * parameter * parameter * parameter);
}

// Calls fill(cosine node, roughness node, view) for every node of a table.
template <std::size_t Size, typename Fill>
void for_each_node(Fill&& fill)
{
    for (std::size_t c = 0; c < Size; ++c) {
        for (std::size_t r = 0; r < Size; ++r) {
            fill(c, r, FacetView(node<Size>(r), node<Size>(c)));
        }
    }
}

// 2 * integral of cos * albedo(cos), exact for what the table interpolates. [cosine][roughness]
// becomes [roughness].
template <std::size_t Size>
[[nodiscard]] Table1<Size> mean_over_cosine(const Table2<Size>& albedo)
{
    Table1<Size> mean;
    for (std::size_t c = 0; c + 1 < Size; ++c) {
        const float c0 = node<Size>(c);
        const float c1 = node<Size>(c + 1);
        for (std::size_t r = 0; r < Size; ++r) {
            const float a0 = albedo.at[c].at[r];
            const float a1 = albedo.at[c + 1].at[r];
            mean.at[r] += (c1 - c0) / 3.0f * (c0 * a0 + (c0 + c1) * (a0 + a1) + c1 * a1);
        }
    }
    return mean;
}

struct ReflectionTables {
    Table2<fine> albedo;             // [cosine][roughness]
    Table1<fine> mean_albedo;        // [roughness]
    Table2<coarse> schlick_mean;     // [cosine][roughness]
    Table3<coarse> dielectric_mean;  // [ior][cosine][roughness]

    ReflectionTables()
    {
        for_each_node<fine>([&](std::size_t c, std::size_t r, const FacetView& view) {
            view.for_each_facet([&](const Facet& m, float weight) {
                albedo.at[c].at[r] += weight * view.unshadowed(view.reflected_cos(m));
            });
        });
        mean_albedo = mean_over_cosine(albedo);
        for_each_node<coarse>([&](std::size_t c, std::size_t r, const FacetView& view) {
            view.for_each_facet([&](const Facet& m, float weight) {
                if (view.reflected_cos(m) > 0.0f) {
                    add_blends(c, r, m.cos_o, weight);
                }
            });
        });
    }

private:
    void add_blends(std::size_t c, std::size_t r, float cos_facet, float weight)
    {
        schlick_mean.at[c].at[r] += weight * schlick_blend(cos_facet);
        for (std::size_t z = 0; z < coarse; ++z) {
            const float ior = ior_at_node(z);
            const float f0 = f0_from_ior(ior);
            const float f = fresnel_dielectric(cos_facet, ior).reflectance;
            dielectric_mean.at[z].at[c].at[r] +=
                weight * std::clamp((f - f0) / (1.0f - f0), 0.0f, 1.0f);
        }
    }
};

enum class NearSide { Thin, Dense };

struct GlassTable {
    Table3<coarse> albedo;       // [ior][cosine][roughness]
    Table2<coarse> mean_albedo;  // [ior][roughness]

    explicit GlassTable(NearSide near_side)
    {
        for_each_node<coarse>([&](std::size_t c, std::size_t r, const FacetView& view) {
            view.for_each_facet([&](const Facet& m, float weight) {
                const float reflected = view.unshadowed(view.reflected_cos(m));
                for (std::size_t z = 0; z < coarse; ++z) {
                    const float dense = ior_at_node(z);
                    const float ior = near_side == NearSide::Dense ? 1.0f / dense : dense;
                    const DielectricFresnel f = fresnel_dielectric(m.cos_o, ior);
                    const float refracted =
                        view.unshadowed(view.refracted_cos(m, ior, f.cos_transmitted));
                    albedo.at[z].at[c].at[r] += weight * mix(refracted, reflected, f.reflectance);
                }
            });
        });
        // Between equal indices there is no boundary to lose light at, however rough.
        for (Table1<coarse>& row : albedo.at[0].at) {
            row.at.fill(1.0f);
        }
        for (std::size_t z = 0; z < coarse; ++z) {
            mean_albedo.at[z] = mean_over_cosine(albedo.at[z]);
        }
    }
};

[[nodiscard]] const ReflectionTables& reflection_tables()
{
    static const ReflectionTables tables;
    return tables;
}

[[nodiscard]] const GlassTable& glass_table(float ior)
{
    static const GlassTable thin(NearSide::Thin);
    static const GlassTable dense(NearSide::Dense);
    return ior < 1.0f ? dense : thin;
}

}  // namespace

LobeEnergy reflection_energy(float roughness, float cos_o)
{
    const ReflectionTables& tables = reflection_tables();
    const Place r = locate<fine>(roughness);
    return {tables.albedo.lookup(locate<fine>(cos_o), r), tables.mean_albedo.lookup(r)};
}

LobeEnergy glass_energy(float roughness, float cos_o, float ior)
{
    const GlassTable& table = glass_table(ior);
    const Place z = locate<coarse>(ior_parameter(ior));
    const Place r = locate<coarse>(roughness);
    return {table.albedo.lookup(z, locate<coarse>(cos_o), r), table.mean_albedo.lookup(z, r)};
}

float energy_compensation(const LobeEnergy& energy, float mean_fresnel)
{
    const float lost = (1.0f - energy.albedo) / energy.albedo;
    const float mean_lost = mean_fresnel * (1.0f - energy.mean_albedo);
    // One bounce of Fresnel is in the lobe already and so is cancelled here.
    return 1.0f + mean_fresnel * energy.mean_albedo / (1.0f - mean_lost) * lost;
}

Color3f energy_compensation(const LobeEnergy& energy, const Color3f& mean_fresnel)
{
    return {energy_compensation(energy, mean_fresnel.x),
            energy_compensation(energy, mean_fresnel.y),
            energy_compensation(energy, mean_fresnel.z)};
}

float dielectric_albedo_blend(float roughness, float cos_o, float ior)
{
    return reflection_tables().dielectric_mean.lookup(
        locate<coarse>(ior_parameter(ior)), locate<coarse>(cos_o), locate<coarse>(roughness));
}

float schlick_albedo_blend(float roughness, float cos_o)
{
    return reflection_tables().schlick_mean.lookup(locate<coarse>(cos_o),
                                                   locate<coarse>(roughness));
}

}  // namespace eye_render
