// Rays that a node sends from the place where it is evaluated: for ambient occlusion and bevels.
// The scene answers for its surfaces; where a surface is only asked for what passes through or
// what it emits, and for lamps and the world, there is no probe.

#pragma once

#include "base/vector.h"

#include <cstdint>
#include <functional>

namespace eye_render {

class SurfaceProbe {
public:
    // A surface of the hit's own object. World space.
    struct Crossing {
        V3f from_hit;  // the way there from the hit
        V3f ng;        // unit, of either side
        V3f ns;        // unit, smooth, on the mesh's own side
    };

    virtual ~SurfaceProbe() = default;

    // True if a surface that throws shadows stands within `distance` along the unit `direction`;
    // of the hit's own object alone if `local`.
    [[nodiscard]] virtual bool is_blocked(const V3f& direction,
                                          float distance,
                                          bool local) const = 0;

    // Calls `visit` wherever a straight way goes through the hit's own object: `length` along the
    // unit `direction` from `start`, an offset from the hit.
    virtual void cross_own_object(const V3f& start,
                                  const V3f& direction,
                                  float length,
                                  const std::function<void(const Crossing&)>& visit) const = 0;

    // For sobol_key: differs from hit to hit, and is the same whenever the hit is.
    [[nodiscard]] virtual std::uint64_t seed() const = 0;
};

}  // namespace eye_render
