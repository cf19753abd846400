// A session's picture depends on scene, eye, seed and sample numbers, and on nothing else.

#include "render/session.h"

#include "eye/eye_factory.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

std::shared_ptr<const Scene> small_hall(const SceneData& data)
{
    return std::make_shared<Scene>(data, V3d(0.0));
}

SceneData small_hall_data()
{
    SceneData data;
    test::place(data, test::cube(5.0f), V3d(0.0), test::diffuse(0.6f));
    test::place(data, test::cube(0.5f), V3d(0.7, 0.2, -2.0), test::diffuse(0.3f));
    test::place(data, test::square(0.5f), V3d(-1.0, 1.0, -4.0),
                test::emissive_diffuse(0.0f, 9.0f));
    data.lamps.push_back(test::point_lamp(V3d(1.0, 2.0, -1.0), 50.0f));
    return data;
}

RenderJob job_for(const std::shared_ptr<const Scene>& scene, int size_px)
{
    RenderJob job;
    job.scene = scene;
    job.frame = test::frame(size_px, 0.5);
    job.eye = make_eye({.model = EyeModelKind::Paraxial,
                        .rx = Prescription{.sphere_d = -1.0, .cylinder_d = -1.0, .axis_deg = 30.0},
                        .pupil_diameter_m = 5e-3});
    job.seed = 3;
    return job;
}

std::vector<float> render(RenderJob job, SampleRange samples, int threads)
{
    Session session(std::move(job),
                    {.samples = samples, .passes = {Pass::Combined}, .threads = threads});
    session.start();
    EXPECT_TRUE(session.wait(std::chrono::seconds(60)));
    EXPECT_EQ(session.error(), std::nullopt);
    EXPECT_EQ(session.samples_done(), samples.last - samples.first);
    return session.snapshot().front().pixels;
}

TEST(Session, any_number_of_threads_gives_the_same_image)
{
    const SceneData data = small_hall_data();
    const auto scene = small_hall(data);
    const auto one = render(job_for(scene, 50), {0, 11}, 1);
    EXPECT_EQ(one, render(job_for(scene, 50), {0, 11}, 2));
    EXPECT_EQ(one, render(job_for(scene, 50), {0, 11}, 0));
}

TEST(Session, border_shows_the_same_pixels_as_the_full_frame)
{
    const SceneData data = small_hall_data();
    const auto scene = small_hall(data);
    const auto full = render(job_for(scene, 50), {0, 4}, 2);
    RenderJob part = job_for(scene, 50);
    part.frame.border = {13, 29, 41, 50};
    const auto window = render(part, {0, 4}, 2);
    for (std::size_t y = 0; y < 21; ++y) {
        for (std::size_t x = 0; x < 28; ++x) {
            const std::size_t at_window = 4 * (28 * y + x);
            const std::size_t at_full = 4 * (50 * (y + 29) + x + 13);
            ASSERT_EQ(window[at_window], full[at_full]) << x << ", " << y;
        }
    }
}

TEST(Session, sample_ranges_add_up_to_the_whole)
{
    const SceneData data = small_hall_data();
    const auto scene = small_hall(data);
    const auto whole = render(job_for(scene, 40), {0, 12}, 2);
    const auto first = render(job_for(scene, 40), {0, 5}, 2);
    const auto rest = render(job_for(scene, 40), {5, 12}, 2);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        // Each picture is rounded to float once: three roundings of half a unit in the last place.
        const float merged = (5.0f * first[i] + 7.0f * rest[i]) / 12.0f;
        ASSERT_NEAR(merged, whole[i], 4e-7f * (1.0f + std::abs(whole[i]))) << i;
    }
}

TEST(Session, another_seed_gives_another_image)
{
    const SceneData data = small_hall_data();
    const auto scene = small_hall(data);
    RenderJob other = job_for(scene, 20);
    other.seed = 4;
    EXPECT_NE(render(job_for(scene, 20), {0, 4}, 2), render(other, {0, 4}, 2));
}

TEST(Session, cancel_ends_it_at_once_with_a_usable_picture)
{
    const SceneData data = small_hall_data();
    Session session(job_for(small_hall(data), 512),
                    {.samples = {0, 1000000}, .passes = {Pass::Combined}});
    session.start();
    EXPECT_FALSE(session.wait(std::chrono::milliseconds(300)));
    session.cancel();
    // Users expect 0.2 s; a loaded machine gets five times that.
    EXPECT_TRUE(session.wait(std::chrono::seconds(1)));
    EXPECT_LT(session.samples_done(), 1000000u);
}

TEST(Session, chief_passes_hold_depth_defocus_and_blur)
{
    SceneData data;
    test::place(data, test::square(10.0f), V3d(0, 0, -2.0), test::diffuse(0.5f));
    RenderJob job = job_for(small_hall(data), 9);
    job.eye = make_eye({.model = EyeModelKind::Paraxial,
                        .rx = Prescription{.sphere_d = -3.0},
                        .rx_plane = RxPlane::EntrancePupil,
                        .pupil_diameter_m = 4e-3});
    const std::vector<PassRequest> passes{Pass::Depth, Pass::Defocus, Pass::Blur};
    job.passes = PassLayout(passes);
    Session session(std::move(job), {.samples = {0, 1}, .passes = passes});
    session.start();
    ASSERT_TRUE(session.wait(std::chrono::seconds(60)));
    const auto images = session.snapshot();
    for (std::size_t i = 0; i < 81; ++i) {
        EXPECT_NEAR(images[0].pixels[i], 2.0f, 1e-5f);
        EXPECT_NEAR(images[1].pixels[i], 3.0f - 0.5f, 1e-5f);
        // 3.4377 arcmin a millimetre and dioptre.
        EXPECT_NEAR(images[2].pixels[i], 3.4377468f * 4.0f * 2.5f, 1e-3f);
    }
}

}  // namespace
}  // namespace eye_render
