// The mixture: lobes are chosen in proportion to their albedo, and densities are summed over them.

#include "shading/bsdf.h"

#include "shading/fibre_lobe.h"

#include <algorithm>
#include <cstddef>

namespace eye_render {

namespace {

// The largest float below 1.
constexpr float below_one = 0x1.fffffep-1f;

// Of lobes that tell a denoiser about their surface: as in Cycles.
constexpr float smallest_told_alpha = 0.075f;

[[nodiscard]] bool is_rough(const Lobe& lobe)
{
    if (!lobe.has_facets()) {
        return lobe.kind != LobeKind::Straight;
    }
    return lobe.alpha_x * lobe.alpha_y > smallest_told_alpha * smallest_told_alpha;
}

// Towards the viewer.
[[nodiscard]] V3f visible_side(const Lobe& lobe)
{
    return lobe.kind == LobeKind::Translucent ? -lobe.normal : lobe.normal;
}

}  // namespace

Bsdf::Bsdf(const Bsdf& other) { *this = other; }

Bsdf& Bsdf::operator=(const Bsdf& other)
{
    if (this != &other) {
        wo_ = other.wo_;
        ng_ = other.ng_;
        importance_ = other.importance_;
        count_ = other.count_;
        has_finite_lobe_ = other.has_finite_lobe_;
        transmits_ = other.transmits_;
        std::copy_n(other.shares_.begin(), count_, shares_.begin());
        std::copy_n(other.lobes_.begin(), count_, lobes_.begin());
    }
    return *this;
}

void Bsdf::add_part(BsdfParts& parts,
                    const Lobe& lobe,
                    const Color3f& value,
                    const Color3f& transmitted)
{
    if (lobe.counts_as_diffuse()) {
        parts.diffuse += value;
    } else if (lobe.kind == LobeKind::Refraction) {
        parts.transmission += value;
    } else if (lobe.kind != LobeKind::Straight) {
        parts.glossy += value - transmitted;
        parts.transmission += transmitted;
    }
}

BsdfParts Bsdf::albedos() const
{
    BsdfParts sum;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        add_part(sum, lobes_[i], shares_[i].albedo, shares_[i].transmitted);
    }
    return sum;
}

Color3f Bsdf::albedo() const
{
    const BsdfParts all = albedos();
    return all.diffuse + all.glossy + all.transmission;
}

Color3f Bsdf::straight() const
{
    Color3f sum(0.0f);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        if (lobes_[i].kind == LobeKind::Straight) {
            sum += lobes_[i].weight;
        }
    }
    return sum;
}

void Bsdf::blur(float least_alpha)
{
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        Lobe& lobe = lobes_[i];
        if (lobe.kind == LobeKind::Fibre) {
            blur_fibre(lobe, least_alpha);
        }
        if (!lobe.has_facets()) {
            continue;
        }
        lobe.alpha_x = std::max(lobe.alpha_x, least_alpha);
        lobe.alpha_y = std::max(lobe.alpha_y, least_alpha);
        shares_[i].is_delta = lobe.is_delta();
        has_finite_lobe_ |= !shares_[i].is_delta;
        transmits_ |= !shares_[i].is_delta && lobe.transmits();
    }
}

V3f Bsdf::mean_normal(const V3f& otherwise) const
{
    V3f sum(0.0f);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        sum += visible_side(lobes_[i]) * shares_[i].importance;  // zero of a straight passage
    }
    return unit_or(sum, otherwise);
}

BsdfFeatures Bsdf::features() const
{
    BsdfFeatures features;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        const bool tells = is_rough(lobes_[i]);
        const float share = shares_[i].importance / importance_;
        features.normal += visible_side(lobes_[i]) * share;
        features.rough_share += tells ? share : 0.0f;
        (tells ? features.rough_albedo : features.smooth_albedo) += shares_[i].albedo;
    }
    return features;
}

std::optional<Lobe> Bsdf::exit_lobe() const
{
    V3f sum(0.0f);
    const Lobe* any = nullptr;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        if (lobes_[i].is_subsurface()) {
            any = &lobes_[i];
            sum += any->normal * shares_[i].importance;
        }
    }
    if (any == nullptr) {
        return std::nullopt;
    }
    return diffuse_lobe(Color3f(1.0f), unit_or(sum, any->normal), any->smooth_normal);
}

BsdfValue Bsdf::evaluate(const V3f& wi) const
{
    BsdfValue sum;
    const float side = ng_.dot(wi);
    if (!has_finite_lobe_ || side == 0.0f) {
        return sum;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        if (shares_[i].is_delta) {
            continue;
        }
        const BsdfValue one = eye_render::evaluate(lobes_[i], wo_, wi, side < 0.0f);
        sum.value += one.value;
        sum.pdf += one.pdf * shares_[i].importance;
    }
    sum.pdf /= importance_;
    return sum;
}

BsdfParts Bsdf::parts(const V3f& wi) const
{
    BsdfParts sum;
    const bool transmitted = ng_.dot(wi) < 0.0f;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        if (!shares_[i].is_delta) {
            const Color3f value = eye_render::evaluate(lobes_[i], wo_, wi, transmitted).value;
            add_part(sum, lobes_[i], value, transmitted ? value : Color3f(0.0f));
        }
    }
    return sum;
}

std::optional<BsdfSample> Bsdf::sample(float u_lobe, const V2f& u) const
{
    if (count_ == 0) {
        return std::nullopt;
    }

    // Choose a lobe and stretch what is left of u_lobe over [0, 1) again.
    float rest = u_lobe * importance_;
    std::size_t i = 0;
    while (i + 1 < static_cast<std::size_t>(count_) && rest >= shares_[i].importance) {
        rest -= shares_[i++].importance;
    }
    const Share& share = shares_[i];
    const float u_choice = std::clamp(rest / share.importance, 0.0f, below_one);

    if (lobes_[i].is_subsurface()) {
        return BsdfSample{.wi = V3f(0.0f),
                          .weight = lobes_[i].weight * (importance_ / share.importance),
                          .subsurface = &lobes_[i]};
    }
    const std::optional<LobeSample> drawn = eye_render::sample(lobes_[i], wo_, u_choice, u);
    if (!drawn || drawn->is_transmitted != (ng_.dot(drawn->wi) < 0.0f)) {
        return std::nullopt;
    }
    if (share.is_delta) {
        const Color3f weight = drawn->delta_weight * (importance_ / share.importance);
        return BsdfSample{.wi = drawn->wi,
                          .weight = weight,
                          .is_delta = true,
                          .is_straight = lobes_[i].kind == LobeKind::Straight,
                          .is_transmitted = drawn->is_transmitted,
                          .alpha_squared = 0.0f};
    }
    const BsdfValue mixture = evaluate(drawn->wi);
    if (!(mixture.pdf > 0.0f)) {
        return std::nullopt;
    }
    const Lobe& lobe = lobes_[i];
    return BsdfSample{.wi = drawn->wi,
                      .weight = mixture.value / mixture.pdf,
                      .pdf = mixture.pdf,
                      .is_transmitted = drawn->is_transmitted,
                      .is_diffuse = lobe.is_diffuse(),
                      .alpha_squared = lobe.has_facets() ? lobe.alpha_x * lobe.alpha_y : 1.0f};
}

}  // namespace eye_render
