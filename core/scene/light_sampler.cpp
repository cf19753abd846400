#include "scene/light_sampler.h"

#include "scene/environment.h"

#include <Imath/ImathBox.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

// As many as a shading point can weigh one by one in well under a microsecond.
constexpr std::size_t max_lamp_clusters = 32;
constexpr std::size_t max_sun_clusters = 8;
constexpr std::size_t max_triangle_clusters = 16;

// Shared out evenly among the clusters. The bounds leave out nothing that the given normal lets
// through, so this is for what they cannot know, such as a normal map.
constexpr float even_share = 0.04f;

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

// The irradiance that the emitter can give the point at most, roughly.
float importance(const LightEmitter& emitter, const V3f& p_world, const V3f& n_world)
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

}  // namespace

LightSampler::LightSampler(std::span<const Lamp> lamps,
                           std::span<const EmissiveTriangle> triangles,
                           const Environment& environment)
    : lamp_count_(lamps.size()), places_(1 + lamps.size() + triangles.size())
{
    std::vector<LightEmitter> local;
    std::vector<LightEmitter> suns;
    std::vector<LightEmitter> emissive;
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        const LightEmitter e = emitter_of(lamps[i], static_cast<std::uint32_t>(i));
        if (e.intensity > 0.0f) {
            (e.is_distant ? suns : local).push_back(e);
        }
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const LightEmitter e = emitter_of(triangles[i], static_cast<std::uint32_t>(i));
        if (e.intensity > 0.0f) {
            emissive.push_back(e);
        }
    }
    static_assert(max_lamp_clusters + max_sun_clusters + max_triangle_clusters + 1 <=
                  LitPoint::max_clusters);
    add_clusters(local, max_lamp_clusters);
    add_clusters(suns, max_sun_clusters);
    add_clusters(emissive, max_triangle_clusters);
    if (!environment.is_black()) {
        const LightEmitter e = emitter_of(environment);
        add_cluster({&e, 1});
    }
}

// One cluster each if there are enough; else in two halves of space, and each half again.
void LightSampler::add_clusters(std::span<LightEmitter> emitters, std::size_t max_count)
{
    if (emitters.size() <= max_count) {
        for (const LightEmitter& e : emitters) {
            add_cluster({&e, 1});
        }
        return;
    }
    Imath::Box3f centers;
    for (const LightEmitter& e : emitters) {
        centers.extendBy(e.center_world);
    }
    const int axis = static_cast<int>(centers.majorAxis());
    const float middle = centers.center()[axis];
    const auto split = std::partition(emitters.begin(), emitters.end(), [&](const auto& e) {
        return e.center_world[axis] < middle;
    });
    if (max_count == 1 || split == emitters.begin() || split == emitters.end()) {
        add_cluster(emitters);
        return;
    }
    const std::span<LightEmitter> low(emitters.begin(), split);
    const std::span<LightEmitter> high(split, emitters.end());
    const std::size_t half = max_count / 2;
    const std::size_t low_count =
        high.size() < max_count - half ? max_count - high.size() : std::min(half, low.size());
    add_clusters(low, low_count);
    add_clusters(high, max_count - low_count);
}

void LightSampler::add_cluster(std::span<const LightEmitter> emitters)
{
    Cluster cluster{.bounds = emitters[0],
                    .first = static_cast<std::uint32_t>(entries_.size()),
                    .count = static_cast<std::uint32_t>(emitters.size())};
    if (emitters.size() > 1) {
        Imath::Box3f box;
        float intensity = 0.0f;
        for (const LightEmitter& e : emitters) {
            box.extendBy(e.center_world - V3f(e.radius));
            box.extendBy(e.center_world + V3f(e.radius));
            intensity += e.intensity;
        }
        cluster.bounds = {.center_world = box.center(),
                          .radius = 0.5f * box.size().length(),
                          .intensity = intensity,
                          .is_distant = emitters[0].is_distant};
    }
    add_entries(emitters);
    clusters_.push_back(cluster);
}

// Vose's alias method: columns of equal width, each shared by at most two members.
void LightSampler::add_entries(std::span<const LightEmitter> emitters)
{
    const std::size_t first = entries_.size();
    double total = 0.0;
    for (const LightEmitter& e : emitters) {
        total += static_cast<double>(e.intensity);
    }
    std::vector<double> scaled;
    std::vector<std::size_t> small;
    std::vector<std::size_t> large;
    for (std::size_t i = 0; i < emitters.size(); ++i) {
        const LightEmitter& e = emitters[i];
        const double probability = static_cast<double>(e.intensity) / total;
        scaled.push_back(probability * static_cast<double>(emitters.size()));
        (scaled[i] < 1.0 ? small : large).push_back(i);
        const auto entry = static_cast<std::uint32_t>(first + i);
        places_[place_index(e.kind, e.index)] = {static_cast<std::uint32_t>(clusters_.size()),
                                                 entry};
        entries_.push_back({.kind = e.kind,
                            .light = e.index,
                            .alias = entry,
                            .probability = static_cast<float>(probability)});
    }
    while (!small.empty() && !large.empty()) {
        const std::size_t receiver = small.back();
        const std::size_t donor = large.back();
        small.pop_back();
        entries_[first + receiver].keep = static_cast<float>(scaled[receiver]);
        entries_[first + receiver].alias = static_cast<std::uint32_t>(first + donor);
        scaled[donor] -= 1.0 - scaled[receiver];
        if (scaled[donor] < 1.0) {
            large.pop_back();
            small.push_back(donor);
        }
    }
}

std::size_t LightSampler::place_index(LightKind kind, std::uint32_t index) const
{
    switch (kind) {
    case LightKind::Environment: break;
    case LightKind::Lamp: return 1 + index;
    case LightKind::Triangle: return 1 + lamp_count_ + index;
    }
    return 0;
}

void LightSampler::weigh(const V3f& p_world, const V3f& n_world, LitPoint& point) const
{
    point.p_world = p_world;
    auto& result = point.probabilities_;
    const std::size_t count = clusters_.size();
    float sum = 0.0f;
    for (std::size_t i = 0; i < count; ++i) {
        result[i] = importance(clusters_[i].bounds, p_world, n_world);
        sum += result[i];
    }
    const float even = 1.0f / static_cast<float>(count);
    // Nothing or too much to count: NaN and infinity fall here too.
    if (!(sum > 0.0f && sum <= std::numeric_limits<float>::max())) {
        std::fill_n(result.begin(), count, even);
        return;
    }
    const float scale = (1.0f - even_share) / sum;
    for (std::size_t i = 0; i < count; ++i) {
        result[i] = result[i] * scale + even_share * even;
    }
}

std::optional<LightChoice> LightSampler::choose(const LitPoint& point, float u) const
{
    if (clusters_.empty()) {
        return std::nullopt;
    }
    const auto& probabilities = point.probabilities_;
    std::size_t i = 0;
    while (i + 1 < clusters_.size() && u >= probabilities[i]) {
        u -= probabilities[i++];
    }
    const Cluster& cluster = clusters_[i];
    const auto count = static_cast<float>(cluster.count);
    const float column = std::clamp(u / probabilities[i], 0.0f, 1.0f) * count;
    const std::uint32_t offset = std::min(static_cast<std::uint32_t>(column), cluster.count - 1);
    const Entry* entry = &entries_[cluster.first + offset];
    if (column - static_cast<float>(offset) >= entry->keep) {
        entry = &entries_[entry->alias];
    }
    return LightChoice{entry->kind, entry->light, probabilities[i] * entry->probability};
}

float LightSampler::probability(LightKind kind, std::uint32_t index, const LitPoint& point) const
{
    const Place place = places_.empty() ? Place{} : places_[place_index(kind, index)];
    if (place.cluster == Place::nowhere) {
        return 0.0f;
    }
    return point.probabilities_[place.cluster] * entries_[place.entry].probability;
}

}  // namespace eye_render
