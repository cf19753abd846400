#include "shading/procedural/brick.h"

#include "shading/procedural/safe_float.h"

#include <algorithm>
#include <cstdint>

namespace eye_render {
namespace {

// In [0, 1]; the polynomial of Elias' integer noise, seeded as Blender's.
[[nodiscard]] float random_tint(std::uint32_t brick)
{
    std::uint32_t n = (brick + 1013u) & 0x7fffffffu;
    n ^= n >> 13;
    const std::uint32_t bits = (n * (n * n * 60493u + 19990303u) + 1376312589u) & 0x7fffffffu;
    return 0.5f * (static_cast<float>(bits) / 1073741824.0f);
}

[[nodiscard]] float mortar_at(float edge_distance, const Brick& brick)
{
    if (edge_distance >= brick.mortar_size) {
        return 0.0f;
    }
    if (brick.mortar_smooth <= 0.0f) {
        return 1.0f;
    }
    return smooth_step((1.0f - edge_distance / brick.mortar_size) / brick.mortar_smooth);
}

}  // namespace

BrickAnswer brick_texture(const V3f& p, const Brick& brick)
{
    const int row = floor_to_int(p.y / brick.row_height);
    const float width =
        brick.brick_width * (row % brick.squash_frequency != 0 ? 1.0f : brick.squash);
    const float shift = row % brick.offset_frequency != 0 ? 0.0f : width * brick.offset;
    const float y = p.y - brick.row_height * static_cast<float>(row);
    float edge_distance = std::min(y, brick.row_height - y);
    int column = 0;
    // A row of bricks without width has no joints across, as in Cycles.
    if (width != 0.0f) {
        column = floor_to_int((p.x + shift) / width);
        const float x = (p.x + shift) - width * static_cast<float>(column);
        edge_distance = std::min(std::min(x, width - x), edge_distance);
    }
    const std::uint32_t number =
        (static_cast<std::uint32_t>(row) << 16) + (static_cast<std::uint32_t>(column) & 0xffffu);
    return {unit_range(random_tint(number) + brick.bias), mortar_at(edge_distance, brick)};
}

}  // namespace eye_render
