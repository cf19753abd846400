#include "render/pass_values.h"

#include <cmath>

namespace eye_render {

PassValues::PassValues(const PassLayout& layout)
    : layout_(layout), nothing_met_(layout.channels(), 0.0f)
{
    if (layout.has(Pass::Mist)) {
        nothing_met_[static_cast<std::size_t>(layout.first(Pass::Mist))] = 1.0f;
    }
    if (layout.catcher()) {
        nothing_met_[layout.catcher()->matte_alpha] = 1.0f;
    }
    clear();
}

void PassValues::clear()
{
    values_ = nothing_met_;
    mattes_.clear();
}

void PassValues::add(Pass pass, const Color3f& value)
{
    if (layout_.has(pass)) {
        add_at(static_cast<std::size_t>(layout_.first(pass)), value);
    }
}

void PassValues::add(Pass pass, float value)
{
    if (layout_.has(pass)) {
        add_at(static_cast<std::size_t>(layout_.first(pass)), value);
    }
}

void PassValues::add_at(std::size_t first, const Color3f& value)
{
    if (std::isfinite(value.x + value.y + value.z)) {
        values_[first] += value.x;
        values_[first + 1] += value.y;
        values_[first + 2] += value.z;
    }
}

void PassValues::add_at(std::size_t channel, float value)
{
    if (std::isfinite(value)) {
        values_[channel] += value;
    }
}

void PassValues::add_matte(Pass pass, float id, float coverage)
{
    if (layout_.has(pass) && coverage > 0.0f) {
        mattes_.push_back({.kind = static_cast<std::size_t>(layout_.first(pass)),
                           .id = id,
                           .coverage = coverage});
    }
}

}  // namespace eye_render
