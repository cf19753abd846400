// Where the light of a path is put down: in Combined, and in the passes that tell it apart by
// where it came from and by what scattered it first. Each contribution goes to one of Emission,
// Environment, or the direct or indirect light of diffuse, glossy, transmission and volume, in
// shares that add up to it: the passes add up to Combined.

#pragma once

#include "render/light_path_limits.h"
#include "render/pass_values.h"
#include "scene/light_origin.h"
#include "shading/bsdf.h"

namespace eye_render {

struct PathRadiance {
    Color3f radiance{0.0f};
    // Below 1 where a transparent film or a holdout shows; of one path any number, whose mean over
    // paths is from 0 to 1.
    float alpha = 1.0f;
};

// By what light was scattered, in shares of each channel that add up to 1. What is neither of
// these was transmitted.
struct ScatterShares {
    Color3f diffuse{0.0f};
    Color3f glossy{0.0f};
    Color3f volume{0.0f};
};

inline const ScatterShares shares_of_medium{.volume = Color3f(1.0f)};
// Of light from `wi`: as the lobes weigh there.
[[nodiscard]] ScatterShares scatter_shares(const Bsdf& bsdf, const V3f& wi);
// Of light from where the sample points; of a delta lobe it is the lobe's own.
[[nodiscard]] ScatterShares scatter_shares(const Bsdf& bsdf, const BsdfSample& sample);

class PathLight {
public:
    // Without `values` only Combined is wanted.
    explicit PathLight(PassValues* values, const LightPathLimits& limits = {})
        : values_(values), clamp_direct_(limits.clamp_direct),
          clamp_indirect_(limits.clamp_indirect)
    {
    }

    // Whether scatter_first must be told of the path's first scattering.
    [[nodiscard]] bool wants_shares() const
    {
        return values_ != nullptr && values_->layout().has_scattered_light();
    }
    void scatter_first(const ScatterShares& shares) { first_ = shares; }

    // Light that came to the eye by way of `bounces` scatterings, weight and throughput included.
    // What is not finite, or not positive, counts as none.
    void add(const Color3f& contribution, const LightOrigin& origin, int bounces)
    {
        add(contribution, origin, bounces, first_);
    }
    // The same of light from `wi` that the surface at the path's end scatters.
    void add_lit(const Color3f& contribution,
                 const LightOrigin& origin,
                 int bounces,
                 const Bsdf& bsdf,
                 const V3f& wi)
    {
        const bool is_first = bounces == 1 && wants_shares();
        add(contribution, origin, bounces, is_first ? scatter_shares(bsdf, wi) : first_);
    }

    // The same of light that a medium scatters on the way of the path.
    void add_lit_in_medium(const Color3f& contribution, const LightOrigin& origin, int bounces)
    {
        add(contribution, origin, bounces, bounces == 1 ? shares_of_medium : first_);
    }

    // Whether add_shadow must be told how much of the lamps' light gets to what the camera sees.
    [[nodiscard]] bool wants_shadow() const
    {
        return values_ != nullptr && values_->layout().has(Pass::Shadow);
    }
    void add_shadow(const Color3f& unshadowed) { values_->add(Pass::Shadow, unshadowed); }

    // The world behind a transparent film: in its pass, though in no sum.
    [[nodiscard]] bool wants_world_behind_film() const
    {
        return values_ != nullptr && values_->layout().has(Pass::Environment);
    }
    void add_behind_film(const Color3f& contribution)
    {
        values_->add(Pass::Environment, contribution);
    }

    // A share of what the path sees is not in the picture.
    void uncover(const Color3f& share)
    {
        const float mean = (share.x + share.y + share.z) / 3.0f;
        seen_.alpha -= mean;
        uncover_matte(mean);
    }

    // Whether shadow catchers are to be told apart, and none was met so far.
    [[nodiscard]] bool may_be_caught() const
    {
        return values_ != nullptr && values_->layout().catcher() && !is_caught_;
    }
    // The rest of the light is on a shadow catcher, with what it would be without objects and the
    // world behind it, weight and throughput included.
    void be_caught(const Color3f& share, const Color3f& bare, const Color3f& behind);

    [[nodiscard]] const PathRadiance& seen() const { return seen_; }

private:
    void add(const Color3f& light,
             const LightOrigin& origin,
             int bounces,
             const ScatterShares& first);
    void uncover_matte(float share);

    PassValues* values_;
    float clamp_direct_;
    float clamp_indirect_;
    PathRadiance seen_;
    ScatterShares first_;
    bool is_caught_ = false;
};

}  // namespace eye_render
