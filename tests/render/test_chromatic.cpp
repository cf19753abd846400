// Pictures with a wavelength for each path: what stays white, and what gets a fringe of colour.

#include "eye/eye_factory.h"
#include "eye/schematic_body.h"
#include "optics/display_primaries.h"
#include "render/session.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace eye_render {
namespace {

constexpr int size_px = 32;

// A white half plane, right of the middle, so far away that an emmetrope sees it sharply at the
// reference wavelength.
constexpr double distance_m = 1e4;

std::vector<float> white_edge(std::shared_ptr<const EyeModel> eye,
                              double half_slope,
                              std::uint32_t samples)
{
    SceneData data;
    const float half_m = 0.1f * static_cast<float>(distance_m);
    test::place(data, test::square(half_m), V3d(half_m, 0.0, -distance_m),
                test::emissive_diffuse(0.0f, 1.0f));
    RenderJob job;
    job.scene = std::make_shared<Scene>(data, V3d(0.0));
    job.frame = test::frame(size_px, half_slope);
    job.eye = std::move(eye);
    job.chromatic = true;
    Session session(std::move(job), {.samples = {0, samples}, .passes = {Pass::Combined}});
    session.start();
    EXPECT_TRUE(session.wait(std::chrono::seconds(60)));
    return session.snapshot().front().pixels;
}

std::vector<float> white_edge(std::uint32_t samples)
{
    constexpr double half_slope = 0.01;  // 2 arcmin a pixel
    return white_edge(make_eye({.pupil_diameter_m = 6e-3}), half_slope, samples);
}

// Mean of a column of pixels.
V3d column(const std::vector<float>& pixels, int x)
{
    V3d sum(0.0);
    for (int y = 0; y < size_px; ++y) {
        const float* pixel = pixels.data() + 4 * (y * size_px + x);
        sum += V3d(pixel[0], pixel[1], pixel[2]);
    }
    return sum / size_px;
}

// Four samples of a pixel lie in four quarters of the light, so no channel goes without.
TEST(Chromatic, flat_white_stays_white_from_four_samples_on)
{
    for (const std::uint32_t samples : {4U, 7U, 64U}) {
        const V3d white = column(white_edge(samples), size_px - 2);
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(white[channel], 1.0, 1e-6) << samples << " samples, channel " << channel;
        }
    }
}

// The eye is in focus in the green; red and blue light reaches across the edge. So the dark side
// gets a purple fringe, and the bright side lacks what went there.
TEST(Chromatic, a_white_edge_has_a_purple_fringe_on_its_dark_side)
{
    const std::vector<float> pixels = white_edge(256);
    const V3d dark = column(pixels, size_px / 2 - 3);
    const V3d bright = column(pixels, size_px / 2 + 2);
    EXPECT_GT(dark.x, 1.3 * dark.y) << dark;
    EXPECT_GT(dark.z, 1.5 * dark.y) << dark;
    EXPECT_LT(bright.x, bright.y) << bright;
    EXPECT_LT(bright.z, bright.y) << bright;
}

// Of the spread of a line, in squares of slopes, from the steps between the columns of an edge.
V3d spread_variance(const std::vector<float>& pixels, double half_slope)
{
    const double step = 2.0 * half_slope / size_px;
    V3d sum(0.0);
    V3d mean(0.0);
    V3d square(0.0);
    for (int x = 1; x < size_px; ++x) {
        const V3d rise = column(pixels, x) - column(pixels, x - 1);
        const double slope = step * x - half_slope;
        sum += rise;
        mean += rise * slope;
        square += rise * slope * slope;
    }
    mean /= sum;
    return square / sum - mean * mean;
}

// Without spherical aberration a wavelength with the error e spreads an edge by a variance of
// (e R / 2)^2, and a channel by the mean of that over its light.
TEST(Chromatic, navarros_dispersion_widens_an_edge_by_each_channels_light)
{
    constexpr double pupil_m = 1e-3;
    constexpr double half_slope = 1.2e-3;
    constexpr std::uint32_t samples = 512;
    // Navarro's spherical aberration, 0.9 D at the edge of a pupil of 6 mm, at that of 1 mm.
    constexpr double aberration_d = 0.025;
    const LensSystem system =
        schematic_body({.kind = SchematicEyeKind::Navarro, .pupil_diameter_m = pupil_m}).system;
    V3d expected(0.0);
    for (double nm = min_display_nm; nm <= max_display_nm; nm += 1.0) {
        const double error_d = mean_conjugate_d(system, RefractionZero::Paraxial, pupil_m, nm);
        expected +=
            display_primaries(nm, WorkingSpace::Rec709) * std::pow(0.25 * pupil_m * error_d, 2);
    }
    const std::shared_ptr<const EyeModel> navarro =
        make_eye({.model = EyeModelKind::Navarro, .pupil_diameter_m = pupil_m});
    // What a pixel is wide.
    const V3d sharp = spread_variance(
        white_edge(make_eye({.model = EyeModelKind::Pinhole}), half_slope, samples), half_slope);
    const V3d found =
        spread_variance(white_edge(navarro, half_slope, samples), half_slope) - sharp;
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(std::sqrt(found[channel]), std::sqrt(expected[channel]),
                    0.25 * pupil_m * aberration_d)
            << "channel " << channel;
    }
    EXPECT_GT(expected.z, 4.0 * expected.x) << "all channels are alike";
}

}  // namespace
}  // namespace eye_render
