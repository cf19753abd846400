#include "estimate.h"
#include "render/path_light.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

const V3f up(0.0f, 0.0f, 1.0f);

const std::vector<PassRequest> all_light{
    Pass::DiffuseDirect,      Pass::DiffuseIndirect,      Pass::GlossyDirect, Pass::GlossyIndirect,
    Pass::TransmissionDirect, Pass::TransmissionIndirect, Pass::VolumeDirect, Pass::VolumeIndirect,
    Pass::Emission,           Pass::Environment};

Color3f value_of(const PassValues& values, Pass pass)
{
    const std::span<const float> found =
        values.channels().subspan(static_cast<std::size_t>(values.layout().first(pass)), 3);
    return {found[0], found[1], found[2]};
}

Color3f sum_of(const PassValues& values)
{
    Color3f sum(0.0f);
    for (const PassRequest& request : all_light) {
        sum += value_of(values, request.pass);
    }
    return sum;
}

TEST(PathLight, each_contribution_goes_to_the_pass_of_its_bounces)
{
    const PassLayout layout(all_light);
    PassValues values(layout);
    PathLight light(&values);
    light.add(Color3f(1.0f), {}, 0);
    light.add(Color3f(2.0f), {.is_world = true}, 0);
    light.scatter_first({.diffuse = Color3f(0.25f), .glossy = Color3f(0.25f)});
    light.add(Color3f(4.0f), {}, 1);
    light.add(Color3f(8.0f), {.is_world = true}, 3);
    EXPECT_EQ(value_of(values, Pass::Emission), Color3f(1.0f));
    EXPECT_EQ(value_of(values, Pass::Environment), Color3f(2.0f));
    EXPECT_EQ(value_of(values, Pass::DiffuseDirect), Color3f(1.0f));
    EXPECT_EQ(value_of(values, Pass::GlossyDirect), Color3f(1.0f));
    EXPECT_EQ(value_of(values, Pass::TransmissionDirect), Color3f(2.0f));
    EXPECT_EQ(value_of(values, Pass::TransmissionIndirect), Color3f(4.0f));
    EXPECT_EQ(sum_of(values), light.seen().radiance);
}

TEST(PathLight, light_that_is_not_a_number_is_in_no_pass)
{
    const PassLayout layout(all_light);
    PassValues values(layout);
    PathLight light(&values);
    light.add(Color3f(NAN, 1.0f, 1.0f), {}, 0);
    light.add(Color3f(INFINITY), {}, 0);
    EXPECT_EQ(sum_of(values), Color3f(0.0f));
    EXPECT_EQ(light.seen().radiance, Color3f(0.0f));
}

TEST(PathLight, shares_of_a_mixture_are_those_of_its_lobes_values)
{
    Bsdf bsdf(up, up);
    bsdf.add(diffuse_lobe(Color3f(0.5f, 0.2f, 0.0f), up, up), Color3f(0.5f));
    bsdf.add(glossy_lobe(Color3f(0.5f), up, 0.5f), Color3f(0.5f));
    const V3f wi = V3f(0.3f, 0.1f, 1.0f).normalized();
    const ScatterShares shares = scatter_shares(bsdf, wi);
    const BsdfParts parts = bsdf.parts(wi);
    for (int c = 0; c < 3; ++c) {
        EXPECT_FLOAT_EQ(shares.diffuse[c] + shares.glossy[c], 1.0f);
        EXPECT_FLOAT_EQ(shares.diffuse[c] * bsdf.evaluate(wi).value[c], parts.diffuse[c]);
    }
    EXPECT_EQ(shares.diffuse.z, 0.0f);
}

TEST(PathLight, glass_is_glossy_where_it_reflects_and_transmission_where_light_passes)
{
    for (const float alpha : {0.0f, 0.5f}) {
        Bsdf bsdf(up, up);
        bsdf.add(glass_lobe(Color3f(1.0f), Color3f(1.0f), up, alpha, 1.5f), Color3f(1.0f));
        for (int i = 0; i < 16; ++i) {
            SampleSequence sequence = test::sequence_of(i);
            const auto u = sequence.next();
            const auto sample = bsdf.sample(u[0], V2f(u[1], u[2]));
            if (!sample) {
                continue;  // a facet sent it below the surface
            }
            EXPECT_EQ(scatter_shares(bsdf, *sample).glossy,
                      Color3f(sample->is_transmitted ? 0.0f : 1.0f))
                << "alpha " << alpha << ", sample " << i;
        }
    }
}

// A room with all kinds of lobes, lit by a lamp, a glowing ball and the world.
TEST(PathLight, the_passes_of_every_path_add_up_to_its_radiance)
{
    SceneData data;
    test::place(data, test::square(5.0f), V3d(0, 0, -4), test::diffuse(0.8f));
    test::place(data, test::cube(0.5f), V3d(-1, 0, -3),
                plain_material("BSDF_PRINCIPLED", {{"Coat Weight", V3f(1.0f)}}));
    test::place(data, test::cube(0.5f), V3d(1, 0, -3),
                plain_material("BSDF_GLASS", {{"Roughness", V3f(0.3f)}}));
    test::place(data, test::cube(0.3f), V3d(0, 1, -2), test::emissive_diffuse(0.5f, 3.0f));
    test::place(data, test::square(0.5f), V3d(0, -1, -2), test::transparent(0.5f));
    data.world = test::even_world(0.5f);
    const Scene scene(data, V3d(0.0));
    const PassLayout layout(all_light);
    PassValues values(layout);
    for (int i = 0; i < 2000; ++i) {
        SampleSequence sequence = test::sequence_of(i);
        const auto u = sequence.next();
        values.clear();
        const Ray ray{.direction = V3f(u[0] - 0.5f, u[1] - 0.5f, -0.7f).normalized()};
        const Color3f radiance =
            trace_path(scene, {.max_bounces = 6}, ray, sequence, &values).radiance;
        const Color3f sum = sum_of(values);
        for (int c = 0; c < 3; ++c) {
            // Each of at most 10 contributions is rounded a few times.
            ASSERT_NEAR(sum[c], radiance[c], 1e-5f * radiance[c]) << "path " << i;
        }
    }
}

TEST(PathLight, a_light_group_has_the_light_of_its_lamps_objects_and_world)
{
    const PassSubjects subjects{.light_groups = {"lamps", "sky"}};
    const PassLayout layout({PassRequest(Pass::LightGroup, "sky"),
                             PassRequest(Pass::LightGroup, "lamps"),
                             PassRequest(Pass::LightGroup, "nobody's")},
                            subjects);
    PassValues values(layout);
    PathLight light(&values);
    light.add(Color3f(1.0f), {.group = 0}, 0);
    light.add(Color3f(2.0f), {.is_world = true, .group = 1}, 2);
    light.add(Color3f(4.0f), {}, 1);
    EXPECT_EQ(values.channels()[layout.first(PassRequest(Pass::LightGroup, "lamps"))], 1.0f);
    EXPECT_EQ(values.channels()[layout.first(PassRequest(Pass::LightGroup, "sky"))], 2.0f);
    EXPECT_EQ(values.channels()[layout.first(PassRequest(Pass::LightGroup, "nobody's"))], 0.0f);
    EXPECT_EQ(light.seen().radiance, Color3f(7.0f));
}

TEST(PathLight, a_light_group_has_the_glow_of_its_objects_interiors_and_of_its_world)
{
    const auto glow = [](float strength) {
        return test::filled("EMISSION", {{"Color", V3f(1.0f)}, {"Strength", V3f(strength)}});
    };
    SceneData data;
    data.light_groups = {"gas", "air"};
    test::place(data, test::cube(0.5f), V3d(0, 0, -2), glow(3.0f));
    test::place(data, test::cube(0.6f), V3d(0, 0, -2), glow(1.0f));
    data.instances[0].light_group = 0;
    const V3f absorption(0.1f);
    data.world.volume =
        test::filled("VOLUME_COEFFICIENTS", {{"Absorption Coefficients", absorption},
                                             {"Scatter Coefficients", V3f(0.0f)},
                                             {"Emission Coefficients", V3f(0.5f)}})
            .volume;
    data.world_light_group = 1;
    const Scene scene(data, V3d(0.0));
    const PassLayout layout({PassRequest(Pass::LightGroup, "gas"),
                             PassRequest(Pass::LightGroup, "air"), Pass::Emission},
                            {.light_groups = data.light_groups});
    PassValues values(layout);
    SampleSequence sequence = test::sequence_of(0);
    const Color3f radiance = trace_path(scene, {.max_bounces = 0}, {}, sequence, &values).radiance;
    const auto of = [&](std::string_view group) {
        return values.channels()[layout.first(PassRequest(Pass::LightGroup, std::string(group)))];
    };
    // Through the air in front of the gas, and the air in it.
    EXPECT_NEAR(of("gas"), 3.0f * std::exp(-0.15f) * (1.0f - std::exp(-0.1f)) / 0.1f, 1e-4f);
    EXPECT_NEAR(of("air"), 0.5f / 0.1f, 1e-4f);
    EXPECT_NEAR(radiance.x - of("gas") - of("air"),
                std::exp(-0.14f) * (1.0f - std::exp(-0.12f)) / 0.1f, 1e-4f);
    EXPECT_NEAR(values.channels()[static_cast<std::size_t>(layout.first(Pass::Emission))],
                radiance.x, 1e-5f);
}

}  // namespace
}  // namespace eye_render
