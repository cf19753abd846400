#include "scene/accelerator.h"

#include "scene/accelerator_shapes.h"
#include "scene/embree.h"
#include "scene/transform.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace eye_render {

namespace {

// False for NaN and infinity in origin or direction, and for NaN as a limit.
bool is_traceable(const Ray& ray)
{
    const V3f sum = ray.origin + ray.direction;
    return std::isfinite(sum.x + sum.y + sum.z) && ray.t_min <= ray.t_max;
}

RTCRay to_embree(const Ray& ray, RayMask mask)
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
    r.time = ray.time;
    r.mask = mask;
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
    if (rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_RAY_MASK_SUPPORTED) == 0) {
        throw std::runtime_error("this Embree was built without ray masks");
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

std::uint32_t Accelerator::attach(RTCSceneTy* scene,
                                  std::uint32_t id,
                                  const Shape& shape,
                                  RayMask met_by)
{
    EmbreeShape made = make_embree_shape(device_.get(), shape);
    rtcSetGeometryMask(made.geometry, met_by);
    rtcCommitGeometry(made.geometry);
    rtcAttachGeometryByID(scene, made.geometry, id);
    rtcReleaseGeometry(made.geometry);
    positions_.push_back(std::move(made.positions));
    return static_cast<std::uint32_t>(positions_.size() - 1);
}

std::uint32_t Accelerator::add_flat(const Shape& shape, RayMask met_by)
{
    const auto placement = static_cast<std::uint32_t>(shape_of_placement_.size());
    shape_of_placement_.push_back(attach(root_.get(), placement, shape, met_by));
    return placement;
}

Accelerator::Prototype Accelerator::add_prototype(const Shape& shape)
{
    SceneHandle scene = new_scene();
    const std::uint32_t number = attach(scene.get(), 0, shape, all_rays);
    rtcCommitScene(scene.get());
    check_device();
    prototypes_.push_back({std::move(scene), number});
    return static_cast<Prototype>(prototypes_.size() - 1);
}

std::uint32_t Accelerator::place(Prototype prototype,
                                 std::span<const M44d> world_from_object,
                                 RayMask met_by)
{
    const auto placement = static_cast<std::uint32_t>(shape_of_placement_.size());
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, prototypes_[prototype].scene.get());
    if (world_from_object.size() == 1) {
        // Imath's row-vector matrix in row order is Embree's column-vector matrix in column order.
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                                to_float(world_from_object.front()).getValue());
    } else {
        set_embree_motion(geometry, world_from_object);
    }
    rtcSetGeometryMask(geometry, met_by);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(root_.get(), geometry, placement);
    rtcReleaseGeometry(geometry);
    shape_of_placement_.push_back(prototypes_[prototype].shape);
    return placement;
}

M44f Accelerator::world_from_object(std::uint32_t placement, float time) const
{
    M44f matrix;
    rtcGetGeometryTransform(rtcGetGeometry(root_.get(), placement), time,
                            RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, matrix.getValue());
    return matrix;
}

void Accelerator::build()
{
    rtcCommitScene(root_.get());
    check_device();
}

std::optional<AcceleratorHit> Accelerator::intersect(const Ray& ray, RayMask mask) const
{
    if (!is_traceable(ray)) {
        return std::nullopt;
    }
    RTCRayHit query;
    query.ray = to_embree(ray, mask);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::Query told(ray.left);
    embree::intersect(root_.get(), told, query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return std::nullopt;
    }
    const bool is_instance = query.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
    return AcceleratorHit{.t = query.ray.tfar,
                          .ng = {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z},
                          .u = query.hit.u,
                          .v = query.hit.v,
                          .placement = is_instance ? query.hit.instID[0] : query.hit.geomID,
                          .primitive = query.hit.primID};
}

bool Accelerator::occluded(const Ray& ray, RayMask mask) const
{
    if (!is_traceable(ray)) {
        return true;
    }
    RTCRay query = to_embree(ray, mask);
    embree::Query told(ray.left);
    embree::occluded(root_.get(), told, query);
    return query.tfar < 0.0f;
}

}  // namespace eye_render
