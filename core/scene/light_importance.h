// What a light is worth to a point: the measure by which lights are chosen.

#pragma once

#include "scene/light_emitter.h"

namespace eye_render {

// The irradiance that the emitter can give the point at most, roughly: intensity over squared
// distance, with both orientations bounded as by Conty Estevez and Kulla 2018, "Importance
// Sampling of Many Lights with Adaptive Tree Splitting". `n_world` is unit, or zero where light
// counts from all sides. Not negative; not finite where the point or the emitter is not.
[[nodiscard]] float light_importance(const LightEmitter& emitter,
                                     const V3f& p_world,
                                     const V3f& n_world);

}  // namespace eye_render
