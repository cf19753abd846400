#include "estimate.h"
#include "render/surface_passes.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

const Ray ahead{.direction = V3f(0, 0, -1)};

// Mean of the pass's channels over paths along `ahead`.
std::vector<double> mean_of_pass(const SceneData& data,
                                 Pass pass,
                                 const IntegratorSettings& settings = {})
{
    const Scene scene(data, V3d(0.0));
    const PassLayout layout({pass});
    PassValues values(layout);
    std::vector<double> mean(layout.channels());
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        SampleSequence sequence = test::sequence_of(i);
        values.clear();
        static_cast<void>(trace_path(scene, settings, ahead, sequence, &values));
        for (std::size_t channel = 0; channel < mean.size(); ++channel) {
            mean[channel] += static_cast<double>(values.channels()[channel]) / count;
        }
    }
    return mean;
}

TEST(Mist, thickens_by_each_falloff_s_formula)
{
    for (const float share : {0.0f, 0.25f, 0.5f, 1.0f}) {
        SurfacePassSettings settings{.mist_start = 4.0f, .mist_depth = 8.0f};
        const float distance = 4.0f + 8.0f * share;
        EXPECT_FLOAT_EQ(mist_at(distance, settings), share * share);
        settings.mist_falloff = MistFalloff::Linear;
        EXPECT_FLOAT_EQ(mist_at(distance, settings), share);
        settings.mist_falloff = MistFalloff::InverseQuadratic;
        EXPECT_FLOAT_EQ(mist_at(distance, settings), std::sqrt(share));
        EXPECT_EQ(mist_at(3.0f, settings), 0.0f);
        EXPECT_EQ(mist_at(13.0f, settings), 1.0f);
    }
}

TEST(Mist, is_full_where_nothing_is_and_mixes_what_is_seen_through)
{
    const IntegratorSettings settings{.surface_passes = {.mist_start = 0.0f,
                                                         .mist_depth = 10.0f,
                                                         .mist_falloff = MistFalloff::Linear}};
    SceneData data;
    constexpr double rounding = 1e-9;
    EXPECT_NEAR(mean_of_pass(data, Pass::Mist, settings)[0], 1.0, rounding);
    test::place(data, test::square(1.0f), V3d(0, 0, -2), test::transparent(0.25f));
    test::place(data, test::square(1.0f), V3d(0, 0, -6), test::diffuse(0.5f));
    // A quarter of what is behind; paths pass or end: 4 standard errors.
    EXPECT_NEAR(mean_of_pass(data, Pass::Mist, settings)[0], 0.75 * 0.2 + 0.25 * 0.6, 0.02);
}

// The part of the sky over the middle of a floor that a square ceiling of half width and height 1
// leaves free, by cosine: 1 less the view factor to a parallel square above a corner, four times.
TEST(AmbientOcclusion, is_what_a_ceiling_leaves_free_if_it_is_near)
{
    SceneData data;
    test::place(data, test::square(5.0f), V3d(0, 0, -3), test::diffuse(0.5f));
    test::place(data, test::square(1.0f), V3d(0, 0, -2), test::diffuse(0.5f));
    data.instances[1].visibility.to_camera = false;
    // Howell, "A catalog of radiation heat transfer configuration factors", B-4: an element and a
    // parallel rectangle above it, its corner over the element.
    const double x = 1.0 / std::sqrt(2.0);
    const double corner = x * std::atan(x) / std::numbers::pi;
    const double expected = 1.0 - 4.0 * corner;
    // 4 standard errors of 4000 samples of yes and no.
    EXPECT_NEAR(mean_of_pass(data, Pass::AmbientOcclusion)[0], expected, 0.032);
    const IntegratorSettings near{.surface_passes = {.occlusion_distance = 0.5f}};
    EXPECT_NEAR(mean_of_pass(data, Pass::AmbientOcclusion, near)[0], 1.0, 1e-9);
}

// A ceiling that is gone but at the shutter's middle.
TEST(AmbientOcclusion, is_that_of_the_path_s_time)
{
    SceneData data;
    test::place(data, test::square(5.0f), V3d(0, 0, -3), test::diffuse(0.5f));
    test::place(data, test::square(5.0f), V3d(0, 0, -2.9), test::diffuse(0.5f));
    data.instances[1].visibility.to_camera = false;
    const M44d over = data.instances[1].world_from_object;
    M44d aside = over;
    aside.translate(V3d(100.0, 0.0, 0.0));
    data.instances[1].motion = {aside, over, aside};
    const Scene scene(data, V3d(0.0));
    const PassLayout layout({Pass::AmbientOcclusion});
    for (const float time : {0.0f, 0.5f}) {
        PassValues values(layout);
        SampleSequence sequence = test::sequence_of(0);
        static_cast<void>(trace_path(scene, {}, {.direction = ahead.direction, .time = time},
                                     sequence, &values));
        EXPECT_EQ(values.channels()[0], time == 0.0f ? 1.0f : 0.0f) << time;
    }
}

TEST(DenoisingFeatures, a_mirror_shows_those_of_what_it_mirrors_in_its_own_colour)
{
    SceneData data;
    test::place(data, test::square(1.0f), V3d(0, 0, -2),
                plain_material("BSDF_GLOSSY",
                               {{"Color", V3f(0.5f, 1.0f, 1.0f)}, {"Roughness", V3f(0.0f)}}));
    test::place(data, test::square(1.0f), V3d(0, 0, 2), test::diffuse(0.8f));
    const auto albedo = mean_of_pass(data, Pass::DenoisingAlbedo);
    EXPECT_NEAR(albedo[0], 0.4, 1e-5);
    EXPECT_NEAR(albedo[1], 0.8, 1e-5);
    // Towards the mirror: into the picture, +Z in the camera's space.
    EXPECT_NEAR(mean_of_pass(data, Pass::DenoisingNormal)[2], 1.0, 1e-5);
}

TEST(DenoisingFeatures, what_shines_is_its_light_but_no_more_than_white)
{
    SceneData data;
    data.world = test::even_world(0.25f);
    EXPECT_NEAR(mean_of_pass(data, Pass::DenoisingAlbedo)[0], 0.25, 1e-5);
    test::place(data, test::square(1.0f), V3d(0, 0, -2), test::emission(7.0f));
    EXPECT_NEAR(mean_of_pass(data, Pass::DenoisingAlbedo)[0], 1.0, 1e-5);
}

TEST(SurfacePasses, asking_for_passes_does_not_change_the_picture)
{
    SceneData data;
    test::place(data, test::square(5.0f), V3d(0, 0, -3), test::diffuse(0.5f));
    test::place(data, test::cube(1.0f), V3d(0, 0, 2), test::emissive_diffuse(0.5f, 1.0f));
    const Scene scene(data, V3d(0.0));
    const PassLayout layout({Pass::AmbientOcclusion, Pass::Normal, Pass::DiffuseIndirect,
                             Pass::CryptoMaterial, Pass::DenoisingAlbedo});
    PassValues values(layout);
    for (int i = 0; i < 100; ++i) {
        SampleSequence plain = test::sequence_of(i);
        SampleSequence told = test::sequence_of(i);
        EXPECT_EQ(trace_path(scene, {}, ahead, plain).radiance,
                  trace_path(scene, {}, ahead, told, &values).radiance)
            << "path " << i;
    }
}

}  // namespace
}  // namespace eye_render
