// Strands of hair and other thin curves in their own object space, as plain data. Each runs
// through its keys from root to tip, by Catmull-Rom splines (Catmull & Rom 1974) whose end keys
// count twice, or straight from key to key.

#pragma once

#include "scene/mesh.h"
#include "scene/sized_point.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace eye_render {

enum class StrandShape : std::uint8_t {
    Round,        // the sweep of a circle along the spline
    RoundLinear,  // cones between balls
    Ribbon,       // flat, turned to whoever looks, shaded as if round
};

struct StrandUv {
    std::string name;
    std::vector<V2f> per_strand;
};

struct KeyAttribute {
    std::string name;
    std::vector<Color4f> per_key;  // as Attribute has them
};

struct Curves {
    std::string name;
    std::vector<SizedPoint> keys;           // of all strands, one strand after the other
    std::vector<std::uint32_t> first_keys;  // of each strand, ascending from 0
    StrandShape shape = StrandShape::Round;
    std::vector<StrandUv> uv_layers;  // the first is the one that unnamed requests read
    std::vector<KeyAttribute> attributes;
    std::optional<TextureSpace> texture_space;  // nothing: the bounding box of the keys
    // Keys at the times of motion.h; empty: still. `keys` are those at the shutter's middle.
    std::vector<std::vector<SizedPoint>> motion;

    [[nodiscard]] std::size_t last_key(std::size_t strand) const
    {
        return (strand + 1 < first_keys.size() ? first_keys[strand + 1] : keys.size()) - 1;
    }
    // A strand has one segment fewer than keys; segments count through all strands. Of strands
    // and of what would be the next.
    [[nodiscard]] std::uint32_t first_segment(std::size_t strand) const
    {
        const std::size_t key = strand < first_keys.size() ? first_keys[strand] : keys.size();
        return static_cast<std::uint32_t>(key - strand);
    }
    [[nodiscard]] std::size_t segments() const { return keys.size() - first_keys.size(); }
};

// A place along a strand: between key and key + 1.
struct StrandPlace {
    std::size_t strand = 0;
    std::size_t key = 0;
    float u = 0.0f;
};

[[nodiscard]] StrandPlace strand_place(const Curves& curves, std::size_t segment, float u);

// The curve's axis and radius, and their derivative by u.
struct StrandPoint {
    SizedPoint at;
    V3f derivative;
};

[[nodiscard]] StrandPoint strand_point(const Curves& curves, const StrandPlace& place, float time);

// From root to tip along straight lines between keys, object space.
struct StrandLength {
    float total = 0.0f;
    float to_place = 0.0f;
};

[[nodiscard]] StrandLength strand_length(const Curves& curves, const StrandPlace& place);

// Throws std::invalid_argument when a length or a number is out of range.
void validate(const Curves& curves);

// Leaves out the strands with a key that is not finite; returns how many.
std::size_t drop_broken_strands(Curves& curves);

}  // namespace eye_render
