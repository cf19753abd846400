#include "analysis/psf.h"

#include <cmath>

namespace eye_render {

namespace {

class Square {
public:
    explicit Square(int resolution)
        : resolution_(resolution),
          pixels_(static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution))
    {
    }

    // `p` in pixels from the lower left corner.
    void add(const V2d& p, double light)
    {
        const V2d corner(std::floor(p.x - 0.5), std::floor(p.y - 0.5));
        const V2d rest = p - V2d(0.5) - corner;
        add_to(corner.x, corner.y, light * (1.0 - rest.x) * (1.0 - rest.y));
        add_to(corner.x + 1.0, corner.y, light * rest.x * (1.0 - rest.y));
        add_to(corner.x, corner.y + 1.0, light * (1.0 - rest.x) * rest.y);
        add_to(corner.x + 1.0, corner.y + 1.0, light * rest.x * rest.y);
    }

    [[nodiscard]] std::vector<double> take() && { return std::move(pixels_); }

private:
    // Compared as doubles: a ray may be anywhere.
    void add_to(double column, double row, double light)
    {
        if (column >= 0.0 && row >= 0.0 && column < resolution_ && row < resolution_) {
            pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(resolution_) +
                    static_cast<std::size_t>(column)] += light;
        }
    }

    int resolution_;
    std::vector<double> pixels_;
};

}  // namespace

std::vector<double> point_spread(const Spot& spot, const PsfGrid& grid)
{
    Square square(grid.resolution);
    if (spot.weight > 0.0) {
        const double pixels_per_rad = grid.resolution / grid.size_rad;
        const V2d center_px(0.5 * grid.resolution);
        for (const SpotPoint& point : spot.points) {
            square.add(point.angle_rad * pixels_per_rad + center_px, point.weight / spot.weight);
        }
    }
    return std::move(square).take();
}

}  // namespace eye_render
