// The shapes of lamps, each with one function to sample it, one for the ray that meets it, and one
// density that both share. For lamp_query.cpp, which knows what kind a lamp is; what passes here
// may still be black.
//
// `to_lamp` goes from the lit point to the lamp's position; `wi` is unit, away from the point.

#pragma once

#include "scene/lamp.h"

namespace eye_render {

// Point and spot lamps, with a radius or without.
[[nodiscard]] std::optional<LampSample> sample_point_lamp(const Lamp& lamp,
                                                          const V3f& to_lamp,
                                                          const V2f& u);
[[nodiscard]] std::optional<LampHit> hit_point_lamp(const Lamp& lamp,
                                                    const V3f& to_lamp,
                                                    const V3f& wi);

[[nodiscard]] std::optional<LampSample> sample_area_lamp(const Lamp& lamp,
                                                         const V3f& to_lamp,
                                                         const V2f& u);
[[nodiscard]] std::optional<LampHit> hit_area_lamp(const Lamp& lamp,
                                                   const V3f& to_lamp,
                                                   const V3f& wi);

}  // namespace eye_render
