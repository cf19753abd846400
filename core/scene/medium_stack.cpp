#include "scene/medium_stack.h"

#include <algorithm>

namespace eye_render {

void MediumStack::cross(const SurfaceHit& hit)
{
    const Inside entry{hit.placement, hit.medium()};
    if (entry.medium == nullptr) {
        return;
    }
    const auto end = inside_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto found = std::find(inside_.begin(), end, entry);
    if (hit.point.backfacing) {
        if (found == end) {
            return;
        }
        std::move(found + 1, end, found);
        --count_;
    } else {
        if (found != end || count_ == capacity) {
            return;
        }
        inside_[count_++] = entry;
    }
    mix();
}

void MediumStack::leave_meshes()
{
    if (count_ > 0) {
        count_ = 0;
        mix();
    }
}

void MediumStack::mix()
{
    mixture_ = world_ != nullptr ? *world_ : ParticipatingMedium{};
    for (std::size_t i = 0; i < count_; ++i) {
        mixture_.add(*inside_[i].medium);
    }
    in_medium_ = world_ != nullptr || count_ > 0;
}

}  // namespace eye_render
