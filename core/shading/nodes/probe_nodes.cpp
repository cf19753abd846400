// Nodes that look around from the hit: Ambient Occlusion and Bevel. Without a probe nothing is in
// the way and nothing is bent.

#include "base/error.h"
#include "base/sobol.h"
#include "base/warp.h"
#include "shading/bevel_kernel.h"
#include "shading/frame.h"
#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"
#include "shading/nodes/sockets.h"

#include <array>
#include <cmath>
#include <functional>

namespace eye_render {

namespace {

using enum SocketType;

// Of the sample sequence at a hit, so that two nodes of one program do not look the same ways.
enum Group : std::uint32_t { OcclusionGroup, BevelGroup };

[[nodiscard]] int sample_count(const NodeOptions& options, int otherwise)
{
    const double samples = options.number("samples", otherwise);
    require_range("samples", samples, 0, 1024, "");
    return static_cast<int>(samples);
}

// The share of a cosine-weighted hemisphere that nothing near stands in.
class OcclusionNode final : public ValueNode {
public:
    enum Input : std::size_t { Tint, Distance, Normal };
    enum Output : std::size_t { Tinted, Openness };

    explicit OcclusionNode(const NodeOptions& options)
        : samples_(sample_count(options, 16)), inside_(options.is_set("inside", false)),
          only_local_(options.is_set("only_local", false))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const SurfaceProbe* probe = in.hit().probe;
        const float distance = in.number(Distance);
        const bool looks = probe != nullptr && samples_ > 0 && distance > 0.0f;
        const float open = looks ? openness(*probe, in.vector(Normal), distance) : 1.0f;
        out[Openness] = NodeValue(open);
        if (in.wants(Tinted)) {
            out[Tinted] = in.color(Tint) * open;
        }
    }

private:
    [[nodiscard]] float openness(const SurfaceProbe& probe, const V3f& n, float distance) const
    {
        const Frame frame(inside_ ? -n : n);
        int open = 0;
        for (int i = 0; i < samples_; ++i) {
            const auto u = sobol_4d(probe.seed(), static_cast<std::uint32_t>(i), OcclusionGroup);
            const V3f direction = frame.world_from_local(sample_cosine_hemisphere({u[0], u[1]}));
            open += probe.is_blocked(direction, distance, only_local_) ? 0 : 1;
        }
        return static_cast<float>(open) / static_cast<float>(samples_);
    }

    int samples_;
    bool inside_;
    bool only_local_;
};

// The mean normal of the object's own surfaces around the hit.
class BevelNode final : public ValueNode {
public:
    enum Input : std::size_t { Radius, Normal };

    explicit BevelNode(const NodeOptions& options) : samples_(sample_count(options, 4)) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const Hit& hit = in.hit();
        const V3f& own = hit.point.ns;
        const V3f normal = in.vector(Normal);
        const float radius = in.number(Radius);
        // Light that is blurred anyway shows no rounded edge.
        constexpr float blurry_pdf = 8.0f;
        if (hit.probe == nullptr || samples_ == 0 || !(radius > 0.0f) ||
            hit.path.smallest_pdf < blurry_pdf) {
            out[0] = normal;
            return;
        }
        const V3f mean = mean_normal(*hit.probe, hit.point, radius);
        out[0] = unit_or(normal + (mean - own), normal);
    }

private:
    [[nodiscard]] V3f mean_normal(const SurfaceProbe& probe,
                                  const ShadingPoint& point,
                                  float radius) const
    {
        V3f sum(0.0f);
        for (int i = 0; i < samples_; ++i) {
            const auto u = sobol_4d(probe.seed(), static_cast<std::uint32_t>(i), BevelGroup);
            const BevelRay bevel = sample_bevel_ray(point.ng, radius, u[0], {u[1], u[2]});
            const DiskRay& ray = bevel.ray;
            const auto visit = [&](const SurfaceProbe::Crossing& crossing) {
                sum += crossing.ns *
                       bevel_weight(bevel, radius, crossing.ng, crossing.from_hit.length());
            };
            // By reference: what it captures is more than std::function holds without the heap.
            probe.cross_own_object(ray.start, ray.direction, ray.length, std::ref(visit));
        }
        return unit_or(point.backfacing ? -sum : sum, point.ns);
    }

    int samples_;
};

constexpr std::array occlusion_in{color_input("Color", 1.0f), number_input("Distance", 1.0f),
                                  normal_input()};
constexpr std::array occlusion_out{OutputSocket{"Color", Color}, OutputSocket{"AO", Number}};
constexpr std::array<std::string_view, 3> occlusion_options{"samples", "inside", "only_local"};
constexpr std::array bevel_in{number_input("Radius", 0.05f), normal_input()};
constexpr std::array bevel_out{OutputSocket{"Normal", Vector}};
constexpr std::array<std::string_view, 1> bevel_options{"samples"};

}  // namespace

std::span<const NodeType> probe_nodes()
{
    static const std::array nodes{
        value_node("AMBIENT_OCCLUSION", Reads::Hit, occlusion_in, occlusion_out,
                   make_from_options<OcclusionNode>, occlusion_options),
        value_node("BEVEL", Reads::Hit, bevel_in, bevel_out, make_from_options<BevelNode>,
                   bevel_options),
    };
    return nodes;
}

}  // namespace eye_render
