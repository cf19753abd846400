#include "scene/points.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace eye_render {

namespace {

void check_length(const Points& points, const std::string& what, std::size_t given)
{
    if (given != points.points.size()) {
        throw std::invalid_argument("points '" + points.name + "': " + what + " has " +
                                    std::to_string(given) + " entries; expected " +
                                    std::to_string(points.points.size()));
    }
}

}  // namespace

void validate(const Points& points)
{
    if (points.points.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument("points '" + points.name +
                                    "': more than 4,294,967,295 points");
    }
    for (const SizedPoint& point : points.points) {
        if (point.radius < 0.0f) {
            throw std::invalid_argument("points '" + points.name + "': a radius is " +
                                        std::to_string(point.radius) + "; expected 0 or more");
        }
    }
    for (const PointAttribute& attribute : points.attributes) {
        check_length(points, "attribute '" + attribute.name + "'", attribute.per_point.size());
    }
    if (points.motion.size() == 1) {
        throw std::invalid_argument("points '" + points.name +
                                    "': motion has 1 step; expected none or at least 2");
    }
    for (const std::vector<SizedPoint>& step : points.motion) {
        check_length(points, "a step of the motion", step.size());
    }
}

std::size_t drop_broken_points(Points& points)
{
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const bool moves_well =
            std::ranges::all_of(points.motion, [i](const std::vector<SizedPoint>& step) {
                return step[i].is_finite();
            });
        if (points.points[i].is_finite() && moves_well) {
            kept.push_back(i);
        }
    }
    const std::size_t dropped = points.points.size() - kept.size();
    if (dropped == 0) {
        return 0;
    }
    const auto keep = [&kept](auto& values) {
        for (std::size_t i = 0; i < kept.size(); ++i) {
            values[i] = values[kept[i]];
        }
        values.resize(kept.size());
    };
    keep(points.points);
    for (std::vector<SizedPoint>& step : points.motion) {
        keep(step);
    }
    for (PointAttribute& attribute : points.attributes) {
        keep(attribute.per_point);
    }
    return dropped;
}

}  // namespace eye_render
