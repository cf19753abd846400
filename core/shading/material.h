// Materials as data: what a surface is made of, each input a constant or read from the hit.
// `shade` turns a material at one hit into a mixture of BSDF lobes and emitted radiance.

#pragma once

#include "base/vector.h"
#include "shading/bsdf.h"

#include <string>

namespace eye_render {

// Which number of a looked-up colour a scalar input takes.
enum class Channel { Color, Luminance, Alpha };

// One input: the constant, or (when `texture` or `attribute` is set) what is read at the hit,
// in place of the constant. `texture` is looked up at UV layer `uv_layer`.
struct MaterialInput {
    static constexpr int none = -1;

    Color3f constant{0.0f};
    int texture = none;
    int uv_layer = none;
    int color_attribute = none;
    Channel channel = Channel::Color;

    [[nodiscard]] bool is_constant() const { return texture == none && color_attribute == none; }
};

enum class Surface { Principled, Diffuse, Glossy, Glass, Emission, Transparent };

struct Material {
    std::string name{};
    Surface surface = Surface::Principled;
    MaterialInput base_color{.constant = Color3f(0.8f)};
    MaterialInput metallic{.constant = Color3f(0.0f)};
    MaterialInput roughness{.constant = Color3f(0.5f)};
    // Blender's "Specular IOR Level": 0.5 leaves the reflectance that `ior` gives.
    MaterialInput specular{.constant = Color3f(0.5f)};
    MaterialInput ior{.constant = Color3f(1.5f)};
    MaterialInput transmission{.constant = Color3f(0.0f)};
    MaterialInput alpha{.constant = Color3f(1.0f)};
    MaterialInput emission_color{.constant = Color3f(0.0f)};
    MaterialInput emission_strength{.constant = Color3f(0.0f)};
    // Tangent-space normal map (a texture input only), blended in by `normal_strength`.
    MaterialInput normal_map{};
    MaterialInput normal_strength{.constant = Color3f(1.0f)};
    // Glossy, Glass and Principled: compensate the energy that single scattering loses.
    bool multiple_scattering = true;

    // True if light may pass straight through some point of the surface.
    [[nodiscard]] bool may_be_transparent() const;
    // True if some point of the surface may emit light.
    [[nodiscard]] bool may_emit() const;
};

struct TangentFrame {
    V3f tangent{0.0f};  // d(position)/du, normalised, world space; zero if the map is degenerate
    float bitangent_sign = 1.0f;  // B = sign * cross(N, T)
};

// What a material can ask of the hit it is evaluated at; implemented by scene/. Layers and
// textures are indices that the scene gave out.
class HitAttributes {
public:
    virtual ~HitAttributes() = default;
    [[nodiscard]] virtual V2f uv(int uv_layer) const = 0;
    [[nodiscard]] virtual TangentFrame tangent(int uv_layer) const = 0;
    [[nodiscard]] virtual Color4f color(int color_attribute) const = 0;
    // Linear Rec. 709, straight alpha.
    [[nodiscard]] virtual Color4f texture(int texture, const V2f& uv) const = 0;
};

// World-space geometry of a hit, already turned to the viewer: dot(wo, ng) > 0.
struct ShadingPoint {
    V3f wo;                   // unit, towards where the ray came from
    V3f ng;                   // unit geometric normal
    V3f ns;                   // unit interpolated normal
    bool backfacing = false;  // the ray hit the side that the mesh's winding calls its back
};

struct ShadedPoint {
    Bsdf bsdf;
    Color3f emission{0.0f};  // radiance towards wo
};

[[nodiscard]] ShadedPoint shade(const Material& material,
                                const ShadingPoint& point,
                                const HitAttributes& attributes);

// How much of the light passes straight through at this hit (1 - alpha for Principled), without
// building the BSDF: for shadow rays.
[[nodiscard]] Color3f straight_transmittance(const Material& material,
                                             const HitAttributes& attributes);

// Radiance towards the viewer of the emitting side only, for light sampling.
[[nodiscard]] Color3f emitted_radiance(const Material& material, const HitAttributes& attributes);

}  // namespace eye_render
