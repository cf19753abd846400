#include "scene/point_attributes.h"

#include "scene/transform.h"
#include "shading/procedural/hash.h"

#include <limits>

namespace eye_render {

V3f PointAttributes::position_world() const { return {V3d(p_world_) + frame_.eye_position_world}; }

V3f PointAttributes::position_object() const
{
    return p_world_ * pose_.world_from_object.inverse();
}

V3f PointAttributes::generated() const
{
    return in_texture_space(points_.points[primitive_].center);
}

AttributeValue PointAttributes::attribute(int attribute) const
{
    const int layer = placement_.layers->attributes[static_cast<std::size_t>(attribute)];
    if (layer == LayerLookup::none) {
        return object_property(attribute);
    }
    return {.value = points_.attributes[static_cast<std::size_t>(layer)].per_point[primitive_],
            .exists = true};
}

float PointAttributes::edge_distance() const { return std::numeric_limits<float>::max(); }

std::optional<PointFacts> PointAttributes::point() const
{
    const SizedPoint ball = at_time(points_.points, points_.motion, primitive_, hit_.time);
    const V3f relative = ball.center * pose_.world_from_object;
    return PointFacts{.position_world = V3f(V3d(relative) + frame_.eye_position_world),
                      .radius = ball.radius * scale_of(pose_.world_from_object),
                      .random = 0x1p-32f * static_cast<float>(hash(primitive_, 0u))};
}

}  // namespace eye_render
