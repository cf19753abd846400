// The media of a scene: what fills its meshes and its world, and light on its way through them.

#include "scene/interior_attributes.h"
#include "scene/scene.h"
#include "scene/world_attributes.h"

#include <Imath/ImathBoxAlgo.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace eye_render {

namespace {

// Along each axis of the box that a medium which varies is averaged over.
constexpr int looks = 8;

// The mean of medium_at(p) over a grid in the box.
template <typename MediumAt>
[[nodiscard]] ParticipatingMedium mean_medium(const Imath::Box3f& box, const MediumAt& medium_at)
{
    ParticipatingMedium sum;
    for (int i = 0; i < looks * looks * looks; ++i) {
        const V3i cell(i % looks, i / looks % looks, i / (looks * looks));
        sum.add(medium_at(box.min + (V3f(cell) + V3f(0.5f)) / looks * box.size()));
    }
    sum.scale(1.0f / (looks * looks * looks));
    return sum;
}

// Of geometries, found once for all that are placed.
class Boxes {
public:
    [[nodiscard]] const Imath::Box3f& of(const Geometry& geometry)
    {
        const auto [known, is_new] = boxes_.try_emplace(&geometry);
        if (is_new) {
            known->second = bounds_of(geometry);
        }
        return known->second;
    }

    // In the world; without end for what moves.
    [[nodiscard]] Imath::Box3f around(const Placement& placement)
    {
        Imath::Box3f box =
            Imath::transform(of(*placement.geometry), placement.pose.world_from_object);
        if (placement.moves) {
            box.makeInfinite();
        }
        return box;
    }

private:
    std::map<const Geometry*, Imath::Box3f> boxes_;
};

// No more than the distance of the origin from the triangle: to its plane, or to the box around
// it.
[[nodiscard]] float least_distance(const std::array<V3f, 3>& corners)
{
    const auto& [p0, p1, p2] = corners;
    const float to_plane = std::abs(unit_or((p1 - p0).cross(p2 - p0), V3f(0.0f)).dot(p0));
    Imath::Box3f box;
    for (const V3f& p : corners) {
        box.extendBy(p);
    }
    return std::max(to_plane, Imath::clip(V3f(0.0f), box).length());
}

[[nodiscard]] std::uint32_t triangle_with(const Placement& placement, std::size_t slot)
{
    const auto count = static_cast<std::uint32_t>(placement.mesh()->triangles.size());
    std::uint32_t triangle = 0;
    while (triangle + 1 < count && placement.material_slot(triangle) != slot) {
        ++triangle;
    }
    return triangle;
}

}  // namespace

ParticipatingMedium Scene::medium_in(const Placement& placement,
                                     std::size_t slot,
                                     const Imath::Box3f& box) const
{
    const ShaderProgram& volume = placement.materials[slot]->volume;
    const std::uint32_t triangle = triangle_with(placement, slot);
    const auto at = [&](const V3f& p_object) {
        const ShadingPoint point{.wo = V3f(0.0f), .ng = V3f(0.0f), .ns = V3f(0.0f)};
        const InteriorAttributes attributes(placement, triangle, p_object, frame_);
        return volume.medium({.point = point, .attributes = attributes, .path = {}});
    };
    return volume.varies_in_space() ? mean_medium(box, at) : at(box.center());
}

ParticipatingMedium Scene::medium_of_world() const
{
    const ShaderProgram& volume = data_.world.volume;
    const auto at = [&](const V3f& p_world) {
        const ShadingPoint point{.wo = V3f(0.0f), .ng = V3f(0.0f), .ns = V3f(0.0f)};
        const WorldAttributes attributes(V3f(V3d(p_world) + frame_.eye_position_world), frame_);
        return volume.medium({.point = point, .attributes = attributes, .path = {}});
    };
    if (!volume.varies_in_space()) {
        return at(V3f(0.0f));
    }
    Boxes boxes;
    Imath::Box3f box(V3f(0.0f));
    for (const Placement& placement : placements_) {
        box.extendBy(boxes.around(placement));
    }
    return mean_medium(box, at);
}

void Scene::add_media()
{
    if (data_.world.has_volume()) {
        world_medium_ = medium_of_world();
    }
    Boxes boxes;
    std::map<const Material*, const ParticipatingMedium*> alike;  // in every object
    for (Placement& placement : placements_) {
        if (placement.mesh() == nullptr ||
            std::ranges::none_of(placement.materials, &Material::has_volume)) {
            continue;
        }
        placement.media.assign(placement.materials.size(), nullptr);
        for (std::size_t slot = 0; slot < placement.media.size(); ++slot) {
            const Material* const material = placement.materials[slot];
            if (!material->has_volume()) {
                continue;
            }
            const bool is_alike = material->volume.step_count() == 0;
            const ParticipatingMedium*& known = alike[material];
            if (!is_alike || known == nullptr) {
                known = &media_.emplace_back(
                    medium_in(placement, slot, boxes.of(*placement.geometry)));
            }
            placement.media[slot] = known;
        }
        media_box_.extendBy(boxes.around(placement));
    }
}

void Scene::look_around_eye()
{
    if (!media_box_.intersects(V3f(0.0f))) {
        return;
    }
    float distance = std::numeric_limits<float>::infinity();
    for (const Placement& placement : placements_) {
        if (placement.media.empty()) {
            continue;
        }
        if (placement.moves || !placement.mesh()->motion_positions.empty()) {
            return;
        }
        for (std::uint32_t t = 0; t < placement.mesh()->triangles.size(); ++t) {
            distance =
                std::min(distance, least_distance(corners_world({&placement, t}, shutter_middle)));
        }
    }
    media_at_eye_ = media_at(V3f(0.0f));
    reach_of_eye_ = distance;
}

bool Scene::is_cut_off_from_infinity() const
{
    const auto is_opaque = [](const Color3f& extinction) {
        return std::min({extinction.x, extinction.y, extinction.z}) > 0.0f;
    };
    return world_medium_ && is_opaque(world_medium_->extinction);
}

MediumStack Scene::media_at(const V3f& p, float time) const
{
    if (media_at_eye_ && p.length() < reach_of_eye_) {
        return *media_at_eye_;
    }
    MediumStack media(world_medium_ ? &*world_medium_ : nullptr);
    if (!media_box_.intersects(p)) {
        return media;
    }
    // Upwards: a mesh that is left without having been entered is around the point.
    std::vector<SurfaceHit> entered;
    Ray rest{.origin = p, .direction = V3f(0.0f, 0.0f, 1.0f), .time = time};
    for (int passages = 0; passages <= max_straight_passages; ++passages) {
        const auto hit = intersect(rest);
        if (!hit) {
            break;
        }
        if (const ParticipatingMedium* const medium = hit->medium()) {
            const bool is_known = std::ranges::any_of(entered, [&](const SurfaceHit& other) {
                return other.placement == hit->placement && other.medium() == medium;
            });
            if (!is_known) {
                entered.push_back(*hit);
                if (hit->point.backfacing) {
                    SurfaceHit entry = *hit;
                    entry.point.backfacing = false;
                    media.cross(entry);
                }
            }
        }
        rest = passed_through(rest, *hit);
    }
    return media;
}

}  // namespace eye_render
