// A participating medium that is the same everywhere: what it takes from light, scatters and
// shines, per unit length of the scene. Overlapping media add up.

#pragma once

#include "base/vector.h"
#include "shading/phase_function.h"

#include <array>
#include <optional>
#include <span>

namespace eye_render {

// A part of the scattered light, and where it goes.
struct ScatteringLobe {
    Color3f scattering{0.0f};  // coefficient, per unit length
    PhaseFunction phase;
};

struct PhaseSample {
    V3f direction;  // of travel
    Color3f value;  // scattered per unit length and solid angle
    float pdf = 0.0f;
};

class ParticipatingMedium {
public:
    // Not negative, per unit length: absorbed or scattered; emitted radiance.
    Color3f extinction{0.0f};
    Color3f emission{0.0f};

    void scatter(const ScatteringLobe& lobe);
    void add(const ParticipatingMedium& other);
    // A part of it, for means.
    void scale(float factor);

    [[nodiscard]] const Color3f& scattering() const { return scattering_; }
    [[nodiscard]] bool is_scattering() const { return lobe_count_ > 0; }

    // What is left of light after so far; the distance may be infinite.
    [[nodiscard]] Color3f transmittance(float distance) const;
    // Radiance that a part of it, of this emission, sends back along a ray of that length, less
    // what all of it takes.
    [[nodiscard]] Color3f emitted(const Color3f& part, float distance) const;

    // Of light that goes on at an angle of that 1 - cos to its direction of travel: what is
    // scattered per unit length and solid angle, and the density of `sample` there.
    [[nodiscard]] Color3f scattered(float one_minus_cos) const;
    [[nodiscard]] float pdf(float one_minus_cos) const;
    // u_lobe and both of u in [0, 1). Only of a medium that scatters.
    [[nodiscard]] PhaseSample sample(const V3f& direction, float u_lobe, const V2f& u) const;

private:
    // Lobes of the same phase function are one; what more comes is scattered as the last.
    static constexpr std::size_t capacity = 8;

    [[nodiscard]] std::span<const ScatteringLobe> lobes() const
    {
        return {lobes_.data(), lobe_count_};
    }

    Color3f scattering_{0.0f};
    std::size_t lobe_count_ = 0;
    std::array<ScatteringLobe, capacity> lobes_{};
};

}  // namespace eye_render
