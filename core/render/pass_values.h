// What one sample says to all passes but Combined.

#pragma once

#include "render/pass_layout.h"

namespace eye_render {

// A thing that a sample met, and how much of the sample it covers.
struct MatteShare {
    std::size_t kind = 0;  // as PassLayout numbers those of Cryptomatte
    float id = 0.0f;
    float coverage = 0.0f;
};

class PassValues {
public:
    explicit PassValues(const PassLayout& layout);

    [[nodiscard]] const PassLayout& layout() const { return layout_; }
    [[nodiscard]] std::span<const float> channels() const { return values_; }
    [[nodiscard]] std::span<const MatteShare> mattes() const { return mattes_; }

    // As of a sample that met nothing.
    void clear();

    // Adds to the pass if it is wanted. What is not finite is left out.
    void add(Pass pass, const Color3f& value);
    void add(Pass pass, float value);
    void add_at(std::size_t first, const Color3f& value);
    void add_at(std::size_t channel, float value);
    void add_matte(Pass pass, float id, float coverage);

private:
    const PassLayout& layout_;
    std::vector<float> nothing_met_;
    std::vector<float> values_;
    std::vector<MatteShare> mattes_;
};

}  // namespace eye_render
