#include "scene/lamp_tree.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

// As many as cost about as much to look at as the boxes that would tell them apart.
constexpr std::uint32_t leaf_size = 4;

Imath::Box3f bounds_of(const Lamp& lamp)
{
    V3f half(lamp.radius);
    if (lamp.kind == LampKind::Area) {
        for (int axis = 0; axis < 3; ++axis) {
            half[axis] = std::abs(lamp.axis_x[axis]) * lamp.half_x +
                         std::abs(lamp.axis_y[axis]) * lamp.half_y;
        }
    }
    if (lamp.moves) {
        half = V3f(lamp.reach);
    }
    // For the roundings of the box and of the ray's way to it.
    constexpr float roundings = 16.0f * 1.2e-7f;
    for (int axis = 0; axis < 3; ++axis) {
        half[axis] += roundings * (std::abs(lamp.position[axis]) + half[axis]);
    }
    return {lamp.position - half, lamp.position + half};
}

}  // namespace

LampTree::LampTree(std::span<const Lamp> lamps, std::span<const std::uint32_t> which)
{
    for (const std::uint32_t number : which) {
        (lamps[number].kind == LampKind::Sun ? suns_ : members_).push_back(number);
    }
    if (!members_.empty()) {
        add(lamps, 0, static_cast<std::uint32_t>(members_.size()));
    }
}

// In halves of equal number across the longest side of the centres' box.
void LampTree::add(std::span<const Lamp> lamps, std::uint32_t first, std::uint32_t count)
{
    const std::size_t number = nodes_.size();
    nodes_.push_back({.box = {}, .first = first});
    Imath::Box3f box;
    Imath::Box3f centers;
    const std::span<std::uint32_t> members(&members_[first], count);
    for (const std::uint32_t member : members) {
        box.extendBy(bounds_of(lamps[member]));
        centers.extendBy(lamps[member].position);
    }
    nodes_[number].box = box;
    if (count <= leaf_size) {
        nodes_[number].count = count;
    } else {
        const int axis = static_cast<int>(centers.majorAxis());
        const std::uint32_t half = count / 2;
        std::ranges::nth_element(members, members.begin() + half, {}, [&](std::uint32_t member) {
            return lamps[member].position[axis];
        });
        add(lamps, first, half);
        add(lamps, first + half, count - half);
    }
    nodes_[number].next = static_cast<std::uint32_t>(nodes_.size());
}

bool LampTree::may_meet(const Imath::Box3f& box,
                        const V3f& origin,
                        const V3f& inverse_direction,
                        float t_max)
{
    float from = 0.0f;
    float to = t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const float a = (box.min[axis] - origin[axis]) * inverse_direction[axis];
        const float b = (box.max[axis] - origin[axis]) * inverse_direction[axis];
        // NaN, of a ray along a side of the box, leaves the bounds as they are.
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

}  // namespace eye_render
