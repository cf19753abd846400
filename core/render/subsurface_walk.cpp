#include "render/subsurface_walk.h"

#include "render/dwivedi_guide.h"
#include "render/free_flight.h"
#include "scene/scene_probe.h"
#include "shading/frame.h"
#include "shading/phase_function.h"
#include "shading/subsurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

// As in Cycles: walks that go on longer, or of which less is left, are given up.
constexpr int most_flights = 256;
constexpr float nothing_left = 1e-6f;

// Flights after which light has forgotten where it came from, so that an even medium does: as in
// Cycles.
constexpr int exact_flights = 10;

// Within which the other side of a thin thing is looked for, in the longest mean free paths.
constexpr float thin = 10.0f;

// How many directions are guided: fewer where the phase function is narrow, which the guide knows
// nothing of. Cycles' choice.
[[nodiscard]] float guided_share(float anisotropy)
{
    return 1.0f - std::max(0.5f, std::pow(std::abs(anisotropy), 0.125f));
}

// Where the path flies from a collision, and how that could have been drawn.
struct Departure {
    enum Way : std::size_t {
        Scattered,  // by the phase function
        Outwards,   // guided to the surface that the path entered by
        Inwards,    // guided to the other side
    };

    V3f direction;
    Way way = Scattered;
    // Of each way: the density of the direction, its share included, over the phase function's;
    // and the factor of the extinction by which its flights are drawn.
    std::array<float, 3> densities{1.0f, 0.0f, 0.0f};
    std::array<float, 3> extinction_factors{1.0f, 1.0f, 1.0f};
};

class Walk {
public:
    Walk(const Scene& scene,
         const SurfaceHit& entry,
         const SubsurfaceMedium& medium,
         const Color3f& throughput,
         SampleSequence& sequence)
        : scene_(scene), entry_(entry), medium_(medium), throughput_(throughput * medium.entering),
          sequence_(sequence), guide_(max_component(medium.albedo)),
          longest_free_path_(1.0f / min_component(medium.extinction)), p_world_(entry.p_world)
    {
    }

    std::optional<SubsurfaceExit> run(const V3f& direction)
    {
        Departure departure{.direction = direction};
        for (int flight = 0; flight < most_flights; ++flight) {
            if (!(max_component(throughput_) > nothing_left)) {
                break;
            }
            if (flight == exact_flights) {
                medium_ = even_medium(medium_);
            }
            if (flight > 0) {
                departure = depart(departure.direction);
            }
            if (auto exit = fly(departure, flight == 0)) {
                return SubsurfaceExit{*exit, throughput_};
            }
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] static float min_component(const Color3f& c)
    {
        return std::min(c.x, std::min(c.y, c.z));
    }
    [[nodiscard]] float depth_of(const V3f& p_world) const
    {
        return (entry_.p_world - p_world).dot(entry_.point.ns);
    }

    [[nodiscard]] Departure depart(const V3f& arriving);
    // Of guided directions, how many lead to the other side.
    [[nodiscard]] float inwards_share() const;
    // To the surface, or else to the next collision.
    [[nodiscard]] std::optional<SurfaceHit> fly(const Departure& departure, bool is_first);
    [[nodiscard]] std::optional<SurfaceHit> meet(const V3f& direction,
                                                 float distance,
                                                 bool is_first);

    const Scene& scene_;
    const SurfaceHit& entry_;
    SubsurfaceMedium medium_;
    Color3f throughput_;
    SampleSequence& sequence_;
    DwivediGuide guide_;
    float longest_free_path_;
    V3f p_world_;
    std::optional<float> thickness_;  // of a thin thing
};

float Walk::inwards_share() const
{
    if (!thickness_) {
        return 0.0f;
    }
    const float depth = std::clamp(depth_of(p_world_), 0.0f, *thickness_);
    const float diffusion_length = guide_.diffusion_length() * longest_free_path_;
    return 1.0f / (1.0f + std::exp((*thickness_ - 2.0f * depth) / diffusion_length));
}

Departure Walk::depart(const V3f& arriving)
{
    const PhaseFunction phase{.g = medium_.anisotropy};
    const V3f& normal = entry_.point.ns;
    const float guided = guided_share(medium_.anisotropy);
    const float inwards = inwards_share();
    const auto u = sequence_.next();

    Departure departure;
    if (u[2] >= guided) {
        departure.direction = sample_phase(phase, arriving, V2f(u[0], u[1]));
    } else {
        departure.way = u[2] < guided * inwards ? Departure::Inwards : Departure::Outwards;
        departure.direction =
            guide_.sample(departure.way == Departure::Inwards ? -normal : normal, V2f(u[0], u[1]));
    }
    const float cosine = departure.direction.dot(normal);
    const float guided_over_phase =
        guided / phase_pdf(phase, one_minus_cosine(arriving, departure.direction));
    departure.densities = {1.0f - guided,
                           guided_over_phase * (1.0f - inwards) * guide_.pdf(cosine),
                           guided_over_phase * inwards * guide_.pdf(-cosine)};
    departure.extinction_factors = {1.0f, guide_.extinction_factor(cosine),
                                    guide_.extinction_factor(-cosine)};
    return departure;
}

std::optional<SurfaceHit> Walk::fly(const Departure& departure, bool is_first)
{
    const Color3f importance = throughput_ * medium_.albedo;
    const auto flight_by = [&](std::size_t way) {
        return FreeFlight(medium_.extinction * departure.extinction_factors[way], importance,
                          std::numeric_limits<float>::infinity());
    };
    const auto u = sequence_.next();
    float distance = flight_by(departure.way).sample(u[0], u[1]);
    auto exit = meet(departure.direction, distance, is_first);
    if (exit) {
        distance = exit->t;
    }
    float pdf = 0.0f;
    for (std::size_t way = 0; way < departure.densities.size(); ++way) {
        if (departure.densities[way] > 0.0f) {
            const FreeFlight flight = flight_by(way);
            pdf += departure.densities[way] *
                   (exit ? flight.survival(distance) : flight.pdf(distance));
        }
    }
    const Color3f collided = exit ? Color3f(1.0f) : Color3f(medium_.extinction * medium_.albedo);
    for (int c = 0; c < 3; ++c) {
        throughput_[c] *= collided[c] * std::exp(-medium_.extinction[c] * distance) / pdf;
    }
    p_world_ += departure.direction * distance;
    return exit;
}

std::optional<SurfaceHit> Walk::meet(const V3f& direction, float distance, bool is_first)
{
    Ray ray{.origin = p_world_, .direction = direction, .t_max = distance, .time = entry_.time};
    if (!is_first) {
        return intersect_object(scene_, ray, *entry_.placement);
    }
    ray.t_max = std::max(distance, thin * longest_free_path_);
    auto hit = intersect_object(scene_, ray, *entry_.placement, entry_.primitive);
    if (!hit) {
        return std::nullopt;
    }
    thickness_ = std::max(0.0f, depth_of(hit->p_world));
    return hit->t < distance ? hit : std::nullopt;
}

}  // namespace

std::optional<SubsurfaceExit> walk_below(const Scene& scene,
                                         const SurfaceHit& entry,
                                         const Lobe& lobe,
                                         const Color3f& throughput,
                                         SampleSequence& sequence)
{
    SubsurfaceMedium medium = subsurface_medium(lobe);
    // Light that goes less far than the surface's own place is uncertain could not find it again.
    const float most_extinction = 1.0f / entry.p_error;
    bool is_seen = false;
    for (int c = 0; c < 3; ++c) {
        is_seen = is_seen || (throughput[c] > 0.0f && medium.extinction[c] < most_extinction);
        medium.extinction[c] = std::min(medium.extinction[c], most_extinction);
    }
    if (!is_seen) {
        return SubsurfaceExit{entry, throughput};
    }
    const auto u = sequence.next();
    V3f direction = sample_entry(lobe, entry.point.wo, u[2], V2f(u[0], u[1]));
    // What a facet sends up is let in by the next one.
    const float up = entry.point.ng.dot(direction);
    if (up > 0.0f) {
        direction -= entry.point.ng * (2.0f * up);
    }
    auto exit = Walk(scene, entry, medium, throughput, sequence).run(direction);
    if (exit) {
        exit->hit.turn_over();
    }
    return exit;
}

}  // namespace eye_render
