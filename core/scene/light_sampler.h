// Chooses one light for a shading point among lamps, emissive triangles and the environment.
//
// The lights are grouped in a few clusters: a lamp each while they are few, boxes of nearby
// lamps or triangles else, and the environment. A cluster's importance estimates the irradiance
// it gives the point (intensity over squared distance, bounded by its orientation); within a
// cluster the choice goes by power, through an alias table (Vose 1991). Part of the probability
// is shared out evenly, so that no light that can contribute is ever left out.
//
// Probabilities here are discrete: of choosing that light. The density of a direction is the
// probability times the density of sampling a direction on that light. Who calls this knows only
// `choose` and `probability`; a light tree can take the place of the clusters.

#pragma once

#include "base/vector.h"
#include "scene/lamp.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eye_render {

class Environment;

enum class LightKind : std::uint8_t { Lamp, Triangle, Environment };

struct LightChoice {
    LightKind kind = LightKind::Lamp;
    std::uint32_t index = 0;  // in the span of lamps or of triangles; 0 for the environment
    float probability = 0.0f;
};

struct EmissiveTriangle {
    V3f p0_world, p1_world, p2_world;
    float radiance = 0.0f;  // luminance, estimated, of one side
    bool two_sided = true;
};

[[nodiscard]] float triangle_area(const V3f& p0, const V3f& p1, const V3f& p2);

class LightSampler {
public:
    LightSampler() = default;  // no lights
    // Copies what it needs. Lights that give nothing (black, degenerate) are never chosen.
    LightSampler(std::span<const Lamp> lamps,
                 std::span<const EmissiveTriangle> triangles,
                 const Environment& environment);

    [[nodiscard]] bool empty() const { return clusters_.empty(); }

    // One light for the point `p_world`, u in [0,1); nothing if there are no lights. `n_world` is
    // the unit normal on the side that is lit, or zero where light counts from all sides.
    [[nodiscard]] std::optional<LightChoice> choose(const V3f& p_world,
                                                    const V3f& n_world,
                                                    float u) const;

    // The probability with which `choose` gives that light for the same point and normal.
    [[nodiscard]] float probability(LightKind kind,
                                    std::uint32_t index,
                                    const V3f& p_world,
                                    const V3f& n_world) const;

private:
    struct Cluster {
        LightKind kind = LightKind::Lamp;
        bool is_distant = false;  // the environment and suns: importance is `intensity`
        V3f center_world{0.0f};
        float radius = 0.0f;      // of the sphere around all members
        float intensity = 0.0f;   // sum over members, luminance
        V3f axis{0.0f};           // direction of the light; zero when it shines all around
        float cos_edge = -1.0f;   // beyond this angle from the axis nothing is emitted
        std::uint32_t first = 0;  // members: [first, first + count) of entries_
        std::uint32_t count = 0;
    };
    // A column of the cluster's alias table, and the probability of member `light` in it.
    struct Entry {
        std::uint32_t light = 0;
        std::uint32_t alias = 0;  // index into entries_
        float keep = 1.0f;
        float probability = 0.0f;
    };

    [[nodiscard]] float importance(const Cluster& cluster,
                                   const V3f& p_world,
                                   const V3f& n_world) const;

    std::vector<Cluster> clusters_;
    std::vector<Entry> entries_;
    // Where each light ended up in entries_, or `unlisted`; and its cluster.
    struct Place {
        std::uint32_t cluster = 0;
        std::uint32_t entry = 0;
    };
    std::vector<Place> lamp_places_;
    std::vector<Place> triangle_places_;
    std::optional<Place> environment_place_;
};

}  // namespace eye_render
