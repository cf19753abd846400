// Shapes as Embree takes them. Only accelerator*.cpp include this file.

#pragma once

#include "scene/accelerator.h"

struct RTCGeometryTy;

namespace eye_render {

struct EmbreeShape {
    RTCGeometryTy* geometry;       // not committed; the caller releases it
    MotionSteps<V3f> positions{};  // of triangles: Embree's copy, padded for its vector loads
};

// Throws std::runtime_error when there is no memory.
[[nodiscard]] EmbreeShape make_embree_shape(RTCDeviceTy* device, const Shape& shape);

// Sets the places of an instance at the times of motion.h.
void set_embree_motion(RTCGeometryTy* instance, std::span<const M44d> world_from_object);

}  // namespace eye_render
