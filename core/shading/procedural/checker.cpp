#include "shading/procedural/checker.h"

#include "shading/procedural/safe_float.h"

namespace eye_render {
namespace {

// Whole coordinates, which modelled faces often have, are moved off the border.
[[nodiscard]] bool is_odd(float x) { return (floor_to_int((x + 0.000001f) * 0.999999f) & 1) != 0; }

}  // namespace

bool checker_texture(const V3f& p) { return (is_odd(p.x) == is_odd(p.y)) == is_odd(p.z); }

}  // namespace eye_render
