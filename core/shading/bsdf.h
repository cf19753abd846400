// A mixture of scattering lobes at one hit, built on the stack per hit and sampled as one
// distribution. World space, all directions unit and pointing away from the surface; radiance
// flows from wi to wo. Probabilities are per unit solid angle.
//
// Reflected light is on the viewer's side of the geometric normal and transmitted light on the
// other; a direction on which the geometric and a lobe's shading normal disagree carries none.

#pragma once

#include "base/vector.h"
#include "shading/lobe.h"

#include <array>
#include <cstddef>
#include <optional>

namespace eye_render {

struct BsdfSample {
    V3f wi;
    Color3f weight;  // f |cos| / pdf of the whole mixture; for a delta lobe, of that lobe over its
                     // probability
    float pdf = 0.0f;  // of the whole mixture; 0 for a delta lobe
    bool is_delta = false;
    // Passed straight through, as if the surface were not there: not a bounce.
    bool is_straight = false;
    bool is_transmitted = false;  // to the other side of the surface
    bool is_diffuse = false;      // drawn from a wide lobe, not a glossy one
    // Of the lobe drawn: product of its alphas, which of a rough glass is its roughness to the
    // fourth; 0 for a delta lobe, 1 for a wide one.
    float alpha_squared = 0.0f;
    // Of the mixture sampled: light enters by this lobe, and there is no wi.
    const Lobe* subsurface = nullptr;
};

// Something of a mixture by kinds of lobes: what passes straight through is in none of them.
struct BsdfParts {
    Color3f diffuse{0.0f};
    Color3f glossy{0.0f};  // what glass reflects included
    Color3f transmission{0.0f};
};

// What a mixture tells a denoiser. Lobes narrower than smallest_told_alpha are smooth, and show
// what lies behind them rather than themselves.
struct BsdfFeatures {
    V3f normal{0.0f};  // mean of the lobes'
    Color3f rough_albedo{0.0f};
    Color3f smooth_albedo{0.0f};
    float rough_share = 0.0f;  // of the light that the mixture returns
};

class Bsdf {
public:
    // Lobes it holds at most.
    static constexpr int capacity = 64;

    // Scatters nothing.
    Bsdf() : Bsdf(V3f(0.0f), V3f(0.0f)) {}
    // dot(wo, ng) > 0.
    Bsdf(const V3f& wo, const V3f& ng) : wo_(wo), ng_(ng) {}
    // Copies the lobes that are there.
    Bsdf(const Bsdf& other);
    Bsdf& operator=(const Bsdf& other);
    ~Bsdf() = default;

    // `albedo` is what the lobe does with light from all around, and decides how often it is
    // sampled: it may be approximate, but zero only where the lobe is. A lobe without is left out.
    // `transmitted` is the part of it that a glass lets pass.
    void add(const Lobe& lobe, const Color3f& albedo, const Color3f& transmitted = Color3f(0.0f))
    {
        const float importance = (albedo.x + albedo.y + albedo.z) / 3.0f;
        if (!(importance > 0.0f)) {
            return;
        }
        const bool is_delta = lobe.is_delta();
        importance_ += importance;
        has_finite_lobe_ |= !is_delta;
        transmits_ |= !is_delta && lobe.transmits();
        const auto i = static_cast<std::size_t>(count_++);
        lobes_[i] = lobe;
        shares_[i] = {importance, is_delta, albedo, transmitted};
    }

    // Roughens the glossy lobes to an alpha of at least this.
    void blur(float least_alpha);

    [[nodiscard]] BsdfValue evaluate(const V3f& wi) const;
    // The value by kinds of lobes.
    [[nodiscard]] BsdfParts parts(const V3f& wi) const;

    // `u_lobe` and both of `u` in [0, 1). Nothing if the light that was drawn is absorbed or
    // would leave through the wrong side of the surface: the path ends.
    [[nodiscard]] std::optional<BsdfSample> sample(float u_lobe, const V2f& u) const;

    // Fraction of light that goes anywhere but straight through: approximate.
    [[nodiscard]] BsdfParts albedos() const;
    [[nodiscard]] Color3f albedo() const;
    // What passes straight through.
    [[nodiscard]] Color3f straight() const;
    // Unit, towards the viewer; `otherwise` where nothing but straight passages has lobes.
    [[nodiscard]] V3f mean_normal(const V3f& otherwise) const;
    [[nodiscard]] BsdfFeatures features() const;
    // Lambert's, of the light that subsurface lobes let out here; nothing without such lobes.
    [[nodiscard]] std::optional<Lobe> exit_lobe() const;

    // True if next-event estimation has nothing to find: `evaluate` is zero everywhere.
    [[nodiscard]] bool is_delta_only() const { return !has_finite_lobe_; }

    // True if `evaluate` may find light on the far side of the surface.
    [[nodiscard]] bool transmits() const { return transmits_; }

private:
    struct Share {
        float importance;
        bool is_delta;
        Color3f albedo;
        Color3f transmitted;  // of glass
    };

    // Adds what the lobe has to its kind's part.
    static void add_part(BsdfParts& parts,
                         const Lobe& lobe,
                         const Color3f& value,
                         const Color3f& transmitted);

    V3f wo_;
    V3f ng_;
    float importance_ = 0.0f;
    int count_ = 0;
    bool has_finite_lobe_ = false;
    bool transmits_ = false;
    std::array<Share, capacity> shares_;
    union {
        std::array<Lobe, capacity> lobes_;  // not made before they are added: it would cost more
    };
};

}  // namespace eye_render
