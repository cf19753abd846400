#include "scene/curves.h"

#include "scene/motion.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace eye_render {

namespace {

[[noreturn]] void refuse(const Curves& curves, const std::string& what)
{
    throw std::invalid_argument("curves '" + curves.name + "': " + what);
}

void check_length(const Curves& curves,
                  const std::string& what,
                  std::size_t given,
                  std::size_t expected)
{
    if (given != expected) {
        refuse(curves, what + " has " + std::to_string(given) + " entries; expected " +
                           std::to_string(expected));
    }
}

}  // namespace

StrandPlace strand_place(const Curves& curves, std::size_t segment, float u)
{
    std::size_t low = 0;
    std::size_t high = curves.first_keys.size() - 1;
    while (low < high) {
        const std::size_t middle = (low + high + 1) / 2;
        if (curves.first_segment(middle) <= segment) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return {.strand = low, .key = segment + low, .u = u};
}

StrandPoint strand_point(const Curves& curves, const StrandPlace& place, float time)
{
    const auto key = [&](std::size_t index) {
        return at_time(curves.keys, curves.motion, index, time);
    };
    const SizedPoint p1 = key(place.key);
    const SizedPoint p2 = key(place.key + 1);
    const float u = place.u;
    if (curves.shape == StrandShape::RoundLinear) {
        return {.at = p1 * (1.0f - u) + p2 * u, .derivative = p2.center - p1.center};
    }
    const std::size_t first = curves.first_keys[place.strand];
    const SizedPoint p0 = key(std::max(place.key, first + 1) - 1);
    const SizedPoint p3 = key(std::min(place.key + 2, curves.last_key(place.strand)));
    const SizedPoint a = p0 * -0.5f + p1 * 1.5f + p2 * -1.5f + p3 * 0.5f;
    const SizedPoint b = p0 + p1 * -2.5f + p2 * 2.0f + p3 * -0.5f;
    const SizedPoint c = p0 * -0.5f + p2 * 0.5f;
    return {.at = ((a * u + b) * u + c) * u + p1,
            .derivative = (a.center * (3.0f * u) + b.center * 2.0f) * u + c.center};
}

StrandLength strand_length(const Curves& curves, const StrandPlace& place)
{
    StrandLength length;
    for (std::size_t key = curves.first_keys[place.strand]; key < curves.last_key(place.strand);
         ++key) {
        const float step = (curves.keys[key + 1].center - curves.keys[key].center).length();
        length.total += step;
        if (key < place.key) {
            length.to_place += step;
        } else if (key == place.key) {
            length.to_place += step * place.u;
        }
    }
    return length;
}

void validate(const Curves& curves)
{
    // Embree numbers its keys, two more a strand, with 32 bits.
    if (curves.keys.size() + 2 * curves.first_keys.size() >
        std::numeric_limits<std::uint32_t>::max()) {
        refuse(curves, "more than 4,294,967,295 keys");
    }
    if (curves.first_keys.empty() ? !curves.keys.empty() : curves.first_keys.front() != 0) {
        refuse(curves, "the first strand does not start at key 0");
    }
    for (std::size_t strand = 0; strand < curves.first_keys.size(); ++strand) {
        const std::size_t end = strand + 1 < curves.first_keys.size()
                                    ? curves.first_keys[strand + 1]
                                    : curves.keys.size();
        if (end < curves.first_keys[strand] + std::size_t{2}) {
            refuse(curves, "strand " + std::to_string(strand) + " has less than 2 keys");
        }
    }
    for (const SizedPoint& key : curves.keys) {
        if (key.radius < 0.0f) {
            refuse(curves, "a radius is " + std::to_string(key.radius) + "; expected 0 or more");
        }
    }
    for (const StrandUv& layer : curves.uv_layers) {
        check_length(curves, "UV layer '" + layer.name + "'", layer.per_strand.size(),
                     curves.first_keys.size());
    }
    for (const KeyAttribute& attribute : curves.attributes) {
        check_length(curves, "attribute '" + attribute.name + "'", attribute.per_key.size(),
                     curves.keys.size());
    }
    if (curves.motion.size() == 1) {
        refuse(curves, "motion has 1 step; expected none or at least 2");
    }
    for (const std::vector<SizedPoint>& step : curves.motion) {
        check_length(curves, "a step of the motion", step.size(), curves.keys.size());
    }
}

std::size_t drop_broken_strands(Curves& curves)
{
    const auto is_whole = [&curves](std::size_t strand) {
        for (std::size_t key = curves.first_keys[strand]; key <= curves.last_key(strand); ++key) {
            const bool moves_well =
                std::ranges::all_of(curves.motion, [key](const std::vector<SizedPoint>& step) {
                    return step[key].is_finite();
                });
            if (!curves.keys[key].is_finite() || !moves_well) {
                return false;
            }
        }
        return true;
    };
    const std::size_t before = curves.first_keys.size();
    std::vector<std::uint32_t> first_keys;
    std::vector<std::size_t> kept_keys;
    std::vector<std::size_t> kept_strands;
    for (std::size_t strand = 0; strand < before; ++strand) {
        if (is_whole(strand)) {
            kept_strands.push_back(strand);
            first_keys.push_back(static_cast<std::uint32_t>(kept_keys.size()));
            for (std::size_t key = curves.first_keys[strand]; key <= curves.last_key(strand);
                 ++key) {
                kept_keys.push_back(key);
            }
        }
    }
    if (kept_strands.size() == before) {
        return 0;
    }
    const auto keep = [](auto& values, const std::vector<std::size_t>& kept) {
        for (std::size_t i = 0; i < kept.size(); ++i) {
            values[i] = values[kept[i]];
        }
        values.resize(kept.size());
    };
    curves.first_keys = std::move(first_keys);
    keep(curves.keys, kept_keys);
    for (std::vector<SizedPoint>& step : curves.motion) {
        keep(step, kept_keys);
    }
    for (StrandUv& layer : curves.uv_layers) {
        keep(layer.per_strand, kept_strands);
    }
    for (KeyAttribute& attribute : curves.attributes) {
        keep(attribute.per_key, kept_keys);
    }
    return before - kept_strands.size();
}

}  // namespace eye_render
