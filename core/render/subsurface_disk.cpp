#include "render/subsurface_disk.h"

#include "shading/burley_profile.h"
#include "shading/disk_ray.h"
#include "shading/subsurface.h"

#include <array>
#include <functional>

namespace eye_render {

namespace {

// The profiles of the channels that enter, each drawn from as often as the others.
class Profiles {
public:
    explicit Profiles(const Lobe& lobe)
    {
        for (int c = 0; c < 3; ++c) {
            if (lobe.weight[c] > 0.0f) {
                scale_[c] = lobe.edge[c] * mean_free_path_of_radius;
                channels_[count_++] = c;
            }
        }
    }

    struct Drawn {
        float distance = 0.0f;
        float cutoff = 0.0f;
    };
    [[nodiscard]] Drawn sample(float u_channel, float u) const
    {
        const auto nth = static_cast<std::size_t>(u_channel * static_cast<float>(count_));
        const float scale = scale_[channels_[nth]];
        return {sample_burley_distance(scale, u), burley_cutoff * scale};
    }
    [[nodiscard]] Color3f value(float distance) const
    {
        Color3f value(0.0f);
        for (std::size_t i = 0; i < count_; ++i) {
            value[channels_[i]] = burley_pdf(scale_[channels_[i]], distance);
        }
        return value;
    }
    [[nodiscard]] float pdf(float distance) const
    {
        const Color3f sum = value(distance);
        return (sum.x + sum.y + sum.z) / static_cast<float>(count_);
    }

private:
    Color3f scale_{0.0f};
    std::array<int, 3> channels_{};
    std::size_t count_ = 0;  // at least one: lobes have a weight
};

// One of the exits, drawn in proportion to what they count as they come (Chao 1982, "A general
// purpose unequal probability sampling plan").
class Reservoir {
public:
    explicit Reservoir(float u) : u_(u) {}

    void offer(const SurfaceHit& hit, const Color3f& weight)
    {
        const float mean = (weight.x + weight.y + weight.z) / 3.0f;
        if (!(mean > 0.0f)) {
            return;
        }
        sum_ += mean;
        const float share = mean / sum_;
        if (u_ < share) {
            u_ /= share;
            hit_ = hit;
            weight_ = weight / mean;
        } else {
            u_ = (u_ - share) / (1.0f - share);
        }
    }

    [[nodiscard]] const std::optional<SurfaceHit>& hit() const { return hit_; }
    // What was drawn counts, over its probability.
    [[nodiscard]] Color3f weight() const { return weight_ * sum_; }

private:
    float u_;
    float sum_ = 0.0f;
    std::optional<SurfaceHit> hit_;
    Color3f weight_{0.0f};
};

}  // namespace

std::optional<SubsurfaceExit> sample_disk_exit(const Scene& scene,
                                               const SurfaceHit& entry,
                                               const Lobe& lobe,
                                               const Color3f& throughput,
                                               SampleSequence& sequence)
{
    const Profiles profiles(lobe);
    const auto u = sequence.next();
    const auto v = sequence.next();
    const Profiles::Drawn drawn = profiles.sample(v[0], u[0]);
    const DiskRay disk = make_disk_ray(entry.point.ng, drawn.distance, drawn.cutoff, v[1], u[1]);
    const float pdf = profiles.pdf(drawn.distance);
    Reservoir exits(v[2]);
    const auto offer = [&](const SurfaceHit& hit) {
        const float distance = (hit.p_world - entry.p_world).length();
        exits.offer(hit, profiles.value(distance) * (axis_weight(disk, hit.point.ng) / pdf));
        return true;
    };
    scene.visit_object({.origin = entry.p_world + disk.start,
                        .direction = disk.direction,
                        .t_max = disk.length,
                        .time = entry.time},
                       *entry.placement, std::ref(offer));
    if (!exits.hit()) {
        return std::nullopt;
    }
    SubsurfaceExit exit{*exits.hit(), throughput * exits.weight()};
    // On the side that the light entered by.
    if (exit.hit.point.backfacing != entry.point.backfacing) {
        exit.hit.turn_over();
    }
    exit.hit.point.wo = exit.hit.point.ng;
    return exit;
}

}  // namespace eye_render
