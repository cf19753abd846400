#include "scene/light_importance.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

// Keeps the importance finite at a lamp's very centre.
constexpr float smallest_distance2 = 1e-12f;

// An angle known as its cosine and sine.
struct Angle {
    float cosine = 1.0f;
    float sine = 0.0f;
};

// cos(a - b), or 1 where b exceeds a: the best that the angle a can be if known to within b.
float cos_within(float cos_a, const Angle& b)
{
    if (cos_a >= b.cosine) {
        return 1.0f;
    }
    const float sin_a = std::sqrt(std::max(0.0f, 1.0f - cos_a * cos_a));
    return cos_a * b.cosine + sin_a * b.sine;
}

float distant_importance(const LightEmitter& emitter, const V3f& n_world)
{
    if (emitter.axis == V3f(0.0f) || n_world == V3f(0.0f)) {
        return emitter.intensity;
    }
    const float cosine = emitter.cos_edge;
    const Angle half{cosine, std::sqrt(std::max(0.0f, 1.0f - cosine * cosine))};
    return emitter.intensity * std::max(0.0f, cos_within(-emitter.axis.dot(n_world), half));
}

}  // namespace

float light_importance(const LightEmitter& emitter, const V3f& p_world, const V3f& n_world)
{
    if (emitter.is_distant) {
        return distant_importance(emitter, n_world);
    }
    const V3f to_emitter = emitter.center_world - p_world;
    const float distance2 = std::max(to_emitter.length2(), smallest_distance2);
    const float radius2 = emitter.radius * emitter.radius;
    if (distance2 <= radius2) {
        return emitter.intensity / radius2;  // in its midst: as from its rim
    }
    const float inverse_distance = 1.0f / std::sqrt(distance2);
    const float sine = emitter.radius * inverse_distance;
    const Angle seen_radius{std::sqrt(1.0f - sine * sine), sine};
    const V3f wi = to_emitter * inverse_distance;
    float result = emitter.intensity * inverse_distance * inverse_distance;
    if (n_world != V3f(0.0f)) {
        result *= std::max(0.0f, cos_within(wi.dot(n_world), seen_radius));
    }
    if (emitter.axis != V3f(0.0f)) {
        const float cosine = cos_within(-wi.dot(emitter.axis), seen_radius);
        if (cosine < emitter.cos_edge) {
            return 0.0f;
        }
        if (emitter.is_lambertian) {
            result *= std::max(0.0f, cosine);
        }
    }
    return result;
}

}  // namespace eye_render
