// Point spread functions against the evenly filled ellipse.

#include "analysis/psf.h"

#include "eyes.h"

#include "base/units.h"
#include "eye/eye_factory.h"

#include <gtest/gtest.h>

#include <numeric>

namespace eye_render {
namespace {

constexpr double arcmin_rad = pi / (180.0 * 60.0);

struct Image {
    PsfGrid grid;
    std::vector<double> pixels;

    [[nodiscard]] double at(int column, int row) const
    {
        return pixels[static_cast<std::size_t>(row * grid.resolution + column)];
    }
    [[nodiscard]] double sum() const { return std::accumulate(pixels.begin(), pixels.end(), 0.0); }
};

Image psf_of(const EyeModel& eye, double size_arcmin, int resolution, double vergence_d = 0.0)
{
    const PsfGrid grid{.size_rad = size_arcmin * arcmin_rad, .resolution = resolution};
    const PupilTrace trace = trace_pupil(eye, {.samples = 1u << 18});
    return {grid, point_spread(make_spot(trace, vergence_d), grid)};
}

TEST(Psf, of_a_focused_eye_fills_the_pixels_that_meet_at_the_centre)
{
    const Image even = psf_of(*make_eye({}), 10.0, 4);
    EXPECT_NEAR(even.at(1, 1), 0.25, 1e-12);
    EXPECT_NEAR(even.at(2, 2), 0.25, 1e-12);
    const Image odd = psf_of(*make_eye({}), 10.0, 5);
    EXPECT_NEAR(odd.at(2, 2), 1.0, 1e-12);
}

TEST(Psf, of_a_cylinder_is_an_evenly_filled_ellipse_across_the_axis)
{
    // -2 -1 x 160 at the pupil: 2 D along the axis, which the patient sees at 20 degrees, and 3 D
    // across it.
    const auto eye =
        make_eye({.rx = Prescription{.sphere_d = -2.0, .cylinder_d = -1.0, .axis_deg = 160.0},
                  .rx_plane = RxPlane::EntrancePupil,
                  .pupil_diameter_m = 4e-3});
    constexpr int resolution = 100;
    const Image image = psf_of(*eye, 50.0, resolution);
    EXPECT_NEAR(image.sum(), 1.0, 1e-9);

    const double along_px = 2e-3 * 2.0 / (0.5 * arcmin_rad);
    const double across_px = 2e-3 * 3.0 / (0.5 * arcmin_rad);
    const double density = 1.0 / (pi * along_px * across_px);
    const double axis_rad = rad_from_deg(20.0);
    for (int row = 0; row < resolution; ++row) {
        for (int column = 0; column < resolution; ++column) {
            const double x = column + 0.5 - 0.5 * resolution;
            const double y = row + 0.5 - 0.5 * resolution;
            const double along = (x * std::cos(axis_rad) + y * std::sin(axis_rad)) / along_px;
            const double across = (y * std::cos(axis_rad) - x * std::sin(axis_rad)) / across_px;
            const double radius = std::hypot(along, across);
            // The rim runs through the pixels in between.
            if (radius < 0.93) {
                // 68 of the 2^18 stratified samples fall into a pixel, give or take 3 or 4.
                EXPECT_NEAR(image.at(column, row), density, 0.2 * density) << x << " " << y;
            } else if (radius > 1.07) {
                EXPECT_EQ(image.at(column, row), 0.0) << x << " " << y;
            }
        }
    }
}

TEST(Psf, rows_sum_to_the_semicircle_that_a_line_is_spread_to)
{
    const auto eye = make_eye({.rx = Prescription{.sphere_d = -2.0, .cylinder_d = -0.75},
                               .rx_plane = RxPlane::EntrancePupil});
    constexpr int resolution = 64;
    constexpr double size_arcmin = 50.0;
    const Image image = psf_of(*eye, size_arcmin, resolution);
    const double half_width_px =
        2e-3 * eye->error_d(0.0).yy_d / (size_arcmin / resolution * arcmin_rad);
    for (int row = 0; row < resolution; ++row) {
        double light = 0.0;
        for (int column = 0; column < resolution; ++column) {
            light += image.at(column, row);
        }
        const double t = row + 0.5 - 0.5 * resolution;
        if (std::abs(t) < half_width_px - 2.0) {
            const double semicircle = 2.0 * std::sqrt(half_width_px * half_width_px - t * t) /
                                      (pi * half_width_px * half_width_px);
            EXPECT_NEAR(light, semicircle, 0.01 * semicircle) << t;
        }
    }
}

TEST(Psf, rows_run_bottom_up)
{
    // The half eye spreads a near point upwards: see test_spot.
    const Image image = psf_of(test::HalfEye(), 10.0, 8, 1.0);
    double above = 0.0;
    for (int column = 0; column < 8; ++column) {
        for (int row = 4; row < 8; ++row) {
            above += image.at(column, row);
        }
    }
    EXPECT_GT(above, 0.9);
}

TEST(Psf, sums_to_the_share_inside_the_square)
{
    // The square inscribed in the disk holds 2/pi of it.
    const auto eye =
        make_eye({.rx = Prescription{.sphere_d = -3.0}, .rx_plane = RxPlane::EntrancePupil});
    const double disk_arcmin = 4e-3 * 3.0 / arcmin_rad;
    EXPECT_NEAR(psf_of(*eye, disk_arcmin / std::sqrt(2.0), 64).sum(), 2.0 / pi, 1e-3);
    EXPECT_EQ(psf_of(test::ClosedEye(), 10.0, 8).sum(), 0.0);
}

}  // namespace
}  // namespace eye_render
