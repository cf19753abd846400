// Which channels a pixel needs for the passes that are wanted, Combined apart: nothing else is
// computed, summed or kept.

#pragma once

#include "base/vector.h"
#include "render/passes.h"

#include <span>
#include <vector>

namespace eye_render {

class PassLayout {
public:
    static constexpr int none = -1;

    // Of Combined alone.
    PassLayout() : PassLayout(std::span<const Pass>{}) {}
    explicit PassLayout(std::span<const Pass> passes);

    // Channels of one sample: those of light first, three a colour, then those of surfaces.
    [[nodiscard]] std::size_t light_channels() const { return light_channels_; }
    [[nodiscard]] std::size_t channels() const { return channels_; }
    // Of the one ray a pixel that the others come from.
    [[nodiscard]] std::size_t chief_channels() const { return chief_channels_; }

    // The pass's first channel among those of its source, or none.
    [[nodiscard]] int first(Pass pass) const { return first_[static_cast<std::size_t>(pass)]; }
    [[nodiscard]] bool has(Pass pass) const { return first(pass) != none; }

    // Some pass tells light by what scattered it first.
    [[nodiscard]] bool has_scattered_light() const { return has_scattered_light_; }
    // Some pass tells what is there.
    [[nodiscard]] bool has_surface() const { return channels_ > light_channels_; }

private:
    void add(Pass pass, std::size_t& channels);

    std::array<int, pass_count> first_{};
    std::size_t light_channels_ = 0;
    std::size_t channels_ = 0;
    std::size_t chief_channels_ = 0;
    bool has_scattered_light_ = false;
};

// What one sample says to all passes but Combined.
class PassValues {
public:
    explicit PassValues(const PassLayout& layout) : layout_(layout), values_(layout.channels()) {}

    [[nodiscard]] const PassLayout& layout() const { return layout_; }
    [[nodiscard]] std::span<const float> channels() const { return values_; }

    void clear() { values_.assign(values_.size(), 0.0f); }

    // Adds to the pass if it is wanted. What is not finite is left out.
    void add(Pass pass, const Color3f& value);

private:
    const PassLayout& layout_;
    std::vector<float> values_;
};

}  // namespace eye_render
