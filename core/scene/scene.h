// A scene ready for ray queries: positions relative to the eye, the acceleration structure,
// lights.
//
// Everything here is constant after construction, so any number of threads may ask.

#pragma once

#include "base/room.h"
#include "base/vector.h"
#include "scene/accelerator.h"
#include "scene/environment.h"
#include "scene/incoming_light.h"
#include "scene/lamp_attributes.h"
#include "scene/lamp_motion.h"
#include "scene/lamp_tree.h"
#include "scene/light_sampler.h"
#include "scene/medium_stack.h"
#include "scene/scene_data.h"
#include "scene/scene_frame.h"
#include "scene/surface_hit.h"

#include <Imath/ImathBox.h>

#include <deque>
#include <functional>
#include <optional>
#include <vector>

namespace eye_render {

// A triangle that shines, and where it came from.
struct Emitter {
    const Placement* placement = nullptr;
    std::uint32_t triangle = 0;
};

// Layers of straight transparency that a ray passes before it is given up: enough for foliage, and
// an end where rounding never lets a ray out.
inline constexpr int max_straight_passages = 256;

// The same for what has a volume and no surface, as Cycles.
inline constexpr int max_boundaries = 1024;

// What is left of a ray behind a surface that let it pass.
[[nodiscard]] Ray passed_through(const Ray& ray, const SurfaceHit& hit);

class Scene {
public:
    // Keeps pointers into `data`, which must outlive the scene. `view` is for nodes that ask where
    // the camera is; it counts from the world's origin. Throws std::runtime_error when the
    // acceleration structure cannot be built.
    Scene(const SceneData& data, const V3d& eye_position_world, const ViewFrame& view = {});
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    // The nearest surface that the ray of such a path sees.
    [[nodiscard]] std::optional<SurfaceHit> intersect(const Ray& ray,
                                                      const PathState& path = {}) const;

    // The material at a hit: all of it, or only what passes straight through.
    [[nodiscard]] ShadedPoint shade(const SurfaceHit& hit, const PathState& path) const;
    [[nodiscard]] Color3f straight_transmittance(const SurfaceHit& hit,
                                                 const PathState& path) const;

    // The first surface that covers at least that much of what lies behind.
    [[nodiscard]] std::optional<SurfaceHit> first_visible(const Ray& ray,
                                                          float least_alpha = 0.5f) const;
    // What the material, or the world, writes out under this number; nothing if it does not.
    [[nodiscard]] std::optional<NodeValue> aov(int number,
                                               const SurfaceHit& hit,
                                               const PathState& path) const;
    [[nodiscard]] std::optional<NodeValue> world_aov(int number,
                                                     const V3f& direction,
                                                     const PathState& path) const;
    // By the mesh's active UV map; nothing if it has none.
    [[nodiscard]] std::optional<V2f> active_uv(const SurfaceHit& hit) const;
    // Where the place of a surface that was hit is at another time.
    [[nodiscard]] V3f place_at(const SurfaceHit& hit, float time) const;
    [[nodiscard]] const ViewFrame& view() const { return frame_.view; }
    [[nodiscard]] WorkingSpace working_space() const { return data_.working_space; }

    // The part of the light that passes along the ray: 0 behind an opaque surface, and behind more
    // than that many clear ones. `path` is that of the place it starts from, and so are `media`,
    // which the ray takes along; null in a scene without. `blocker_set` is the light's.
    [[nodiscard]] Color3f transmittance(const Ray& ray,
                                        const PathState& path = {},
                                        int most_passages = max_straight_passages,
                                        MediumStack* media = nullptr,
                                        int blocker_set = 0) const;

    // True if something fills a mesh or the world: then rays must look after what they are in.
    [[nodiscard]] bool has_media() const { return world_medium_ || !media_.empty(); }
    // What a path that starts at the point is in.
    [[nodiscard]] MediumStack media_at(const V3f& p, float time = shutter_middle) const;

    // True if anything that throws shadows stands in the way, even if light passes through it.
    [[nodiscard]] bool is_blocked(const Ray& ray) const;

    // Calls visit(SurfaceHit) for the surfaces of one object along the ray, while it says true.
    void visit_object(const Ray& ray,
                      const Placement& placement,
                      const std::function<bool(const SurfaceHit&)>& visit) const;

    // Weighs the lights for a point whose lit side is `n`.
    void weigh_lights(const V3f& p, const V3f& n, LitPoint& point) const
    {
        light_sampler_.weigh(p, n, point);
    }

    // One light and one place on it, for a weighed point; u_light and both of u in [0, 1). With
    // 10^4 lights and more, u_light should have more than the 24 bits of a float. Nothing if no
    // light was chosen or the chosen one cannot light the point.
    [[nodiscard]] std::optional<IncomingLight> sample_light(const LitPoint& point,
                                                            double u_light,
                                                            const V2f& u) const;

    [[nodiscard]] std::size_t lamp_count() const { return lamps_.size(); }

    // The middle of a light that may be chosen for the point; nothing for one that is far from
    // everything.
    [[nodiscard]] std::optional<V3f> light_center(const LitPoint& point, double u_light) const;

    // Density of `sample_light` at a point for what a ray from there in direction wi met.
    [[nodiscard]] float emitter_pdf(const SurfaceHit& hit, const LitPoint& point) const;
    [[nodiscard]] float environment_pdf(const V3f& wi, const LitPoint& point) const;
    [[nodiscard]] float lamp_pdf(const LampContribution& met, const LitPoint& point) const
    {
        return met.pdf * light_sampler_.probability(LightKind::Lamp, met.lamp, point);
    }

    // Calls visit(LampContribution) for each lamp that the path sees between t_min and t_max along
    // a ray that a BSDF, or the camera, chose at the point. Lamps do not stop rays.
    template <typename Visit>
    void visit_lamps(const LitPoint& point,
                     const PathState& path,
                     const V3f& direction,
                     float t_min,
                     float t_max,
                     Visit visit) const
    {
        const LampTree& lamps = path.is_camera ? camera_lamps_ : visible_lamps_;
        lamps.visit(point.p_world, direction, t_max, [&](std::uint32_t index) {
            if (!lamps_[index].visibility.shines_on(path)) {
                return;
            }
            Room<MovedLamp> moved;
            const auto hit =
                lamp_hit(lamp_at(index, point.time, moved), point.p_world, direction, t_max);
            if (hit && hit->t > t_min) {
                const LampSight sight{
                    .p_lit_world = point.p_world, .wi = direction, .distance = hit->t};
                visit(LampContribution{hit->t,
                                       hit->radiance * lamp_factor(index, moved, sight, path),
                                       hit->pdf,
                                       index,
                                       data_.lamps[index].links,
                                       {.group = data_.lamps[index].light_group}});
            }
        });
    }

    [[nodiscard]] LightOrigin world_origin() const
    {
        return {.is_world = true, .group = data_.world_light_group};
    }

    [[nodiscard]] Color3f background(const V3f& direction, const PathState& path) const
    {
        return data_.world_visibility.shines_on(path) ? environment_.radiance(direction, path)
                                                      : Color3f(0.0f);
    }

private:
    [[nodiscard]] std::optional<SurfaceHit> nearest(const Ray& ray, RayMask mask) const;
    // What `look` says about the attributes of the place that was hit.
    template <typename Look>
    [[nodiscard]] auto look_at(const SurfaceHit& hit, const Look& look) const;
    // The placement's own, or made in `moved` for one that moves.
    [[nodiscard]] const Pose& pose_at(const Placement& placement,
                                      float time,
                                      Room<Pose>& moved) const;
    // The same of a lamp.
    [[nodiscard]] const Lamp& lamp_at(std::uint32_t index,
                                      float time,
                                      Room<MovedLamp>& moved) const
    {
        if (lamp_motions_.empty() || !lamp_motions_[index]) {
            return lamps_[index];
        }
        return moved.fill(lamp_motions_[index]->at(time)).lamp;
    }
    // Radiance that the triangle sends from the point with these weights towards `wo`.
    [[nodiscard]] Color3f emission(const Emitter& emitter,
                                   const V2f& weights,
                                   const V3f& wo,
                                   float time) const;
    void add_placements();
    [[nodiscard]] std::vector<const Material*> materials_of(const InstanceData& instance) const;
    void add_lamps();
    void add_motion_of_lamp(std::uint32_t index);
    void add_media();
    // `box` of its geometry.
    [[nodiscard]] ParticipatingMedium medium_in(const Placement& placement,
                                                std::size_t slot,
                                                const Imath::Box3f& box) const;
    [[nodiscard]] ParticipatingMedium medium_of_world() const;
    // Paths start within the pupil or at the clipping plane: what the eye is in they are in, too,
    // unless a surface comes so near.
    void look_around_eye();
    // True if the world's medium leaves nothing of light that comes from infinitely far.
    [[nodiscard]] bool is_cut_off_from_infinity() const;
    void add_emitters(std::vector<EmissiveTriangle>& triangles);
    // What the nodes of a lamp, as `lamp_at` gave it, multiply its light by.
    [[nodiscard]] Color3f lamp_factor(std::uint32_t index,
                                      const Room<MovedLamp>& moved,
                                      const LampSight& sight,
                                      const PathState& path) const;
    [[nodiscard]] float brightest_factor(std::uint32_t index) const;
    // As the accelerator holds them: in the world for a flat placement, else in object space.
    [[nodiscard]] std::array<V3f, 3> accelerator_corners(const Emitter& emitter, float time) const;
    [[nodiscard]] std::array<V3f, 3> corners_world(const Emitter& emitter, float time) const;
    // Unit, the mesh's own side.
    [[nodiscard]] V3f emitter_normal(const Emitter& emitter, float time) const;
    [[nodiscard]] float mean_emission(const Emitter& emitter) const;
    // Of this light, whose choice is not in the density.
    [[nodiscard]] std::optional<IncomingLight> sample_chosen(const LightChoice& choice,
                                                             const LitPoint& point,
                                                             const V2f& u) const;
    [[nodiscard]] std::optional<IncomingLight> sample_emitter(std::uint32_t index,
                                                              const LitPoint& point,
                                                              const V2f& u) const;

    const SceneData& data_;
    SceneFrame frame_;
    Material grey_ = plain_material("BSDF_DIFFUSE", {});
    Accelerator accelerator_;
    std::vector<LayerLookup> geometry_layers_;
    std::vector<TextureSpace> texture_spaces_;  // one a geometry
    std::vector<Placement> placements_;
    std::optional<ParticipatingMedium> world_medium_;
    std::deque<ParticipatingMedium> media_;  // of placements, which point to them
    Imath::Box3f media_box_;                 // around all of them
    // What the eye's centre is in, and how far from it that is so; nothing where it may change.
    std::optional<MediumStack> media_at_eye_;
    float reach_of_eye_ = 0.0f;
    std::vector<Emitter> emitters_;
    std::vector<Lamp> lamps_;
    std::vector<LampSpace> lamp_spaces_;                   // one a lamp
    std::vector<std::optional<LampMotion>> lamp_motions_;  // one a lamp; empty: none moves
    LampTree visible_lamps_;                               // those that rays may meet
    LampTree camera_lamps_;  // and those of them that the camera sees
    Environment environment_;
    LightSampler light_sampler_;
    bool may_be_transparent_ = false;  // some material lets light straight through
};

}  // namespace eye_render
