// From observer to eye: focus, pupil, plan and what is told about them.

#include "api/engine.h"

#include "base/units.h"
#include "eye/field_luminance.h"
#include "optics/population_wavefront.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace eye_render {
namespace {

// A grey wall of radiance `radiance` at `distance` metres that fills the view.
std::shared_ptr<SceneBuilder> wall(double distance, float radiance)
{
    auto scene = std::make_shared<SceneBuilder>();
    Mesh mesh;
    mesh.name = "wall";
    mesh.positions = {{-100, -100, 0}, {100, -100, 0}, {100, 100, 0}, {-100, 100, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    NodeGraph graph;
    const std::size_t emission = graph.add("EMISSION");
    graph.set(emission, "Color", V3f(1.0f));
    graph.set(emission, "Strength", V3f(radiance));
    M44d at;
    at.setTranslation(V3d(0, 0, -distance));
    scene->add_geometry(mesh);
    scene->add_material("wall", graph, {.surface = graph.output(emission, "Emission")});
    scene->add_instance({.geometry = 0, .world_from_object = at, .materials = {0}});
    CameraFrame frame;
    frame.width_px = frame.height_px = 16;
    frame.border = {0, 0, 16, 16};
    frame.clip_near = 0.01;
    frame.clip_far = 1e6;
    scene->set_camera(frame);
    return scene;
}

Observer myope(double sphere_d)
{
    Observer observer;
    observer.eye.rx.sphere_d = sphere_d;
    observer.eye.rx_plane = RxPlane::EntrancePupil;
    observer.pupil_mm = 4.0;
    return observer;
}

TEST(Engine, accommodates_to_the_image_centre)
{
    Observer observer = myope(-1.0);
    observer.focus = FocusMode::Center;
    Engine engine(wall(0.4, 1.0f), observer, {});
    EXPECT_NEAR(engine.eye().accommodation_d, 1.0 / 0.4 - 1.0, 1e-5);
    EXPECT_NEAR(engine.eye().focus_distance_m, 0.4, 1e-6);
    EXPECT_TRUE(engine.eye().notes.empty());
}

TEST(Engine, presbyope_cannot_focus_near_and_is_told_so)
{
    Observer observer = myope(0.0);
    observer.age_years = 70.0;
    observer.focus = FocusMode::Distance;
    observer.focus_distance_m = 0.4;
    Engine engine(wall(2.0, 1.0f), observer, {});
    EXPECT_EQ(engine.eye().accommodation_d, 0.0);
    ASSERT_EQ(engine.warnings().size(), 1u);
    EXPECT_NE(engine.warnings()[0].find("2.5 D"), std::string::npos) << engine.warnings()[0];
}

TEST(Engine, model_that_accommodates_less_than_its_age_is_told_and_used)
{
    Observer observer = myope(0.0);
    observer.eye.model = EyeModelKind::Arizona;
    observer.age_years = 10.0;
    observer.focus = FocusMode::Distance;
    observer.focus_distance_m = 0.1;
    Engine engine(wall(2.0, 1.0f), observer, {});
    EXPECT_LT(engine.eye().accommodation_d, 9.0);
    EXPECT_EQ(engine.eye().accommodation_d, engine.eye().model->max_accommodation_d());
    ASSERT_EQ(engine.warnings().size(), 1u);
    EXPECT_NE(engine.warnings()[0].find("this eye model has "), std::string::npos);
}

TEST(Engine, myope_cannot_focus_beyond_the_far_point)
{
    Observer observer = myope(-3.0);
    observer.focus = FocusMode::Center;
    Engine engine(wall(10.0, 1.0f), observer, {});
    EXPECT_EQ(engine.eye().accommodation_d, 0.0);
    EXPECT_EQ(engine.warnings().size(), 1u);
}

TEST(Engine, automatic_pupil_is_the_formulas_for_the_scenes_luminance)
{
    Observer observer = myope(0.0);
    observer.pupil_mm.reset();
    Engine engine(wall(2.0, 0.5f), observer, {});
    // The wall's radiance 0.5 by 179 cd/m2, everywhere.
    EXPECT_NEAR(engine.eye().luminance_cd_m2, 89.5, 1e-3);
    const double area = field_area_deg2({.left = -0.5, .right = 0.5, .bottom = -0.5, .top = 0.5});
    const PupilSize expected =
        pupil_size(PupilFormula::WatsonYellott,
                   {.luminance_cd_m2 = 89.5, .area_deg2 = area, .age_years = observer.age_years});
    EXPECT_NEAR(engine.eye().pupil_mm, mm_from_m(expected.diameter_m), 1e-6);
    EXPECT_EQ(engine.metadata().at("pupil_formula"), "WATSON_YELLOTT");
}

TEST(Engine, automatic_pupil_answers_to_the_field_and_the_eyes_given)
{
    Observer observer = myope(0.0);
    observer.pupil_mm.reset();
    observer.field_area_deg2 = 100.0;
    observer.eyes = 1;
    Engine engine(wall(2.0, 0.5f), observer, {});
    const PupilSize expected =
        pupil_size(PupilFormula::WatsonYellott, {.luminance_cd_m2 = engine.eye().luminance_cd_m2,
                                                 .area_deg2 = 100.0,
                                                 .age_years = observer.age_years,
                                                 .eyes = 1});
    EXPECT_NEAR(engine.eye().pupil_mm, mm_from_m(expected.diameter_m), 1e-6);
    EXPECT_EQ(engine.metadata().at("field_area_deg2"), "100");
    EXPECT_EQ(engine.metadata().at("eyes"), "1");
}

TEST(Engine, clamp_of_the_pupil_is_told_and_kept_with_the_picture)
{
    Observer observer = myope(0.0);
    observer.pupil_mm.reset();
    observer.age_years = 5.0;
    Engine engine(wall(2.0, 0.5f), observer, {});
    ASSERT_EQ(engine.warnings().size(), 1u);
    EXPECT_EQ(engine.warnings()[0], "pupil: age 5 years taken as 20 years");
    EXPECT_EQ(engine.metadata().at("pupil_clamps"), "age 5 years taken as 20 years");
}

TEST(Engine, defocus_in_a_wavefront_is_told_to_be_left_out)
{
    Observer observer = myope(0.0);
    observer.eye.model = EyeModelKind::Wavefront;
    observer.eye.wavefront = Wavefront{.coefficients_um = {0, 0, 0, 0, 1.5}};
    const Engine told(wall(2.0, 1.0f), observer, {});
    ASSERT_EQ(told.warnings().size(), 1u);
    EXPECT_NE(told.warnings()[0].find("defocus and astigmatism"), std::string::npos);
    observer.eye.wavefront->coefficients_um = {0, 0, 0, 0, 0, 0, 0.1};
    EXPECT_TRUE(Engine(wall(2.0, 1.0f), observer, {}).warnings().empty());
}

TEST(Engine, automatic_pupil_is_no_wider_than_its_wavefront)
{
    Observer observer = myope(0.0);
    observer.eye.model = EyeModelKind::Wavefront;
    observer.pupil_mm.reset();
    Engine engine(wall(2.0, 1e-9f), observer, {});
    EXPECT_EQ(engine.eye().pupil_mm, 7.5);
    ASSERT_FALSE(engine.eye().pupil_clamps.empty());
    EXPECT_NE(engine.eye().pupil_clamps.back().find("wider than the wavefront's"),
              std::string::npos);
}

TEST(Engine, scene_without_any_light_is_told)
{
    const auto told = [](const std::shared_ptr<SceneBuilder>& scene) {
        return Engine(scene, myope(0.0), {}).warnings();
    };
    const std::vector<std::string> dark{"there is no light in the scene, so the picture is black"};
    EXPECT_EQ(told(wall(2.0, 0.0f)), dark);
    EXPECT_TRUE(told(wall(2.0, 0.1f)).empty());
    const auto under_the_sky = wall(2.0, 0.0f);
    NodeGraph sky;
    const std::size_t background = sky.add("BACKGROUND");
    under_the_sky->set_world(sky, {.surface = sky.output(background, "Background")});
    EXPECT_TRUE(told(under_the_sky).empty());
    const auto under_a_lamp = [&](float power) {
        const auto scene = wall(2.0, 0.0f);
        LampData lamp;
        lamp.settings.color = Color3f(power);
        scene->add_lamp(lamp);
        return told(scene);
    };
    EXPECT_EQ(under_a_lamp(0.0f), dark);
    EXPECT_TRUE(under_a_lamp(1.0f).empty());
}

TEST(Engine, eye_that_looks_far_away_accommodates_to_infinity)
{
    Observer hyperope = myope(2.0);
    hyperope.focus = FocusMode::Distance;
    hyperope.focus_distance_m = std::numeric_limits<double>::infinity();
    Engine engine(wall(2.0, 1.0f), hyperope, {});
    EXPECT_EQ(engine.eye().accommodation_d, 2.0);
    EXPECT_EQ(engine.metadata().at("focus_m"), "inf");
}

TEST(Engine, wavefront_eye_without_a_wavefront_is_the_mean_one_at_its_pupil)
{
    Observer observer = myope(-1.0);
    observer.eye.model = EyeModelKind::Wavefront;
    observer.eye.rx.eye = EyeSide::Left;
    EyeDescription mean = observer.eye;
    mean.wavefront = population_wavefront(4e-3, EyeSide::Left);
    mean.pupil_mm = 4.0;
    const V2d at_the_edge(2e-3, 0.0);
    const V2d expected = make_eye(mean)->ray(V2d(0.0), at_the_edge, 555.0).slope;
    Engine engine(wall(2.0, 1.0f), observer, {});
    EXPECT_EQ(engine.eye().model->ray(V2d(0.0), at_the_edge, 555.0).slope, expected);
    EXPECT_NE(expected.y, 0.0) << "a wavefront without coma would prove nothing";
}

TEST(Engine, darker_scene_opens_the_pupil)
{
    Observer observer = myope(0.0);
    observer.pupil_mm.reset();
    Engine bright(wall(2.0, 10.0f), observer, {});
    Engine dark(wall(2.0, 0.001f), observer, {});
    EXPECT_GT(dark.eye().pupil_mm, bright.eye().pupil_mm + 2.0);
}

TEST(Engine, metadata_names_the_observer)
{
    Observer observer = myope(-2.0);
    observer.eye.rx.cylinder_d = -0.75;
    observer.eye.rx.axis_deg = 160.0;
    Engine engine(wall(2.0, 1.0f), observer, {});
    const auto metadata = engine.metadata();
    EXPECT_EQ(metadata.at("rx"), "-2.00DS -0.75DC 160A");
    EXPECT_EQ(metadata.at("model"), "paraxial");
    EXPECT_EQ(metadata.at("pupil_mm"), "4");
}

TEST(Engine, facts_have_the_numbers_that_metadata_rounds)
{
    Observer observer = myope(-2.0);
    observer.pupil_mm = 3.123456789;
    const Engine engine(wall(2.0, 1.0f), observer, {});
    EXPECT_EQ(std::get<double>(engine.facts().at("pupil_mm")), 3.123456789);
    EXPECT_EQ(engine.metadata().at("pupil_mm"), "3.12346");
}

TEST(Engine, amplitude_is_the_least_of_what_age_and_model_allow)
{
    const auto amplitude_d = [](EyeModelKind model) {
        Observer child = myope(0.0);
        child.age_years = 8.0;
        child.eye.model = model;
        const Engine engine(wall(2.0, 1.0f), child, {});
        return std::get<double>(engine.facts().at("accommodation_amplitude_d"));
    };
    const double of_age_d = accommodation_amplitude_d(8.0, AmplitudeFormula::HofstetterMean);
    EXPECT_EQ(amplitude_d(EyeModelKind::Paraxial), of_age_d);
    EXPECT_LT(amplitude_d(EyeModelKind::Arizona), of_age_d);
}

TEST(Engine, refuses_numbers_out_of_range)
{
    const auto refusal = [](const Observer& observer, const RenderSettings& settings) {
        try {
            Engine engine(wall(2.0, 1.0f), observer, settings);
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    Observer wide = myope(0.0);
    wide.pupil_mm = 10.0;
    EXPECT_EQ(refusal(wide, {}), "pupil is 10 mm; expected 0 to 9 mm");
    Observer unknown_age = myope(0.0);
    unknown_age.age_years = std::nan("");
    EXPECT_EQ(refusal(unknown_age, {}), "age is nan years; expected 0 to 120 years");
    Observer three_eyed = myope(0.0);
    three_eyed.eyes = 3;
    EXPECT_EQ(refusal(three_eyed, {}), "eyes is 3; expected 1 to 2");
    Observer fieldless = myope(0.0);
    fieldless.field_area_deg2 = 0.0;
    EXPECT_EQ(refusal(fieldless, {}), "field_area_deg2 is 0 deg2; expected 1e-06 to 41253 deg2");
    EXPECT_EQ(refusal(myope(0.0), {.range = SampleRange{.first = 4, .last = 4}}),
              "sample range is 4:4; expected FIRST:LAST with FIRST below LAST");
    EXPECT_EQ(refusal(myope(-40.0), {}), "sphere_d is -40 D; expected -30 to 30 D");
}

}  // namespace
}  // namespace eye_render
