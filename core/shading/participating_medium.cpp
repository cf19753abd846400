#include "shading/participating_medium.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

// A lobe is drawn in proportion to the sum of its coefficients over the channels.
[[nodiscard]] float importance(const Color3f& scattering)
{
    return scattering.x + scattering.y + scattering.z;
}

}  // namespace

void ParticipatingMedium::scatter(const ScatteringLobe& lobe)
{
    if (!(max_component(lobe.scattering) > 0.0f)) {
        return;
    }
    scattering_ += lobe.scattering;
    for (std::size_t i = 0; i < lobe_count_; ++i) {
        if (lobes_[i].phase == lobe.phase || i + 1 == capacity) {
            lobes_[i].scattering += lobe.scattering;
            return;
        }
    }
    lobes_[lobe_count_++] = lobe;
}

void ParticipatingMedium::add(const ParticipatingMedium& other)
{
    extinction += other.extinction;
    emission += other.emission;
    for (const ScatteringLobe& lobe : other.lobes()) {
        scatter(lobe);
    }
}

void ParticipatingMedium::scale(float factor)
{
    extinction *= factor;
    emission *= factor;
    scattering_ *= factor;
    for (std::size_t i = 0; i < lobe_count_; ++i) {
        lobes_[i].scattering *= factor;
    }
}

Color3f ParticipatingMedium::transmittance(float distance) const
{
    Color3f left;
    for (int c = 0; c < 3; ++c) {
        // An infinite way through nothing loses nothing.
        left[c] = extinction[c] > 0.0f ? std::exp(-extinction[c] * distance) : 1.0f;
    }
    return left;
}

Color3f ParticipatingMedium::emitted(const Color3f& part, float distance) const
{
    Color3f sum(0.0f);
    for (int c = 0; c < 3; ++c) {
        if (!(part[c] > 0.0f)) {
            continue;  // not even along an infinite way
        }
        // Where next to nothing is taken, the quotient would be of two roundings.
        const float taken = -std::expm1(-extinction[c] * distance);
        sum[c] = part[c] *
                 (taken > std::numeric_limits<float>::min() ? taken / extinction[c] : distance);
    }
    return sum;
}

Color3f ParticipatingMedium::scattered(float one_minus_cos) const
{
    Color3f sum(0.0f);
    for (const ScatteringLobe& lobe : lobes()) {
        sum += lobe.scattering * phase_value(lobe.phase, one_minus_cos);
    }
    return sum;
}

float ParticipatingMedium::pdf(float one_minus_cos) const
{
    float sum = 0.0f;
    for (const ScatteringLobe& lobe : lobes()) {
        sum += importance(lobe.scattering) * phase_pdf(lobe.phase, one_minus_cos);
    }
    return sum / importance(scattering_);
}

PhaseSample ParticipatingMedium::sample(const V3f& direction, float u_lobe, const V2f& u) const
{
    float left = u_lobe * importance(scattering_);
    std::size_t chosen = 0;
    while (chosen + 1 < lobe_count_ && left >= importance(lobes_[chosen].scattering)) {
        left -= importance(lobes_[chosen++].scattering);
    }
    const V3f onward = sample_phase(lobes_[chosen].phase, direction, u);
    const float turned = one_minus_cosine(direction, onward);
    return {onward, scattered(turned), pdf(turned)};
}

}  // namespace eye_render
