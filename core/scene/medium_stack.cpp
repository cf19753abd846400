#include "scene/medium_stack.h"

#include <algorithm>
#include <span>

namespace eye_render {

void MediumStack::cross(const SurfaceHit& hit)
{
    const Inside entry{hit.placement, hit.medium()};
    if (entry.medium == nullptr) {
        return;
    }
    const std::span<Inside> inside(inside_.data(), count_);
    const auto found = std::ranges::find(inside, entry);
    if (hit.point.backfacing) {
        if (found == inside.end()) {
            return;
        }
        std::move(found + 1, inside.end(), found);
        --count_;
    } else {
        if (found != inside.end() || count_ == capacity) {
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
    if (world_ == nullptr && count_ == 0) {
        mixture_.reset();
        return;
    }
    mixture_ = world_ != nullptr ? *world_ : ParticipatingMedium{};
    for (std::size_t i = 0; i < count_; ++i) {
        mixture_->add(*inside_[i].medium);
    }
}

}  // namespace eye_render
