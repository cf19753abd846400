#include "scene/alias_table.h"

#include <algorithm>
#include <numeric>

namespace eye_render {

std::vector<AliasColumn> make_alias_table(std::span<const double> weights)
{
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<AliasColumn> table(weights.size());
    std::vector<double> scaled(weights.size());  // by how many columns each choice still fills
    std::vector<std::size_t> small;
    std::vector<std::size_t> large;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double probability = weights[i] / total;
        scaled[i] = probability * static_cast<double>(weights.size());
        (scaled[i] < 1.0 ? small : large).push_back(i);
        table[i] = {.alias = static_cast<std::uint32_t>(i),
                    .probability = static_cast<float>(probability)};
    }
    while (!small.empty() && !large.empty()) {
        const std::size_t receiver = small.back();
        const std::size_t donor = large.back();
        small.pop_back();
        table[receiver].keep = static_cast<float>(scaled[receiver]);
        table[receiver].alias = static_cast<std::uint32_t>(donor);
        scaled[donor] -= 1.0 - scaled[receiver];
        if (scaled[donor] < 1.0) {
            large.pop_back();
            small.push_back(donor);
        }
    }
    return table;
}

std::uint32_t choose_from(std::span<const AliasColumn> table, double u)
{
    const double position = std::clamp(u, 0.0, 1.0) * static_cast<double>(table.size());
    const auto column = std::min(static_cast<std::uint32_t>(position),
                                 static_cast<std::uint32_t>(table.size() - 1));
    const AliasColumn& found = table[column];
    return position - column < static_cast<double>(found.keep) ? column : found.alias;
}

}  // namespace eye_render
