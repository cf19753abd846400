// Where a ray met a geometry. World space is relative to the eye.

#pragma once

#include "scene/accelerator.h"
#include "scene/ray.h"
#include "scene/scene_data.h"
#include "shading/material.h"

#include <array>
#include <vector>

namespace eye_render {

// Which of a mesh's layers a scene-wide layer number means; `none` where the mesh lacks the layer.
struct LayerLookup {
    static constexpr int none = -1;
    std::vector<int> uv;
    std::vector<int> attributes;
};

// Where a placement is at one time, relative to the eye.
struct Pose {
    M44f world_from_object;
    M33f world_from_object_normal;  // inverse transpose, so that normals keep their side
};

// One geometry at one place of the scene.
struct Placement {
    const Geometry* geometry = nullptr;
    const LayerLookup* layers = nullptr;
    const TextureSpace* texture_space = nullptr;
    std::vector<const Material*> materials;  // one a slot, at least one
    // Behind the surface, one a slot or null; empty: no medium.
    std::vector<const ParticipatingMedium*> media{};
    Pose pose;                 // at the shutter's middle
    bool is_flat = true;       // the accelerator holds the positions in world space
    bool is_mirrored = false;  // the determinant is negative
    bool moves = false;        // the accelerator knows where it is at other times
    ObjectLook look;
    Visibility visibility;
    bool is_holdout = false;
    bool is_shadow_catcher = false;
    float terminator_cosine = 0.0f;
    MatteIds matte;
    int light_group = no_light_group;
    LightLinks links;  // of its own light
    int light_class = 0;
    std::vector<int>
        emitters;  // per triangle, its number among the emitters or -1; empty: none emit

    // Nothing for other geometry.
    [[nodiscard]] const Mesh* mesh() const { return std::get_if<Mesh>(geometry); }
    // Curves and points wear the first material.
    [[nodiscard]] std::size_t material_slot(std::uint32_t primitive) const
    {
        const Mesh* const triangles = mesh();
        return triangles ? std::min(triangles->slot(primitive), materials.size() - 1) : 0;
    }
    [[nodiscard]] const Material& material(std::uint32_t primitive) const
    {
        return *materials[material_slot(primitive)];
    }
    [[nodiscard]] const ParticipatingMedium* medium(std::uint32_t primitive) const
    {
        return media.empty() ? nullptr : media[material_slot(primitive)];
    }
};

struct SurfaceHit {
    float t = 0.0f;
    V3f p_world{0.0f};
    float p_error = 0.0f;  // how far p_world may lie from the surface
    ShadingPoint point;
    const Placement* placement = nullptr;
    std::uint32_t primitive = 0;  // as AcceleratorHit has it, and so u and v
    float u = 0.0f;
    float v = 0.0f;
    float time = shutter_middle;
    StrandSegments strand{};  // all of the strand; empty: none

    [[nodiscard]] const Material& material() const { return placement->material(primitive); }
    [[nodiscard]] const ParticipatingMedium* medium() const
    {
        return placement->medium(primitive);
    }
    // Where a ray in direction `wi` starts, clear of the surface.
    [[nodiscard]] V3f origin_towards(const V3f& wi) const
    {
        const V3f& ng = point.ng;
        return offset_from_surface(p_world, ng.dot(wi) < 0.0f ? -ng : ng, p_error);
    }
    // That ray.
    [[nodiscard]] Ray ray_towards(const V3f& wi) const
    {
        return {.origin = origin_towards(wi), .direction = wi, .time = time, .left = strand};
    }

    // As the ray would have met it that came the other way.
    void turn_over()
    {
        point.wo = -point.wo;
        point.ng = -point.ng;
        point.ns = -point.ns;
        point.backfacing = !point.backfacing;
    }

    // The number among the scene's emitters, or -1.
    [[nodiscard]] int emitter() const
    {
        return placement->emitters.empty() ? -1 : placement->emitters[primitive];
    }
};

// How far a point of the triangle, computed in float from its corners as the accelerator holds
// them, may lie from it.
[[nodiscard]] float position_error(const Placement& placement, const std::array<V3f, 3>& corners);

// Turns what the accelerator found at the placement's pose into a hit, `positions` being the
// accelerator's.
[[nodiscard]] SurfaceHit make_surface_hit(const Ray& ray,
                                          const AcceleratorHit& found,
                                          const Placement& placement,
                                          const Pose& pose,
                                          const MotionSteps<V3f>& positions);

}  // namespace eye_render
