// Finds the lamps that a ray may meet among many: a tree of boxes around them, in one array in the
// order of a walk, each with the number to go on with where the ray misses it.

#pragma once

#include "scene/lamp.h"

#include <Imath/ImathBox.h>

#include <cstdint>
#include <span>
#include <vector>

namespace eye_render {

class LampTree {
public:
    LampTree() = default;  // no lamps
    // `which` of the lamps, by their numbers; none of them a delta lamp.
    LampTree(std::span<const Lamp> lamps, std::span<const std::uint32_t> which);

    // Calls visit(number) for all lamps that the ray may meet up to `t_max`, and perhaps for
    // others. `direction` is unit.
    template <typename Visit>
    void visit(const V3f& origin, const V3f& direction, float t_max, Visit visit) const
    {
        for (const std::uint32_t sun : suns_) {
            visit(sun);
        }
        const V3f inverse(1.0f / direction.x, 1.0f / direction.y, 1.0f / direction.z);
        for (std::size_t i = 0; i < nodes_.size();) {
            const Node& node = nodes_[i];
            if (!may_meet(node.box, origin, inverse, t_max)) {
                i = node.next;
                continue;
            }
            for (std::uint32_t member = 0; member < node.count; ++member) {
                visit(members_[node.first + member]);
            }
            ++i;
        }
    }

private:
    struct Node {
        Imath::Box3f box;
        std::uint32_t first = 0;  // of a leaf: its lamps, [first, first + count) of members_
        std::uint32_t count = 0;
        std::uint32_t next = 0;  // the node after all that are below this one
    };

    [[nodiscard]] static bool may_meet(const Imath::Box3f& box,
                                       const V3f& origin,
                                       const V3f& inverse_direction,
                                       float t_max);
    void add(std::span<const Lamp> lamps, std::uint32_t first, std::uint32_t count);

    std::vector<std::uint32_t> suns_;
    std::vector<std::uint32_t> members_;
    std::vector<Node> nodes_;
};

}  // namespace eye_render
