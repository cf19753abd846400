// Object transforms on their way from absolute doubles to floats relative to the eye. Imath's row
// vectors: the fourth row is the position.

#pragma once

#include "base/vector.h"

namespace eye_render {

[[nodiscard]] M44d relative_to_eye(M44d world_from_object, const V3d& eye_position_world);

[[nodiscard]] M44f to_float(const M44d& m);

[[nodiscard]] bool is_mirror(const M44d& m);

// Whether float arithmetic can go back through the matrix: not if it flattens what it places, or
// nearly so.
[[nodiscard]] bool is_invertible(const M44d& m);

// What the matrix multiplies lengths by: the cube root of what it multiplies volumes by. Radii of
// strands and balls keep round by it in the world, however unevenly their places are stretched.
[[nodiscard]] float scale_of(const M44f& m);

// Takes normals to the world and keeps their side: cofactors of the upper-left block with the sign
// of its determinant, which is the inverse transpose times a positive factor. Unlike the inverse
// it exists for a flattened object, too. Scaled so that its largest entry is 1.
[[nodiscard]] M33f normal_matrix(const M44d& m);

}  // namespace eye_render
