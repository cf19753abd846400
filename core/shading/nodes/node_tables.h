// The node kinds, one table a family; node_types.cpp joins them.

#pragma once

#include "shading/node.h"

#include <span>

namespace eye_render {

// Surfaces: Principled, Diffuse, Emission, …
[[nodiscard]] std::span<const NodeType> closure_nodes();
// Noise, Voronoi, Wave, …: a value for a point of space.
[[nodiscard]] std::span<const NodeType> procedural_texture_nodes();
// Image and environment pictures.
[[nodiscard]] std::span<const NodeType> image_texture_nodes();
// Math, Vector Math, Map Range, …
[[nodiscard]] std::span<const NodeType> math_nodes();
// Mix, Curves, Colour Ramp, Hue/Saturation, …
[[nodiscard]] std::span<const NodeType> color_nodes();
// Texture Coordinate, Geometry, Tangent: places and directions of the hit.
[[nodiscard]] std::span<const NodeType> coordinate_nodes();
// UV Map, Attribute, Colour Attribute: what the mesh and the object bring along.
[[nodiscard]] std::span<const NodeType> layer_nodes();
// Object Info, Light Path, Fresnel, …: what else is read from the hit.
[[nodiscard]] std::span<const NodeType> input_nodes();
// Hair Info, Point Info.
[[nodiscard]] std::span<const NodeType> strand_nodes();
// Normal Map, Bump: what bends the normal.
[[nodiscard]] std::span<const NodeType> normal_nodes();
// Displacement, Vector Displacement.
[[nodiscard]] std::span<const NodeType> displacement_nodes();
// Ambient Occlusion, Bevel: what sends rays to look around.
[[nodiscard]] std::span<const NodeType> probe_nodes();
// IES Texture, Light Falloff: what lamps are dressed with.
[[nodiscard]] std::span<const NodeType> lamp_nodes();
// Sky Texture.
[[nodiscard]] std::span<const NodeType> sky_nodes();

}  // namespace eye_render
