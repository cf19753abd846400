#include "render/path_light.h"
#include "base/magnitude.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

[[nodiscard]] float share_of(float part, float whole)
{
    return whole > 0.0f ? part / whole : 0.0f;
}

[[nodiscard]] Color3f share_of(const Color3f& part, const Color3f& whole)
{
    return {share_of(part.x, whole.x), share_of(part.y, whole.y), share_of(part.z, whole.z)};
}

// To a mean of that, its hue and sign kept; 0 for no limit.
[[nodiscard]] Color3f clamped(const Color3f& light, float most)
{
    const Color3f size = magnitude(light);
    const float mean = (size.x + size.y + size.z) / 3.0f;
    return most > 0.0f && mean > most ? light * (most / mean) : light;
}

}  // namespace

ScatterShares scatter_shares(const Bsdf& bsdf, const V3f& wi)
{
    const BsdfParts parts = bsdf.parts(wi);
    const Color3f whole = parts.diffuse + parts.glossy + parts.transmission;
    return {.diffuse = share_of(parts.diffuse, whole), .glossy = share_of(parts.glossy, whole)};
}

ScatterShares scatter_shares(const Bsdf& bsdf, const BsdfSample& sample)
{
    if (sample.is_delta) {
        return {.glossy = Color3f(sample.is_transmitted ? 0.0f : 1.0f)};
    }
    return scatter_shares(bsdf, sample.wi);
}

void PathLight::add(const Color3f& light,
                    const LightOrigin& origin,
                    int bounces,
                    const ScatterShares& first)
{
    const Color3f contribution = clamped(light, bounces > 1 ? clamp_indirect_ : clamp_direct_);
    // False for NaN and infinity, too, which one bad texture pixel can bring.
    if (!(is_light(contribution) &&
          std::isfinite(contribution.x + contribution.y + contribution.z))) {
        return;
    }
    seen_.radiance += contribution;
    if (values_ == nullptr) {
        return;
    }
    if (may_be_caught()) {
        values_->add_at(values_->layout().catcher()->matte, contribution);
    }
    const int group = values_->layout().light_group(origin.group);
    if (group != PassLayout::none) {
        values_->add_at(static_cast<std::size_t>(group), contribution);
    }
    if (bounces == 0) {
        values_->add(origin.is_world ? Pass::Environment : Pass::Emission, contribution);
    } else if (values_->layout().has_scattered_light()) {
        const bool is_direct = bounces == 1;
        const Color3f diffuse = contribution * first.diffuse;
        const Color3f glossy = contribution * first.glossy;
        const Color3f volume = contribution * first.volume;
        values_->add(is_direct ? Pass::DiffuseDirect : Pass::DiffuseIndirect, diffuse);
        values_->add(is_direct ? Pass::GlossyDirect : Pass::GlossyIndirect, glossy);
        values_->add(is_direct ? Pass::VolumeDirect : Pass::VolumeIndirect, volume);
        values_->add(is_direct ? Pass::TransmissionDirect : Pass::TransmissionIndirect,
                     contribution - diffuse - glossy - volume);
    }
}

void PathLight::uncover_matte(float share)
{
    if (may_be_caught()) {
        values_->add_at(values_->layout().catcher()->matte_alpha, -share);
    }
}

void PathLight::be_caught(const Color3f& share, const Color3f& bare, const Color3f& behind)
{
    uncover_matte((share.x + share.y + share.z) / 3.0f);
    values_->add_at(values_->layout().catcher()->bare, bare);
    values_->add_at(values_->layout().catcher()->behind, behind);
    is_caught_ = true;
}

}  // namespace eye_render
