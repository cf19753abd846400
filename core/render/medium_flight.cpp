#include "render/medium_flight.h"

#include "render/free_flight.h"

#include <algorithm>

namespace eye_render {

namespace {

// Of a channel that a medium only absorbs from, against one that it scatters: collisions are drawn
// for what is scattered, but what is left of the other must not grow beyond a few times its share.
constexpr float absorbed_importance = 0.1f;

[[nodiscard]] Color3f importance_of(const ParticipatingMedium& medium)
{
    Color3f importance(absorbed_importance);
    for (int c = 0; c < 3; ++c) {
        if (medium.extinction[c] > 0.0f) {
            importance[c] = std::max(importance[c], medium.scattering()[c] / medium.extinction[c]);
        }
    }
    return importance;
}

}  // namespace

MediumFlight sample_flight(const MediumSegment& segment,
                           const Color3f& throughput,
                           SampleSequence& sequence)
{
    const ParticipatingMedium& medium = segment.media.mixture();
    const FreeFlight flight(medium.extinction, throughput * importance_of(medium), segment.length);
    const auto u = sequence.next();
    const float distance = flight.sample(u[2], u[3]);
    if (!(distance < segment.length)) {
        return {medium.transmittance(segment.length) / flight.survival(segment.length),
                std::nullopt};
    }
    const auto v = sequence.next();
    const PhaseSample sample = medium.sample(segment.direction, v[2], V2f(v[0], v[1]));
    return {medium.transmittance(distance) * sample.value / (flight.pdf(distance) * sample.pdf),
            Collision{.p_world = segment.origin + segment.direction * distance,
                      .direction = sample.direction,
                      .pdf = sample.pdf}};
}

}  // namespace eye_render
