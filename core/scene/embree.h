// Embree 3 and 4 behind one spelling. Only accelerator*.cpp include this file, and no other file
// of the project includes Embree.

#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "scene/ray.h"

namespace eye_render::embree {

#if RTC_VERSION_MAJOR >= 4
using Context = RTCRayQueryContext;
#else
using Context = RTCIntersectContext;
#endif

// What filter functions are told of the ray.
struct Query {
    Context context{};  // Embree gives back a pointer to this
    StrandSegments left;

    explicit Query(const StrandSegments& left_by_ray) : left(left_by_ray)
    {
#if RTC_VERSION_MAJOR >= 4
        rtcInitRayQueryContext(&context);
#else
        rtcInitIntersectContext(&context);
#endif
    }

    [[nodiscard]] static const Query& of(const RTCFilterFunctionNArguments& arguments)
    {
        return *reinterpret_cast<const Query*>(arguments.context);
    }
};

#if RTC_VERSION_MAJOR >= 4

inline void intersect(RTCScene scene, Query& query, RTCRayHit& ray_hit)
{
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &query.context;
    rtcIntersect1(scene, &ray_hit, &arguments);
}

inline void occluded(RTCScene scene, Query& query, RTCRay& ray)
{
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &query.context;
    rtcOccluded1(scene, &ray, &arguments);
}

#else

inline void intersect(RTCScene scene, Query& query, RTCRayHit& ray_hit)
{
    rtcIntersect1(scene, &query.context, &ray_hit);
}

inline void occluded(RTCScene scene, Query& query, RTCRay& ray)
{
    rtcOccluded1(scene, &query.context, &ray);
}

#endif

}  // namespace eye_render::embree
