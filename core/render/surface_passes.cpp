#include "render/surface_passes.h"

#include "base/warp.h"
#include "shading/frame.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

// Of the light that a mixture returns, the part that must come from rough lobes for its surface to
// be what a denoiser goes by: as in Cycles.
constexpr float least_rough_share = 0.25f;

[[nodiscard]] float mean(const Color3f& c) { return (c.x + c.y + c.z) / 3.0f; }

// A denoiser takes what shines for a colour.
[[nodiscard]] Color3f no_more_than_white(const Color3f& radiance)
{
    return {std::min(radiance.x, 1.0f), std::min(radiance.y, 1.0f), std::min(radiance.z, 1.0f)};
}

void add_aov(PassValues& values,
             const AovChannels& aov,
             const std::optional<NodeValue>& value,
             float coverage)
{
    if (!value) {
        return;
    }
    if (aov.is_color) {
        values.add_at(aov.first, Color3f(*value * coverage));
        values.add_at(aov.first + 3, coverage);
    } else {
        values.add_at(aov.first, value->x * coverage);
    }
}

// How much of the sky over the surface is free, by one ray.
[[nodiscard]] Color3f open_sky(const SeenSurface& seen, float distance, SampleSequence sequence)
{
    const auto u = sequence.next();
    const Frame frame(seen.shaded.bsdf.mean_normal(seen.hit.point.ns));
    const V3f wi = frame.world_from_local(sample_cosine_hemisphere(V2f(u[0], u[1])));
    if (wi.dot(seen.hit.point.ng) <= 0.0f) {
        return Color3f(0.0f);
    }
    Ray ray = seen.hit.ray_towards(wi);
    ray.t_max = distance;
    return seen.scene.transmittance(ray, seen.path);
}

}  // namespace

std::string_view to_string(MistFalloff falloff)
{
    switch (falloff) {
    case MistFalloff::Quadratic: return "QUADRATIC";
    case MistFalloff::InverseQuadratic: return "INVERSE_QUADRATIC";
    default: return "LINEAR";
    }
}

float mist_at(float distance, const SurfacePassSettings& settings)
{
    const float linear =
        std::clamp((distance - settings.mist_start) / settings.mist_depth, 0.0f, 1.0f);
    switch (settings.mist_falloff) {
    case MistFalloff::Quadratic: return linear * linear;
    case MistFalloff::InverseQuadratic: return std::sqrt(linear);
    default: return linear;
    }
}

SurfacePasses::SurfacePasses(PassValues* values, const SurfacePassSettings& settings)
    : values_(values), settings_(settings),
      seeks_features_(values != nullptr && (values->layout().has(Pass::DenoisingNormal) ||
                                            values->layout().has(Pass::DenoisingAlbedo)))
{
}

void SurfacePasses::note_seen(const SeenSurface& seen, SampleSequence sequence)
{
    PassValues& values = *values_;
    const PassLayout& layout = values.layout();
    if (!layout.has_surface()) {
        return;
    }
    const Bsdf& bsdf = seen.shaded.bsdf;
    const SurfaceHit& hit = seen.hit;
    const Color3f covered = seen.throughput * (Color3f(1.0f) - bsdf.straight());
    const float coverage = std::max(0.0f, mean(covered));
    values.add(Pass::Normal, bsdf.mean_normal(hit.point.ns) * coverage);
    values.add(Pass::Mist, (mist_at(hit.p_world.length(), settings_) - 1.0f) * coverage);

    if (layout.has(Pass::Uv)) {
        if (const std::optional<V2f> uv = seen.scene.active_uv(hit)) {
            values.add(Pass::Uv, Color3f(uv->x, uv->y, 1.0f) * coverage);
        }
    }

    const BsdfParts albedos = bsdf.albedos();
    values.add(Pass::DiffuseColor, seen.throughput * albedos.diffuse);
    values.add(Pass::GlossyColor, seen.throughput * albedos.glossy);
    values.add(Pass::TransmissionColor, seen.throughput * albedos.transmission);
    if (layout.has(Pass::AmbientOcclusion)) {
        values.add(Pass::AmbientOcclusion,
                   covered * open_sky(seen, settings_.occlusion_distance, sequence));
    }
    for (const AovChannels& aov : layout.aovs()) {
        add_aov(values, aov, seen.scene.aov(aov.number, hit, seen.path), coverage);
    }
    values.add_matte(Pass::CryptoObject, hit.placement->matte.object, coverage);
    values.add_matte(Pass::CryptoAsset, hit.placement->matte.asset, coverage);
    values.add_matte(Pass::CryptoMaterial, hit.material().matte, coverage);
}

void SurfacePasses::note_features(const SeenSurface& seen)
{
    const BsdfFeatures features = seen.shaded.bsdf.features();
    const bool is_black = features.rough_albedo + features.smooth_albedo == Color3f(0.0f);
    if (!is_black && features.rough_share <= least_rough_share) {
        feature_throughput_ *= features.smooth_albedo;
        return;
    }
    V3f normal;
    seen.scene.view().camera_from_world.multDirMatrix(features.normal, normal);
    values_->add(Pass::DenoisingNormal, {normal.x, normal.y, -normal.z});
    values_->add(Pass::DenoisingAlbedo,
                 feature_throughput_ *
                     (features.rough_albedo + no_more_than_white(seen.shaded.emission)));
    seeks_features_ = false;
}

void SurfacePasses::note_world(const Scene& scene,
                               const V3f& direction,
                               const PathState& path,
                               const Color3f& throughput)
{
    if (seeks_features_) {
        values_->add(Pass::DenoisingAlbedo,
                     feature_throughput_ * no_more_than_white(scene.background(direction, path)));
        seeks_features_ = false;
    }
    if (values_ == nullptr || path.depth > 0) {
        return;
    }
    for (const AovChannels& aov : values_->layout().aovs()) {
        add_aov(*values_, aov, scene.world_aov(aov.number, direction, path), mean(throughput));
    }
}

}  // namespace eye_render
