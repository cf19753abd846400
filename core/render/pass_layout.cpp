#include "render/pass_layout.h"

#include <algorithm>

namespace eye_render {

PassLayout::PassLayout(const std::vector<PassRequest>& passes, bool catches_shadows)
{
    first_.fill(none);
    const auto is_wanted = [&](const PassInfo& row) {
        return std::ranges::any_of(passes, [&](const PassRequest& request) {
            return request.pass == row.pass || info(request.pass).divisor == row.pass;
        });
    };
    // Combined stands apart: every render has it.
    const auto add = [&](PassSource source, std::size_t& channels, bool one_each = false) {
        for (const PassInfo& row : pass_table) {
            if (row.source == source && row.pass != Pass::Combined && is_wanted(row)) {
                first_[static_cast<std::size_t>(row.pass)] = static_cast<int>(channels);
                channels += one_each ? 1 : row.channels();
            }
        }
    };
    add(PassSource::Light, light_channels_);
    if (catches_shadows) {
        catcher_ = CatcherChannels{
            .matte = light_channels_, .bare = light_channels_ + 3, .behind = light_channels_ + 6};
        light_channels_ += 9;
    }
    channels_ = light_channels_;
    add(PassSource::Surface, channels_);
    if (catcher_) {
        catcher_->matte_alpha = channels_++;
    }
    add(PassSource::Chief, chief_channels_);
    add(PassSource::Coverage, matte_kinds_, true);
    has_scattered_light_ = std::ranges::any_of(passes, [](const PassRequest& request) {
        return request.pass == Pass::VolumeDirect || request.pass == Pass::VolumeIndirect ||
               info(request.pass).divisor.has_value();
    });
}

}  // namespace eye_render
