// Pictures with a wavelength for each path: what stays white, and what gets a fringe of colour.

#include "eye/eye_factory.h"
#include "render/session.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <memory>

namespace eye_render {
namespace {

constexpr int size_px = 32;
constexpr double half_slope = 0.01;  // 2 arcmin a pixel

// A white half plane, right of the middle, so far away that an emmetrope sees it sharply at the
// reference wavelength.
constexpr double distance_m = 1e4;

std::vector<float> white_edge(std::uint32_t samples)
{
    SceneData data;
    const float half_m = 0.1f * static_cast<float>(distance_m);
    test::place(data, test::square(half_m), V3d(half_m, 0.0, -distance_m),
                test::emissive_diffuse(0.0f, 1.0f));
    RenderJob job;
    job.scene = std::make_shared<Scene>(data, V3d(0.0));
    job.frame = test::frame(size_px, half_slope);
    job.eye = make_eye({.pupil_diameter_m = 6e-3});
    job.chromatic = true;
    Session session(std::move(job), {.samples = {0, samples}, .passes = {Pass::Combined}});
    session.start();
    EXPECT_TRUE(session.wait(std::chrono::seconds(60)));
    return session.snapshot().front().pixels;
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

}  // namespace
}  // namespace eye_render
