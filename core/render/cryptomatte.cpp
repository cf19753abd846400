#include "render/cryptomatte.h"

#include <algorithm>

namespace eye_render {

void MatteSums::add(float id, double weight)
{
    const auto known = std::ranges::find(sums_, id, &Sum::id);
    if (known != sums_.end()) {
        known->weight += weight;
    } else {
        sums_.push_back({.id = id, .weight = weight});
    }
}

void MatteSums::write(std::size_t number, double whole, std::span<float, 4> pixel) const
{
    std::vector<Sum> ranked = sums_;
    std::ranges::stable_sort(ranked, std::ranges::greater{}, &Sum::weight);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t rank = 2 * number + i;
        const Sum sum = rank < ranked.size() ? ranked[rank] : Sum{};
        pixel[2 * i] = sum.id;
        pixel[2 * i + 1] = static_cast<float>(sum.weight / whole);
    }
}

}  // namespace eye_render
