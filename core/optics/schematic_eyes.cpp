// Sources, all in millimetres with conic constants Q:
// * Navarro: Escudero-Sanz & Navarro 1999 (JOSA A 16(8)), "Off-axis aberrations of a wide-angle
//   schematic eye model"; accommodation and dispersion of Navarro, Santamaria & Bescos 1985
//   (JOSA A 2(8)), fitted there up to 10 D and logarithmic beyond.
// * Arizona: Schwiegerling 2004, "Field Guide to Visual and Ophthalmic Optics"; its media have
//   Abbe numbers, here the two terms of Cauchy's formula that give them.
// * Le Grand's full theoretical eye, relaxed and accommodated: Le Grand & El Hage 1980,
//   "Physiological Optics"; dispersion by Cornu's formula. Only two states are published. Between
//   them, and beyond, curvatures (which powers are linear in, unlike radii), distances and index
//   change linearly.
//
// The clear apertures are anatomy, not part of the publications: a cornea 11.7 mm wide (Rufer,
// Schroder & Erb 2005) and a lens 9.5 mm wide.

#include "optics/schematic_eyes.h"

#include "base/units.h"

#include <cmath>

namespace eye_render {

namespace {

constexpr double cornea_semi_aperture_mm = 5.85;
constexpr double lens_semi_aperture_mm = 4.75;

struct Layer {
    double radius_mm;
    double conic;
    double thickness_mm;  // of the medium behind the surface
    Medium behind;
};

// Cornea, aqueous humour, lens and vitreous body.
LensSystem system_of(const std::array<Layer, 4>& layers, double retina_radius_mm)
{
    constexpr std::size_t lens = 2;
    LensSystem system;
    system.lens = lens;
    double vertex_mm = 0.0;
    for (const Layer& layer : layers) {
        const bool corneal = system.surfaces.size() < lens;
        system.surfaces.push_back(
            {.shape = ConicSurface::of_revolution(m_from_mm(vertex_mm), m_from_mm(layer.radius_mm),
                                                  layer.conic),
             .behind = layer.behind,
             .semi_aperture_m =
                 m_from_mm(corneal ? cornea_semi_aperture_mm : lens_semi_aperture_mm)});
        vertex_mm += layer.thickness_mm;
    }
    system.stop_m = system.surfaces[lens].shape.vertex_m;
    system.retina =
        ConicSurface::of_revolution(m_from_mm(vertex_mm), m_from_mm(retina_radius_mm), 0.0);
    return system;
}

LensSystem navarro(double a_d)
{
    const double l = std::log(a_d + 1.0);
    const double n = 9e-5 * (10.0 * a_d + a_d * a_d);
    return system_of(
        {{{7.72, -0.26, 0.55, HerzbergerDispersion{1.3975, 1.3807, 1.37405, 1.3668}},
          {6.5, 0.0, 3.05 - 0.05 * l, HerzbergerDispersion{1.3593, 1.3422, 1.3354, 1.3278}},
          {10.2 - 1.75 * l, -3.1316 - 0.34 * l, 4.0 + 0.1 * l,
           HerzbergerDispersion{1.4492 + n, 1.42625 + n, 1.4175 + n, 1.4097 + n}},
          {-6.0 + 0.2294 * l, -1.0 - 0.125 * l, 16.3203,
           HerzbergerDispersion{1.3565, 1.3407, 1.3341, 1.3273}}}},
        -12.0);
}

LensSystem arizona(double a_d)
{
    return system_of({{{7.8, -0.25, 0.55, cauchy_from_abbe(1.377, 57.1)},
                       {6.5, -0.25, 2.97 - 0.04 * a_d, cauchy_from_abbe(1.337, 61.3)},
                       {12.0 - 0.4 * a_d, -7.518749 + 1.28572 * a_d, 3.767 + 0.04 * a_d,
                        cauchy_from_abbe(1.42 + 0.00256 * a_d - 0.00022 * a_d * a_d, 51.9)},
                       {-5.224557 + 0.2 * a_d, -1.353971 - 0.431762 * a_d, 16.713,
                        cauchy_from_abbe(1.336, 61.1)}}},
                     -13.4);
}

LensSystem le_grand(double a_d)
{
    // The accommodated eye's refraction at the cornea.
    constexpr double published_d = 7.0525;
    const double t = a_d / published_d;
    const auto between = [t](double relaxed, double accommodated) {
        return relaxed + t * (accommodated - relaxed);
    };
    const auto radius_between_mm = [&](double relaxed_mm, double accommodated_mm) {
        return 1.0 / between(1.0 / relaxed_mm, 1.0 / accommodated_mm);
    };
    return system_of({{{7.8, 0.0, 0.55, CornuDispersion{1.3610, 7.4147}},
                       {6.5, 0.0, between(3.05, 2.65), CornuDispersion{1.3221, 7.0096}},
                       {radius_between_mm(10.2, 6.0), 0.0, between(4.0, 4.5),
                        CornuDispersion{1.3999 + between(0.0, 0.007), 9.2492}},
                       {radius_between_mm(-6.0, -5.5), 0.0, between(16.59655, 16.49655),
                        CornuDispersion{1.3208, 6.9806}}}},
                     -13.4);
}

}  // namespace

LensSystem schematic_eye(SchematicEyeKind kind, double nominal_accommodation_d)
{
    switch (kind) {
    case SchematicEyeKind::Navarro: return navarro(nominal_accommodation_d);
    case SchematicEyeKind::Arizona: return arizona(nominal_accommodation_d);
    case SchematicEyeKind::LeGrand: return le_grand(nominal_accommodation_d);
    }
    return {};
}

double max_nominal_accommodation_d(SchematicEyeKind kind)
{
    switch (kind) {
    case SchematicEyeKind::Navarro: return 20.0;
    case SchematicEyeKind::Arizona: return 8.0;
    case SchematicEyeKind::LeGrand: return 11.0;
    }
    return 0.0;
}

}  // namespace eye_render
