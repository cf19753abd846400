// What a place of the scene is, apart from the light there: for passes of data.

#include "scene/look_at.h"
#include "scene/world_attributes.h"

namespace eye_render {

std::optional<NodeValue> Scene::aov(int number, const SurfaceHit& hit, const PathState& path) const
{
    const ShaderProgram* const program = hit.material().aov(number);
    if (program == nullptr) {
        return std::nullopt;
    }
    return look_at(hit, [&](const HitAttributes& at) {
        return program->value({.point = hit.point, .attributes = at, .path = path});
    });
}

std::optional<NodeValue> Scene::world_aov(int number,
                                          const V3f& direction,
                                          const PathState& path) const
{
    const ShaderProgram* const program = data_.world.aov(number);
    if (program == nullptr) {
        return std::nullopt;
    }
    const ShadingPoint point{.wo = -direction, .ng = -direction, .ns = -direction};
    const WorldAttributes at(direction, frame_);
    return program->value({.point = point, .attributes = at, .path = path});
}

std::optional<V2f> Scene::active_uv(const SurfaceHit& hit) const
{
    constexpr int active = HitAttributes::active_uv_layer;
    if (hit.placement->layers->uv[active] == LayerLookup::none) {
        return std::nullopt;
    }
    return look_at(hit, [](const HitAttributes& at) { return at.uv(active); });
}

}  // namespace eye_render
