// Looks up a row of a table by its name, for tables of operations that a user chooses from.

#pragma once

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace eye_render {

// Throws std::invalid_argument, "operation is FLY; expected one of ADD, SUBTRACT, …".
template <typename Row>
[[nodiscard]] const Row& row_named(std::span<const Row> rows,
                                   std::string_view what,
                                   std::string_view name)
{
    const auto found = std::ranges::find(rows, name, &Row::name);
    if (found != rows.end()) {
        return *found;
    }
    std::string names;
    for (const Row& row : rows) {
        names.append(names.empty() ? "" : ", ").append(row.name);
    }
    throw std::invalid_argument(
        std::string(what).append(" is ").append(name).append("; expected one of ").append(names));
}

}  // namespace eye_render
