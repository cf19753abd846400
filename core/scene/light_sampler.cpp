#include "scene/light_sampler.h"

#include "scene/environment.h"
#include "scene/light_importance.h"

#include <Imath/ImathBox.h>

#include <algorithm>
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
                    .first = static_cast<std::uint32_t>(members_.size()),
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
    add_members(emitters);
    clusters_.push_back(cluster);
}

void LightSampler::add_members(std::span<const LightEmitter> emitters)
{
    std::vector<double> intensities;
    intensities.reserve(emitters.size());
    for (const LightEmitter& e : emitters) {
        intensities.push_back(static_cast<double>(e.intensity));
        places_[place_index(e.kind, e.index)] = {
            .cluster = static_cast<std::uint32_t>(clusters_.size()),
            .member = static_cast<std::uint32_t>(members_.size())};
        members_.push_back({e.kind, e.index});
    }
    const std::vector<AliasColumn> table = make_alias_table(intensities);
    columns_.insert(columns_.end(), table.begin(), table.end());
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
        result[i] = light_importance(clusters_[i].bounds, p_world, n_world);
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

std::optional<LightChoice> LightSampler::choose(const LitPoint& point, double u) const
{
    if (clusters_.empty()) {
        return std::nullopt;
    }
    const auto probability_of = [&point](std::size_t i) {
        return static_cast<double>(point.probabilities_[i]);
    };
    std::size_t i = 0;
    double left = 1.0;  // probability of this cluster and those after it
    while (i + 1 < clusters_.size() && u >= probability_of(i)) {
        u -= probability_of(i);
        left -= probability_of(i++);
    }
    // The last one takes what is left: by the rounding of all probabilities it would lose some of
    // its members.
    const double width = i + 1 < clusters_.size() ? probability_of(i) : left;
    const Cluster& cluster = clusters_[i];
    const std::span<const AliasColumn> table(&columns_[cluster.first], cluster.count);
    const std::uint32_t chosen = choose_from(table, u / width);
    const Member& member = members_[cluster.first + chosen];
    return LightChoice{member.kind, member.light,
                       point.probabilities_[i] * table[chosen].probability};
}

float LightSampler::probability(LightKind kind, std::uint32_t index, const LitPoint& point) const
{
    const Place place = places_.empty() ? Place{} : places_[place_index(kind, index)];
    if (place.cluster == Place::nowhere) {
        return 0.0f;
    }
    return point.probabilities_[place.cluster] * columns_[place.member].probability;
}

}  // namespace eye_render
