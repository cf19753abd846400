#include "scene/accelerator_shapes.h"

#include "scene/embree.h"

#include <Imath/ImathMatrixAlgo.h>
#include <Imath/ImathQuat.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace eye_render {

namespace {

// A geometry of that many motion steps, released unless it is given away.
class NewGeometry {
public:
    NewGeometry(RTCDevice device, RTCGeometryType type, std::size_t steps)
        : geometry_(rtcNewGeometry(device, type))
    {
        if (steps > 1) {
            rtcSetGeometryTimeStepCount(geometry_, static_cast<unsigned>(steps));
        }
    }
    NewGeometry(const NewGeometry&) = delete;
    NewGeometry& operator=(const NewGeometry&) = delete;
    ~NewGeometry()
    {
        if (geometry_ != nullptr) {
            rtcReleaseGeometry(geometry_);
        }
    }

    template <typename T>
    [[nodiscard]] std::span<T> buffer(RTCBufferType type,
                                      std::size_t slot,
                                      RTCFormat format,
                                      std::size_t count)
    {
        auto* items = static_cast<T*>(rtcSetNewGeometryBuffer(
            geometry_, type, static_cast<unsigned>(slot), format, sizeof(T), count));
        if (items == nullptr) {
            throw std::runtime_error("no memory for a geometry of " + std::to_string(count) +
                                     " items");
        }
        return {items, count};
    }

    [[nodiscard]] RTCGeometry get() const { return geometry_; }
    [[nodiscard]] RTCGeometry release() { return std::exchange(geometry_, nullptr); }

private:
    RTCGeometry geometry_;
};

// Balls are met from outside only: a ray that leaves one does not meet it again, whichever way the
// intersection was rounded.
void ignore_back(const RTCFilterFunctionNArguments* arguments)
{
    const auto* ray = reinterpret_cast<const RTCRay*>(arguments->ray);
    const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
    if (ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z > 0.0f) {
        arguments->valid[0] = 0;
    }
}

void ignore_left_strand(const RTCFilterFunctionNArguments* arguments)
{
    const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
    const StrandSegments& left = embree::Query::of(*arguments).left;
    const bool is_instance = hit->instID[0] != RTC_INVALID_GEOMETRY_ID;
    if (hit->primID >= left.first && hit->primID < left.end &&
        left.placement == (is_instance ? hit->instID[0] : hit->geomID)) {
        arguments->valid[0] = 0;
    }
}

void set_filter(RTCGeometry geometry, RTCFilterFunctionN filter)
{
    rtcSetGeometryIntersectFilterFunction(geometry, filter);
    rtcSetGeometryOccludedFilterFunction(geometry, filter);
}

EmbreeShape make(RTCDevice device, const TriangleShape& shape)
{
    const auto& steps = shape.positions.steps;
    NewGeometry geometry(device, RTC_GEOMETRY_TYPE_TRIANGLE, steps.size());
    EmbreeShape made{};
    for (std::size_t step = 0; step < steps.size(); ++step) {
        const std::span<V3f> positions = geometry.buffer<V3f>(
            RTC_BUFFER_TYPE_VERTEX, step, RTC_FORMAT_FLOAT3, steps[step].size());
        std::ranges::copy(steps[step], positions.begin());
        made.positions.steps.emplace_back(positions);
    }
    std::ranges::copy(shape.triangles,
                      geometry
                          .buffer<TriangleIndices>(RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                   shape.triangles.size())
                          .begin());
    made.geometry = geometry.release();
    return made;
}

RTCGeometryType type_of(StrandShape shape)
{
    switch (shape) {
    case StrandShape::Round: break;
    case StrandShape::RoundLinear: return RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE;
    case StrandShape::Ribbon: return RTC_GEOMETRY_TYPE_FLAT_CATMULL_ROM_CURVE;
    }
    return RTC_GEOMETRY_TYPE_ROUND_CATMULL_ROM_CURVE;
}

EmbreeShape make(RTCDevice device, const StrandsShape& shape)
{
    const auto& steps = shape.keys.steps;
    const std::size_t strands = shape.first_keys.size();
    const std::size_t keys = steps.front().size();
    NewGeometry geometry(device, type_of(shape.kind), steps.size());
    const auto for_strands = [&](const auto& visit) {
        for (std::size_t strand = 0; strand < strands; ++strand) {
            const std::size_t end = strand + 1 < strands ? shape.first_keys[strand + 1] : keys;
            visit(shape.first_keys[strand], end);
        }
    };
    for (std::size_t step = 0; step < steps.size(); ++step) {
        // Every strand's ends twice.
        auto key = geometry
                       .buffer<SizedPoint>(RTC_BUFFER_TYPE_VERTEX, step, RTC_FORMAT_FLOAT4,
                                           keys + 2 * strands)
                       .begin();
        for_strands([&](std::size_t first, std::size_t end) {
            *key++ = steps[step][first];
            key = std::copy(steps[step].begin() + static_cast<std::ptrdiff_t>(first),
                            steps[step].begin() + static_cast<std::ptrdiff_t>(end), key);
            *key++ = steps[step][end - 1];
        });
    }
    auto index =
        geometry.buffer<std::uint32_t>(RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, keys - strands)
            .begin();
    // A segment of a spline starts with the key before it, a cone with its own.
    std::uint32_t first_of_strand = shape.kind == StrandShape::RoundLinear ? 1 : 0;
    for_strands([&](std::size_t first, std::size_t end) {
        for (std::uint32_t key = 0; key + first + 1 < end; ++key) {
            *index++ = first_of_strand + key;
        }
        first_of_strand += static_cast<std::uint32_t>(end - first) + 2;
    });
    set_filter(geometry.get(), ignore_left_strand);
    return {.geometry = geometry.release()};
}

EmbreeShape make(RTCDevice device, const BallsShape& shape)
{
    const auto& steps = shape.balls.steps;
    NewGeometry geometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT, steps.size());
    for (std::size_t step = 0; step < steps.size(); ++step) {
        std::ranges::copy(steps[step],
                          geometry
                              .buffer<SizedPoint>(RTC_BUFFER_TYPE_VERTEX, step, RTC_FORMAT_FLOAT4,
                                                  steps[step].size())
                              .begin());
    }
    set_filter(geometry.get(), ignore_back);
    return {.geometry = geometry.release()};
}

}  // namespace

EmbreeShape make_embree_shape(RTCDeviceTy* device, const Shape& shape)
{
    return std::visit([device](const auto& any) { return make(device, any); }, shape);
}

void set_embree_motion(RTCGeometryTy* instance, std::span<const M44d> world_from_object)
{
    rtcSetGeometryTimeStepCount(instance, static_cast<unsigned>(world_from_object.size()));
    Imath::Quatd last;
    for (unsigned step = 0; step < world_from_object.size(); ++step) {
        const M44d& m = world_from_object[step];
        const V3d x(m[0][0], m[0][1], m[0][2]);
        const V3d y(m[1][0], m[1][1], m[1][2]);
        const V3d z(m[2][0], m[2][1], m[2][2]);
        // Rotation times upper triangle (Gram & Schmidt); a mirror stays with the scale of z.
        const V3d rx = x.normalized();
        const V3d ry = (y - rx * rx.dot(y)).normalized();
        const V3d rz = rx.cross(ry);
        Imath::Quatd rotation = Imath::extractQuat(
            M44d(rx.x, rx.y, rx.z, 0, ry.x, ry.y, ry.z, 0, rz.x, rz.y, rz.z, 0, 0, 0, 0, 1));
        if (step > 0 && (rotation ^ last) < 0.0) {
            rotation = -rotation;  // the same one, and the short way from the last
        }
        last = rotation;
        RTCQuaternionDecomposition parts;
        rtcInitQuaternionDecomposition(&parts);
        const auto number = [](double value) { return static_cast<float>(value); };
        parts.scale_x = number(rx.dot(x));
        parts.skew_xy = number(rx.dot(y));
        parts.skew_xz = number(rx.dot(z));
        parts.scale_y = number(ry.dot(y));
        parts.skew_yz = number(ry.dot(z));
        parts.scale_z = number(rz.dot(z));
        rtcQuaternionDecompositionSetQuaternion(&parts, number(rotation.r), number(rotation.v.x),
                                                number(rotation.v.y), number(rotation.v.z));
        rtcQuaternionDecompositionSetTranslation(&parts, number(m[3][0]), number(m[3][1]),
                                                 number(m[3][2]));
        rtcSetGeometryTransformQuaternion(instance, step, &parts);
    }
}

}  // namespace eye_render
