// Any kind of geometry, and what can be said of all kinds.

#pragma once

#include "scene/curves.h"
#include "scene/mesh.h"
#include "scene/points.h"

#include <Imath/ImathBox.h>

#include <string>
#include <variant>

namespace eye_render {

using Geometry = std::variant<Mesh, Curves, Points>;

[[nodiscard]] const std::string& name_of(const Geometry& geometry);

// Without a primitive to be met.
[[nodiscard]] bool is_empty(const Geometry& geometry);

// Its own, or its bounding box, at least a little wide.
[[nodiscard]] TextureSpace texture_space_of(const Geometry& geometry);

// Of all that it takes up while the shutter is open.
[[nodiscard]] Imath::Box3f bounds_of(const Geometry& geometry);

// While the shutter is open.
[[nodiscard]] bool deforms(const Geometry& geometry);

void validate(const Geometry& geometry);

// Leaves out what is not finite of a valid geometry; returns in words what and how much, empty for
// nothing. One bad vertex must not cost a user the picture, and must not reach the boxes that plan
// and lights are made from.
[[nodiscard]] std::string drop_broken(Geometry& geometry);

}  // namespace eye_render
