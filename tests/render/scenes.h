// Small scenes for tests of the renderer.

#pragma once

#include "render/camera.h"
#include "scene/scene.h"
#include "scene/scene_data.h"

#include <cmath>
#include <memory>
#include <numbers>

namespace eye_render::test {

inline Material diffuse(float albedo)
{
    return plain_material("BSDF_DIFFUSE", {{"Color", V3f(albedo)}});
}

inline Material emission(float radiance)
{
    return plain_material("EMISSION", {{"Color", V3f(1.0f)}, {"Strength", V3f(radiance)}});
}

inline Material transparent(float share)
{
    return plain_material("BSDF_TRANSPARENT", {{"Color", V3f(share)}});
}

// No surface around a medium of that closure.
inline Material filled(std::string_view closure,
                       std::initializer_list<std::pair<std::string_view, NodeValue>> inputs)
{
    Material material = plain_material("BSDF_TRANSPARENT", {});
    material.volume = plain_material(closure, inputs).surface;
    return material;
}

inline Material emissive_diffuse(float albedo, float radiance)
{
    return plain_material("BSDF_PRINCIPLED", {{"Base Color", V3f(albedo)},
                                              {"Specular IOR Level", V3f(0.0f)},
                                              {"Emission Color", V3f(1.0f)},
                                              {"Emission Strength", V3f(radiance)}});
}

// A world of the same radiance everywhere.
inline Material even_world(float radiance)
{
    return plain_material("BACKGROUND", {{"Color", V3f(radiance)}});
}

// A square of half width `h` in the plane z = 0, facing +Z.
inline Mesh square(float h)
{
    Mesh mesh;
    mesh.name = "square";
    mesh.positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

// A cube of half width `h`.
inline Mesh cube(float h)
{
    Mesh mesh;
    mesh.name = "cube";
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.emplace_back((corner & 1) != 0 ? h : -h, (corner & 2) != 0 ? h : -h,
                                    (corner & 4) != 0 ? h : -h);
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

// A ball of radius `r`, its facets facing outwards: `rings` from pole to pole, twice as many
// around.
inline Mesh ball(float r, int rings)
{
    Mesh mesh;
    mesh.name = "ball";
    const int around = 2 * rings;
    const auto index = [around](int ring, int step) {
        return static_cast<std::uint32_t>(ring * around + step % around);
    };
    for (int ring = 0; ring <= rings; ++ring) {
        const float theta =
            std::numbers::pi_v<float> * static_cast<float>(ring) / static_cast<float>(rings);
        for (int step = 0; step < around; ++step) {
            const float phi = 2.0f * std::numbers::pi_v<float> * static_cast<float>(step) /
                              static_cast<float>(around);
            mesh.positions.push_back(V3f(std::sin(theta) * std::cos(phi),
                                         std::sin(theta) * std::sin(phi), std::cos(theta)) *
                                     r);
        }
    }
    for (int ring = 0; ring < rings; ++ring) {
        for (int step = 0; step < around; ++step) {
            if (ring > 0) {
                mesh.triangles.push_back(
                    {index(ring, step), index(ring + 1, step), index(ring, step + 1)});
            }
            if (ring + 1 < rings) {
                mesh.triangles.push_back(
                    {index(ring, step + 1), index(ring + 1, step), index(ring + 1, step + 1)});
            }
        }
    }
    return mesh;
}

inline void place(SceneData& data, Mesh mesh, const V3d& at, const Material& material)
{
    data.geometries.push_back(std::move(mesh));
    data.materials.push_back(material);
    M44d world_from_object;
    world_from_object.setTranslation(at);
    data.instances.push_back({.geometry = data.geometries.size() - 1,
                              .world_from_object = world_from_object,
                              .materials = {data.materials.size() - 1}});
}

inline LampData point_lamp(const V3d& at, float power_w)
{
    M44d world_from_light;
    world_from_light.setTranslation(at);
    LampSettings settings;
    settings.color = Color3f(power_w);
    return {.name = "point", .settings = settings, .world_from_light = world_from_light};
}

// A camera at the origin that looks along -Z through a square window of slopes.
inline CameraFrame frame(int size_px, double half_slope)
{
    CameraFrame f;
    f.slope_left = f.slope_bottom = -half_slope;
    f.slope_right = f.slope_top = half_slope;
    f.width_px = f.height_px = size_px;
    f.border = {0, 0, size_px, size_px};
    f.clip_near = 0.001;
    f.clip_far = 1e8;
    return f;
}

}  // namespace eye_render::test
