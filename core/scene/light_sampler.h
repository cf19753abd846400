// Chooses one light for a shading point among lamps, emissive triangles and the environment.
//
// The lights are grouped in a few clusters: a lamp each while they are few, boxes of nearby
// lamps or triangles else, and the environment. They are chosen by importance
// (light_importance.h), and within a cluster the choice goes by power, through an alias table. A
// little of the probability is shared out evenly, so that no light that can contribute is ever
// left out.
//
// The clusters are weighed once a shading point, in a LitPoint, however many questions follow.
//
// Probabilities here are discrete: of choosing that light. The density of a direction is the
// probability times the density of sampling a direction on that light. Who calls this knows only
// `weigh`, `choose` and `probability`; a light tree can take the place of the clusters.

#pragma once

#include "base/vector.h"
#include "scene/alias_table.h"
#include "scene/light_emitter.h"
#include "scene/motion.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eye_render {

struct LightChoice {
    LightKind kind = LightKind::Lamp;
    std::uint32_t index = 0;  // in the span of lamps or of triangles; 0 for the environment
    float probability = 0.0f;
};

// A point that is to be lit, and how much of the choice each cluster has there.
class LitPoint {
public:
    // Nowhere, and not to be asked before it is weighed: to clear it took 80 instructions a path.
    LitPoint() {}  // NOLINT(modernize-use-equals-default): a default one is cleared, too

    V3f p_world;
    float time = shutter_middle;  // at which lights that move are looked at

private:
    friend class LightSampler;

    static constexpr std::size_t max_clusters = 64;
    std::array<float, max_clusters> probabilities_;  // the first as many as there are clusters
};

class LightSampler {
public:
    LightSampler() = default;  // no lights
    // Copies what it needs. Lights that give nothing (black, degenerate) are never chosen.
    LightSampler(std::span<const Lamp> lamps,
                 std::span<const EmissiveTriangle> triangles,
                 const Environment& environment);

    // Weighs the lights for the point `p_world`. `n_world` is the unit normal on the side that is
    // lit, or zero where light counts from all sides. Into a place that can be used again, because
    // it is too large to be moved about.
    void weigh(const V3f& p_world, const V3f& n_world, LitPoint& point) const;

    // One light for the point, u in [0,1); nothing if there are no lights. The 24 bits of a float
    // are too few to tell 10^4 lights apart: u should have more.
    [[nodiscard]] std::optional<LightChoice> choose(const LitPoint& point, double u) const;

    // The probability with which `choose` gives that light for that point.
    [[nodiscard]] float probability(LightKind kind,
                                    std::uint32_t index,
                                    const LitPoint& point) const;

private:
    struct Cluster {
        LightEmitter bounds;      // of all members together; its kind and index say nothing
        std::uint32_t first = 0;  // members: [first, first + count) of members_
        std::uint32_t count = 0;
    };
    struct Member {
        LightKind kind = LightKind::Lamp;
        std::uint32_t light = 0;
    };
    // Where a light went.
    struct Place {
        static constexpr std::uint32_t nowhere = 0xffffffffu;
        std::uint32_t cluster = nowhere;
        std::uint32_t member = 0;
    };
    void add_clusters(std::span<LightEmitter> emitters, std::size_t max_count);
    void add_cluster(std::span<const LightEmitter> emitters);
    void add_members(std::span<const LightEmitter> emitters);
    [[nodiscard]] std::size_t place_index(LightKind kind, std::uint32_t index) const;

    std::vector<Cluster> clusters_;
    std::vector<Member> members_;
    std::vector<AliasColumn> columns_;  // one a member: each cluster's are a table
    std::size_t lamp_count_ = 0;
    std::vector<Place> places_;  // the environment's, then the lamps', then the triangles'
};

}  // namespace eye_render
