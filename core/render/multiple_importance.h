// Light found in two ways, by rays that a BSDF sends and by aiming at lights, and how the two are
// weighed (Veach 1997, 9.2). Densities are per unit solid angle.

#pragma once

#include "scene/scene.h"

#include <array>
#include <utility>

namespace eye_render {

[[nodiscard]] inline float power_heuristic(float pdf, float other_pdf)
{
    // As a ratio, so that squares of large densities (the sun's is 1e5) cannot overflow.
    if (!(pdf > 0.0f)) {
        return 0.0f;
    }
    const float ratio = other_pdf / pdf;
    return 1.0f / (1.0f + ratio * ratio);
}

// The last place where the path was scattered, and how.
struct Scattering {
    LitPoint point;  // weighed unless is_delta
    float pdf = 0.0f;
    bool is_delta = true;  // the camera counts as one: no light sampling competes with its ray

    // Of light that the ray from here found and light sampling finds with `light_pdf`.
    [[nodiscard]] float weight_against(float light_pdf) const
    {
        return is_delta ? 1.0f : power_heuristic(pdf, light_pdf);
    }
};

// The last scattering of a path, and room to weigh the lights for the next one.
class LastScattering {
public:
    LastScattering() = default;
    LastScattering(const LastScattering&) = delete;
    LastScattering& operator=(const LastScattering&) = delete;

    const Scattering* operator->() const { return last_; }

    // The camera's own place, where no light sampling competes with rays, and the path's time.
    void start(const V3f& p_world, float time)
    {
        last_->point.p_world = p_world;
        last_->point.time = next_->point.time = time;
    }
    // Where lights are to be weighed for the place that the path has come to.
    [[nodiscard]] LitPoint& next_point() { return next_->point; }
    // The path goes on from there. If not `is_delta`, the lights were weighed.
    void move_on(const V3f& p_world, float pdf, bool is_delta)
    {
        std::swap(last_, next_);
        last_->point.p_world = p_world;
        last_->pdf = pdf;
        last_->is_delta = is_delta;
    }

private:
    std::array<Scattering, 2> scatterings_;
    Scattering* last_ = scatterings_.data();
    Scattering* next_ = scatterings_.data() + 1;
};

}  // namespace eye_render
