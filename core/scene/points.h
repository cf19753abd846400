// A cloud of balls in its own object space, as plain data.

#pragma once

#include "scene/mesh.h"
#include "scene/sized_point.h"

#include <optional>
#include <string>
#include <vector>

namespace eye_render {

struct PointAttribute {
    std::string name;
    std::vector<Color4f> per_point;  // as Attribute has them
};

struct Points {
    std::string name;
    std::vector<SizedPoint> points;
    std::vector<PointAttribute> attributes;
    std::optional<TextureSpace> texture_space;  // nothing: the bounding box of the centres
    // Points at the times of motion.h; empty: still. `points` are those at the shutter's middle.
    std::vector<std::vector<SizedPoint>> motion;
};

// Throws std::invalid_argument when a length or a number is out of range.
void validate(const Points& points);

// Leaves out points that are not finite; returns how many.
std::size_t drop_broken_points(Points& points);

}  // namespace eye_render
