// This scene must give this plan.

#include "render/plan.h"

#include "eye/eye_factory.h"
#include "scene_graphs.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

std::unique_ptr<const EyeModel> relaxed_eye(double sphere_d, double pupil_diameter_m)
{
    return make_eye({.model = EyeModelKind::Paraxial,
                     .rx = Prescription{.sphere_d = sphere_d},
                     .rx_plane = RxPlane::EntrancePupil,
                     .pupil_diameter_m = pupil_diameter_m});
}

RenderPlan plan_for(const SceneData& data,
                    double sphere_d,
                    std::vector<PassRequest> passes = {Pass::Combined})
{
    // 256 pixels over a slope of 0.4: 5.4 arcmin a pixel.
    RenderPlan plan = make_plan(data, std::move(passes));
    plan_lens(plan, data, test::frame(256, 0.2), *relaxed_eye(sphere_d, 4e-3));
    return plan;
}

TEST(Plan, plain_scene_without_images_starts_nothing)
{
    SceneData data;
    test::place(data, test::square(1.0f), V3d(0, 0, -50.0), test::diffuse(0.5f));
    data.world = test::even_world(1.0f);
    const RenderPlan plan = plan_for(data, 0.0);
    EXPECT_EQ(plan.images, 0u);
    EXPECT_TRUE(plan.uv_layers.empty());
    EXPECT_FALSE(plan.environment_table);
    EXPECT_FALSE(plan.transparent_shadows);
    EXPECT_FALSE(plan.emissive_meshes);
    EXPECT_NE(plan.text().find("OpenImageIO not started"), std::string::npos);
    EXPECT_FALSE(data.textures.started());
}

TEST(Plan, blur_below_a_pixel_needs_no_lens)
{
    SceneData data;
    test::place(data, test::square(1.0f), V3d(0, 0, -50.0), test::diffuse(0.5f));
    // Emmetrope, 4 mm, nothing nearer than 50 m: 0.02 D, 0.275 arcmin, a twentieth of a pixel.
    const RenderPlan sharp = plan_for(data, 0.0);
    EXPECT_NEAR(sharp.largest_blur_px, 0.004 * 0.02 / (0.4 / 256), 1e-6);
    EXPECT_FALSE(sharp.lens);
    // -3 D: 0.004 * 3 rad at infinity.
    const RenderPlan blurred = plan_for(data, -3.0);
    EXPECT_NEAR(blurred.largest_blur_px, 0.004 * 3.0 / (0.4 / 256), 1e-6);
    EXPECT_TRUE(blurred.lens);
}

// Strong plus glasses magnify, so a pixel spans less of the object: what they blur counts for
// more.
TEST(Plan, lamps_that_the_camera_sees_may_be_blurred)
{
    SceneData data;
    test::place(data, test::square(1.0f), V3d(0, 0, -50.0), test::diffuse(0.5f));
    LampData lamp = test::point_lamp(V3d(0.0, 0.0, -0.3), 1.0f);
    lamp.settings.kind = LampKind::Area;
    lamp.settings.size_x = lamp.settings.size_y = 0.01f;
    data.lamps.push_back(lamp);
    EXPECT_FALSE(plan_for(data, 0.0).lens) << "not seen";
    data.lamps[0].settings.visibility.to_camera = true;
    EXPECT_NEAR(plan_for(data, 0.0).largest_blur_px, 0.004 / 0.3 / (0.4 / 256), 1e-6);
    data.lamps[0].settings.kind = LampKind::Point;
    data.lamps[0].settings.radius = 0.1f;
    data.lamps[0].world_from_light.setScale(V3d(7.0));  // which leaves radii alone
    data.lamps[0].world_from_light[3][2] = -0.3;
    EXPECT_NEAR(plan_for(data, 0.0).largest_blur_px, 0.004 / 0.2 / (0.4 / 256), 1e-5);
    data.lamps[0].settings.radius = 0.0f;
    EXPECT_FALSE(plan_for(data, 0.0).lens) << "nothing to be seen";
}

TEST(Plan, blur_is_counted_in_the_pictures_own_slopes_behind_glasses)
{
    SceneData data;
    test::place(data, test::square(1.0f), V3d(0, 0, -10.0), test::diffuse(0.5f));
    const Prescription rx{.sphere_d = 20.0};
    const auto eye = make_eye({.rx = rx,
                               .rx_plane = RxPlane::Spectacle,
                               .vertex_m = 20e-3,
                               .pupil_diameter_m = 4e-3,
                               .worn = glasses(rx, 20e-3)});
    RenderPlan plan = make_plan(data, {Pass::Combined});
    const CameraFrame frame = test::frame(256, 0.2);
    plan_lens(plan, data, frame, *eye);
    const double blur_rad = 4e-3 * std::abs(eye->error_d(0.1).mean_d());
    EXPECT_NEAR(plan.largest_blur_px, blur_rad / frame.pixel_slope_size().x, 1e-3);
}

// The paper's eye has no colours of its own.
TEST(Plan, wavelengths_are_sampled_only_for_eyes_that_tell_them_apart)
{
    SceneData data;
    test::place(data, test::square(1.0f), V3d(0, 0, -10.0), test::diffuse(0.5f));
    for (const EyeModelKind kind : {EyeModelKind::Paper, EyeModelKind::Paraxial}) {
        RenderPlan plan = make_plan(data, {Pass::Combined});
        plan_lens(plan, data, test::frame(256, 0.2),
                  *make_eye({.model = kind, .rx = Prescription{.sphere_d = -3.0}}), true);
        EXPECT_EQ(plan.chromatic, kind == EyeModelKind::Paraxial);
    }
}

TEST(Plan, eye_inside_an_object_needs_the_lens_even_without_a_near_plane)
{
    SceneData data;
    test::place(data, test::cube(3.0f), V3d(0.0), test::diffuse(0.5f));
    for (const double clip_near : {0.0, 1e-3}) {
        CameraFrame frame = test::frame(256, 0.2);
        frame.clip_near = clip_near;
        RenderPlan plan = make_plan(data, {Pass::Combined});
        plan_lens(plan, data, frame, *relaxed_eye(0.0, 4e-3));
        EXPECT_TRUE(plan.lens) << clip_near;
    }
}

TEST(Plan, textured_glass_under_a_picture_of_the_sky)
{
    SceneData data;
    test::add_grey_picture(data);
    test::place(data, test::cube(1.0f), V3d(0, 0, -5), test::pictured(data, "UVMap"));
    test::place(data, test::square(1.0f), V3d(0, 0, -3),
                plain_material("BSDF_PRINCIPLED", {{"Alpha", V3f(0.5f)}}));
    data.world = test::pictured_world(data);
    const RenderPlan plan = plan_for(data, 0.0, {Pass::Combined, Pass::Depth, Pass::Normal});
    EXPECT_EQ(plan.images, 1u);
    EXPECT_EQ(plan.uv_layers, std::vector<std::string>{"UVMap"});
    EXPECT_TRUE(plan.environment_table);
    EXPECT_TRUE(plan.transparent_shadows);
}

TEST(Plan, instances_and_lights_are_counted)
{
    SceneData data;
    test::place(data, test::cube(0.1f), V3d(0, 0, -5), test::emissive_diffuse(0.5f, 1.0f));
    InstanceData again = data.instances.front();
    again.world_from_object.setTranslation(V3d(1, 0, -5));
    data.instances.push_back(again);
    data.lamps.push_back(test::point_lamp(V3d(0.0), 1.0f));
    const RenderPlan plan = plan_for(data, 0.0);
    EXPECT_EQ(plan.instanced_meshes, 1u);
    EXPECT_EQ(plan.placements, 2u);
    EXPECT_EQ(plan.triangles, 24u);
    EXPECT_EQ(plan.point_lamps, 1u);
    EXPECT_TRUE(plan.emissive_meshes);
}

}  // namespace
}  // namespace eye_render
