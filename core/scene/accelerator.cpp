#include "scene/accelerator.h"

#include "scene/embree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace eye_render {

namespace {

// Copies a mesh into `scene` as geometry number `id`; returns Embree's copy of the positions,
// which it pads for its vector loads.
std::span<const V3f> attach_triangles(RTCDevice device,
                                      RTCScene scene,
                                      std::uint32_t id,
                                      std::span<const V3f> positions,
                                      std::span<const TriangleIndices> triangles)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex_buffer = static_cast<V3f*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(V3f), positions.size()));
    auto* index_buffer = static_cast<TriangleIndices*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(TriangleIndices), triangles.size()));
    if (vertex_buffer == nullptr || index_buffer == nullptr) {
        rtcReleaseGeometry(geometry);
        throw std::runtime_error("no memory for " + std::to_string(triangles.size()) +
                                 " triangles");
    }
    std::ranges::copy(positions, vertex_buffer);
    std::ranges::copy(triangles, index_buffer);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
    return {vertex_buffer, positions.size()};
}

// False for NaN and infinity in origin or direction, and for NaN as a limit.
bool is_traceable(const Ray& ray)
{
    const V3f sum = ray.origin + ray.direction;
    return std::isfinite(sum.x + sum.y + sum.z) && ray.t_min <= ray.t_max;
}

RTCRay to_embree(const Ray& ray)
{
    RTCRay r;
    r.org_x = ray.origin.x;
    r.org_y = ray.origin.y;
    r.org_z = ray.origin.z;
    r.dir_x = ray.direction.x;
    r.dir_y = ray.direction.y;
    r.dir_z = ray.direction.z;
    r.tnear = ray.t_min;
    r.tfar = ray.t_max;
    r.time = 0.0f;
    r.mask = ~0u;
    r.id = 0;
    r.flags = 0;
    return r;
}

}  // namespace

void Accelerator::ReleaseDevice::operator()(RTCDeviceTy* device) const
{
    rtcReleaseDevice(device);
}
void Accelerator::ReleaseScene::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }

Accelerator::Accelerator() : device_(rtcNewDevice(nullptr))
{
    if (!device_) {
        throw std::runtime_error("Embree cannot start on this processor (Embree error " +
                                 std::to_string(rtcGetDeviceError(nullptr)) + ")");
    }
    root_ = new_scene();
}

Accelerator::SceneHandle Accelerator::new_scene() const
{
    SceneHandle scene(rtcNewScene(device_.get()));
    // Robust: no ray may slip through a shared edge, which would let daylight into closed rooms.
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
    return scene;
}

void Accelerator::check_device() const
{
    const RTCError error = rtcGetDeviceError(device_.get());
    if (error != RTC_ERROR_NONE) {
        throw std::runtime_error("the ray acceleration structure cannot be built: Embree error " +
                                 std::to_string(error) +
                                 (error == RTC_ERROR_OUT_OF_MEMORY ? " (out of memory)" : ""));
    }
}

std::uint32_t Accelerator::add_flat(std::span<const V3f> positions,
                                    std::span<const TriangleIndices> triangles)
{
    const auto placement = static_cast<std::uint32_t>(placement_positions_.size());
    placement_positions_.push_back(
        attach_triangles(device_.get(), root_.get(), placement, positions, triangles));
    return placement;
}

Accelerator::Prototype Accelerator::add_prototype(std::span<const V3f> positions,
                                                  std::span<const TriangleIndices> triangles)
{
    prototypes_.push_back(new_scene());
    RTCSceneTy* scene = prototypes_.back().get();
    prototype_positions_.push_back(
        attach_triangles(device_.get(), scene, 0, positions, triangles));
    rtcCommitScene(scene);
    check_device();
    return prototypes_.size() - 1;
}

std::uint32_t Accelerator::place(Prototype prototype, const M44f& world_from_object)
{
    const auto placement = static_cast<std::uint32_t>(placement_positions_.size());
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, prototypes_[prototype].get());
    // Imath's row-vector matrix in row order is Embree's column-vector matrix in column order.
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                            world_from_object.getValue());
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(root_.get(), geometry, placement);
    rtcReleaseGeometry(geometry);
    placement_positions_.push_back(prototype_positions_[prototype]);
    return placement;
}

void Accelerator::build()
{
    rtcCommitScene(root_.get());
    check_device();
}

std::optional<AcceleratorHit> Accelerator::intersect(const Ray& ray) const
{
    if (!is_traceable(ray)) {
        return std::nullopt;
    }
    RTCRayHit query;
    query.ray = to_embree(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(root_.get(), query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return std::nullopt;
    }
    const bool is_instance = query.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
    return AcceleratorHit{.t = query.ray.tfar,
                          .ng = {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z},
                          .u = query.hit.u,
                          .v = query.hit.v,
                          .placement = is_instance ? query.hit.instID[0] : query.hit.geomID,
                          .triangle = query.hit.primID};
}

bool Accelerator::occluded(const Ray& ray) const
{
    if (!is_traceable(ray)) {
        return true;
    }
    RTCRay query = to_embree(ray);
    embree::occluded(root_.get(), query);
    return query.tfar < 0.0f;
}

}  // namespace eye_render
