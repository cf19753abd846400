#include "scene/ray.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace eye_render {

namespace {

// The constants of the publication: 256 float steps, and a fixed 1/65536 where |p| < 1/32.
constexpr float near_zero = 1.0f / 32.0f;
constexpr float fixed_step = 1.0f / 65536.0f;
constexpr float float_steps = 256.0f;

float offset_coordinate(float p, float n)
{
    if (std::abs(p) < near_zero) {
        return p + fixed_step * n;
    }
    const auto steps = static_cast<std::int32_t>(float_steps * n);
    return std::bit_cast<float>(std::bit_cast<std::int32_t>(p) + (p < 0.0f ? -steps : steps));
}

}  // namespace

V3f offset_from_surface(const V3f& p, const V3f& n, float error)
{
    const V3f clear = p + n * error;
    return {offset_coordinate(clear.x, n.x), offset_coordinate(clear.y, n.y),
            offset_coordinate(clear.z, n.z)};
}

}  // namespace eye_render
