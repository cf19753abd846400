// Vectors between an object's own space and the world.

#pragma once

#include "shading/hit_attributes.h"

namespace eye_render {

// What moves along: its length is stretched as the object is.
[[nodiscard]] inline V3f vector_to_world(const ObjectFacts& object, const V3f& v)
{
    V3f world;
    object.world_from_object.multDirMatrix(v, world);
    return world;
}

[[nodiscard]] inline V3f vector_to_object(const ObjectFacts& object, const V3f& v)
{
    V3f own;
    object.object_from_world.multDirMatrix(v, own);
    return own;
}

// What stands on a surface, by the inverse transpose; of any length.
[[nodiscard]] inline V3f normal_to_world(const ObjectFacts& object, const V3f& n)
{
    V3f world;
    object.object_from_world.transposed().multDirMatrix(n, world);
    return world;
}

[[nodiscard]] inline V3f normal_to_object(const ObjectFacts& object, const V3f& n)
{
    V3f own;
    object.world_from_object.transposed().multDirMatrix(n, own);
    return own;
}

}  // namespace eye_render
