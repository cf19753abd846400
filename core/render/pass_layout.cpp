#include "render/pass_layout.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

PassLayout::PassLayout(std::span<const Pass> passes)
{
    first_.fill(none);
    const auto add_all = [&](PassSource source, std::size_t& channels) {
        for (const PassInfo& pass : pass_table) {
            const bool is_asked_for = std::ranges::find(passes, pass.pass) != passes.end();
            const bool is_divisor = std::ranges::any_of(
                passes, [&](Pass other) { return info(other).divisor == pass.pass; });
            if (pass.source == source && (is_asked_for || is_divisor)) {
                add(pass.pass, channels);
            }
        }
    };
    add_all(PassSource::Light, light_channels_);
    channels_ = light_channels_;
    add_all(PassSource::Surface, channels_);
    add_all(PassSource::Chief, chief_channels_);
    has_scattered_light_ =
        has(Pass::VolumeDirect) || has(Pass::VolumeIndirect) ||
        std::ranges::any_of(passes, [](Pass pass) { return info(pass).divisor.has_value(); });
}

void PassLayout::add(Pass pass, std::size_t& channels)
{
    // Combined stands apart: every render has it.
    if (pass != Pass::Combined) {
        first_[static_cast<std::size_t>(pass)] = static_cast<int>(channels);
        channels += info(pass).channels();
    }
}

void PassValues::add(Pass pass, const Color3f& value)
{
    const int first = layout_.first(pass);
    if (first != PassLayout::none && std::isfinite(value.x + value.y + value.z)) {
        float* const sums = values_.data() + first;
        sums[0] += value.x;
        sums[1] += value.y;
        sums[2] += value.z;
    }
}

}  // namespace eye_render
