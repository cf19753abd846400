#include "shading/ies_table.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace eye_render {

namespace {

using Row = std::vector<double>;

[[nodiscard]] bool is_close(double a_deg, double b_deg) { return std::abs(a_deg - b_deg) < 1e-4; }

// From angles between 0 or -90 and 90 to angles between 0 and 180. What is only given from 0 on is
// mirrored, and the items (rows or numbers) with it.
template <typename Item>
void count_from_minus_90(std::vector<double>& angles_deg, std::vector<std::vector<Item>*> items)
{
    if (is_close(angles_deg.front(), 0.0)) {
        const std::vector<double> half = angles_deg;
        for (std::size_t i = 1; i < half.size(); ++i) {
            angles_deg.insert(angles_deg.begin(), -half[i]);
        }
        for (std::vector<Item>* list : items) {
            const std::vector<Item> given = *list;
            for (std::size_t i = 1; i < given.size(); ++i) {
                list->insert(list->begin(), given[i]);
            }
        }
    }
    for (double& angle : angles_deg) {
        angle += 90.0;
    }
}

// Appends what lies beyond the last angle, as the mirror image of what lies before it.
void mirror_about_last(IesTable& table)
{
    std::vector<double>& angles = table.horizontal_deg;
    const double twice_last = 2.0 * angles.back();
    for (std::size_t i = angles.size() - 1; i-- > 0;) {
        angles.push_back(twice_last - angles[i]);
        table.watts.push_back(table.watts[i]);
    }
}

}  // namespace

void arrange_type_c(IesTable& table)
{
    std::vector<double>& angles = table.horizontal_deg;
    if (is_close(angles.front(), 90.0)) {  // from 90 to 270: a half all the same
        for (double& angle : angles) {
            angle -= 90.0;
        }
    }
    if (angles.size() == 1) {
        angles = {0.0, 360.0};
        table.watts.push_back(table.watts.front());
    }
    for (const double last_deg : {90.0, 180.0}) {
        if (is_close(angles.back(), last_deg)) {
            mirror_about_last(table);
        }
    }
    // Some files leave away 360, which is 0 again.
    const double gap = 360.0 - angles.back();
    const std::size_t last = angles.size() - 1;
    if (is_close(angles.front(), 0.0) && gap > 1e-4 &&
        (is_close(gap, angles[1] - angles[0]) || is_close(gap, angles[last] - angles[last - 1]))) {
        angles.push_back(360.0);
        table.watts.push_back(table.watts.front());
    }
}

void arrange_type_b(IesTable& table)
{
    std::vector<Row> turned(table.vertical_deg.size());
    for (const Row& row : table.watts) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            turned[i].push_back(row[i]);
        }
    }
    table.watts = std::move(turned);
    std::swap(table.horizontal_deg, table.vertical_deg);
    count_from_minus_90<Row>(table.horizontal_deg, {&table.watts});
    std::vector<Row*> rows;
    for (Row& row : table.watts) {
        rows.push_back(&row);
    }
    count_from_minus_90<double>(table.vertical_deg, rows);
}

void arrange_type_a(IesTable& table)
{
    for (double& angle : table.vertical_deg) {
        angle += 90.0;
    }
    const std::vector<double> angles = table.horizontal_deg;
    const std::vector<Row> rows = table.watts;
    table.horizontal_deg.clear();
    table.watts.clear();
    for (std::size_t i = angles.size(); i-- > 0;) {
        table.horizontal_deg.push_back(180.0 - angles[i]);
        table.watts.push_back(rows[i]);
    }
    if (is_close(angles.front(), 0.0)) {
        for (std::size_t i = 1; i < angles.size(); ++i) {
            table.horizontal_deg.push_back(180.0 + angles[i]);
            table.watts.push_back(rows[i]);
        }
    }
}

}  // namespace eye_render
