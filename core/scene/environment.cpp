#include "scene/environment.h"

#include "base/warp.h"
#include "scene/light_path.h"
#include "scene/world_attributes.h"
#include "shading/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

constexpr float largest = std::numeric_limits<float>::max();

// A finer table costs memory and cache misses and hardly finds a sun any better.
constexpr int table_max_width = 1024;
// What mixes with a small picture may be finer.
constexpr int table_min_width = 128;

// Looks into a cell along either axis, at most: of a picture 8 tables wide each pixel is seen.
constexpr int max_looks = 8;

// Of the samples, where a sky has a sun: it gives about half of the light of a clear day.
constexpr float sun_share = 0.5f;

// A picture may hold anything; light is neither negative nor infinite nor NaN.
Color3f physical(const Color3f& c)
{
    const auto component = [](float x) { return x > 0.0f && x <= largest ? x : 0.0f; };
    return {component(c.x), component(c.y), component(c.z)};
}

}  // namespace

Environment::Environment(const Material& world,
                         const SceneFrame& frame,
                         const std::optional<SunDisc>& sun)
    : world_(&world), frame_(&frame), constant_(world.surface.constant_emission())
{
    if (constant_) {
        constant_ = physical(*constant_);
        mean_luminance_ = luminance(*constant_);
        return;
    }
    sun_ = sun;
    // As fine as the widest picture: a small sun must meet a look into its cell.
    int picture_width = world.textures.empty() ? table_max_width : table_min_width;
    for (const int texture : world.textures) {
        picture_width = std::max(picture_width, frame.textures->width(texture));
    }
    const int width = std::min(picture_width, table_max_width);
    table_ = DirectionTable(width, std::min((picture_width + width - 1) / width, max_looks),
                            [this](const V3f& d) { return luminance(radiance(d, light_path)); });
    mean_luminance_ = table_.mean_luminance();
}

Color3f Environment::radiance(const V3f& direction, const PathState& path) const
{
    if (constant_) {
        return *constant_;
    }
    const ShadingPoint point{.wo = -direction, .ng = -direction, .ns = -direction};
    const WorldAttributes attributes(direction, *frame_);
    return physical(
        world_->surface.emission({.point = point, .attributes = attributes, .path = path}));
}

float Environment::sun_pdf(const V3f& direction) const
{
    // From the chord, because the cosine of a quarter of a degree has lost half its digits.
    const float chord = 2.0f * std::sin(0.5f * sun_->radius_rad);
    return (direction - sun_->direction).length() <= chord ? uniform_cone_pdf(0.5f * chord * chord)
                                                           : 0.0f;
}

EnvironmentSample Environment::sample(const V2f& u) const
{
    if (!has_table()) {
        const V3f wi = sample_uniform_sphere(u);
        return {wi, radiance(wi, light_path), uniform_sphere_pdf()};
    }
    if (!sun_) {
        const auto [wi, density] = table_.sample(u);
        return {wi, radiance(wi, light_path), density};
    }
    V3f wi;
    if (u.x < sun_share) {
        const float chord = 2.0f * std::sin(0.5f * sun_->radius_rad);
        wi = Frame(sun_->direction)
                 .world_from_local(
                     sample_uniform_cone({u.x / sun_share, u.y}, 0.5f * chord * chord));
    } else {
        wi = table_.sample({(u.x - sun_share) / (1.0f - sun_share), u.y}).direction;
    }
    return {wi, radiance(wi, light_path), pdf(wi)};
}

float Environment::pdf(const V3f& direction) const
{
    if (!has_table()) {
        return uniform_sphere_pdf();
    }
    const float by_table = table_.pdf(direction);
    return sun_ ? sun_share * sun_pdf(direction) + (1.0f - sun_share) * by_table : by_table;
}

}  // namespace eye_render
