#include "render/pass_layout.h"

#include <algorithm>

namespace eye_render {

PassLayout::PassLayout(const std::vector<PassRequest>& passes, const PassSubjects& subjects)
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
            if (row.source == source && row.pass != Pass::Combined && !row.is_named &&
                is_wanted(row)) {
                first_[static_cast<std::size_t>(row.pass)] = static_cast<int>(channels);
                channels += one_each ? 1 : row.channels();
            }
        }
    };
    add(PassSource::Light, channels_);
    add_named(passes, PassSource::Light);
    light_channels_ = channels_;
    if (subjects.has_shadow_catcher) {
        catcher_ = CatcherChannels{
            .matte = light_channels_, .bare = light_channels_ + 3, .behind = light_channels_ + 6};
        light_channels_ += 9;
    }
    channels_ = light_channels_;
    add(PassSource::Surface, channels_);
    add_named(passes, PassSource::Surface);
    note_subjects(subjects);
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

void PassLayout::add_named(const std::vector<PassRequest>& passes, PassSource source)
{
    for (const PassRequest& request : passes) {
        if (info(request.pass).is_named && info(request.pass).source == source) {
            named_.push_back({.request = request, .first = channels_});
            channels_ += info(request.pass).channels();
        }
    }
}

void PassLayout::note_subjects(const PassSubjects& subjects)
{
    light_groups_.assign(subjects.light_groups.size(), none);
    for (const Named& named : named_) {
        const bool is_group = named.request.pass == Pass::LightGroup;
        const auto& names = is_group ? subjects.light_groups : subjects.aovs;
        const auto found = std::ranges::find(names, named.request.label);
        if (found == names.end()) {
            continue;  // it stays black
        }
        const auto number = static_cast<int>(found - names.begin());
        if (is_group) {
            light_groups_[static_cast<std::size_t>(number)] = static_cast<int>(named.first);
        } else {
            aovs_.push_back({.number = number,
                             .first = named.first,
                             .is_color = named.request.pass == Pass::AovColor});
        }
    }
}

std::size_t PassLayout::first(const PassRequest& request) const
{
    if (info(request.pass).is_named) {
        return std::ranges::find(named_, request, &Named::request)->first;
    }
    return static_cast<std::size_t>(first(request.pass));
}

}  // namespace eye_render
