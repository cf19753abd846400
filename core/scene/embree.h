// Embree 3 and 4 behind one spelling. Only accelerator*.cpp include this file, and no other file
// of the project includes Embree.

#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace eye_render::embree {

#if RTC_VERSION_MAJOR >= 4

inline void intersect(RTCScene scene, RTCRayHit& ray_hit) { rtcIntersect1(scene, &ray_hit); }

inline void occluded(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, &ray); }

#else

inline void intersect(RTCScene scene, RTCRayHit& ray_hit)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray_hit);
}

inline void occluded(RTCScene scene, RTCRay& ray)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
}

#endif

}  // namespace eye_render::embree
