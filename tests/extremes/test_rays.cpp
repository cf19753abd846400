// Every eye at every end of every input and at random in between: rays are finite or lost, and an
// eye that cannot be is refused by name, value, unit and range.

#include "trial.h"

#include "analysis/blur_ellipse.h"
#include "base/units.h"

#include <cmath>

namespace eye_render::test {
namespace {

bool is_finite(const PowerMatrix& power)
{
    return std::isfinite(power.xx_d) && std::isfinite(power.xy_d) && std::isfinite(power.yy_d);
}

testing::AssertionResult is_sound(const EyeRay& ray)
{
    const bool finite = std::isfinite(ray.slope.x) && std::isfinite(ray.slope.y) &&
                        std::isfinite(ray.origin_eye_m.x) && std::isfinite(ray.origin_eye_m.y) &&
                        std::isfinite(ray.origin_eye_m.z);
    const bool weighted = ray.weight == (ray.fate == RayFate::Transmitted ? 1.0 : 0.0);
    if (finite && weighted) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << to_string(ray.fate) << " ray from " << ray.origin_eye_m << " with slope "
           << ray.slope << " and weight " << ray.weight;
}

// How many eyes were made and rays asked for, so that no sweep passes by refusing everything.
struct Counts {
    int made = 0;
    int refused = 0;
    int rays = 0;
    int transmitted = 0;
};

void check_ray(const EyeModel& eye, const Trial& trial, Counts& counts)
{
    const EyeRay ray = ray_of(eye, trial);
    ASSERT_TRUE(is_sound(ray)) << trial;
    ++counts.rays;
    counts.transmitted += ray.fate == RayFate::Transmitted ? 1 : 0;
}

void check_blur(const EyeModel& eye, const Trial& trial)
{
    ASSERT_TRUE(is_finite(eye.retinal_conjugate_d())) << trial;
    const PowerMatrix error_d = eye.error_d(trial.object_vergence_d);
    ASSERT_TRUE(is_finite(error_d)) << trial;
    const BlurEllipse blur = blur_ellipse(error_d, eye.pupil_diameter_m());
    ASSERT_TRUE(std::isfinite(blur.major_arcmin + blur.minor_arcmin + blur.rms_radius_arcmin))
        << trial;
    ASSERT_GE(blur.major_arcmin, blur.minor_arcmin) << trial;
    ASSERT_GE(blur.minor_arcmin, 0.0) << trial;
}

void check_corner_eye(const Trial& trial, Counts& counts)
{
    const auto eye = made(trial);
    if (!eye) {
        ++counts.refused;
        return;
    }
    ++counts.made;
    at_corners(trial, std::span(&object_input, 1),
               [&](const Trial& corner) { check_blur(*eye, corner); });
    at_corners(trial, ray_inputs, [&](const Trial& corner) { check_ray(*eye, corner, counts); });
}

class Rays : public testing::TestWithParam<EyeModelKind> {
protected:
    void TearDown() override
    {
        // The schematic eyes cannot be made for most corners: their corneas would be too flat or
        // too steep for such cylinders, and Arizona's and Le Grand's lens does not give 15 D.
        EXPECT_GT(counts_.made, is_schematic(GetParam()) ? 100 : counts_.refused);
        // The rim of a wide pupil is behind the edge of the cornea or the iris at 54 degrees.
        EXPECT_GT(counts_.transmitted, counts_.rays / 3);
        RecordProperty("eyes", counts_.made);
        RecordProperty("refused", counts_.refused);
        RecordProperty("rays", counts_.rays);
        RecordProperty("transmitted", counts_.transmitted);
    }

    Counts counts_;
};

TEST_P(Rays, are_finite_or_lost_at_all_corners)
{
    for (const RxPlane plane : rx_planes) {
        at_corners({.model = GetParam(), .rx_plane = plane}, eye_inputs,
                   [&](const Trial& trial) { check_corner_eye(trial, counts_); });
    }
}

TEST_P(Rays, are_finite_or_lost_at_all_corners_of_glasses)
{
    at_corners({.model = GetParam(), .rx_plane = RxPlane::Spectacle, .glasses = true}, lens_inputs,
               [&](const Trial& lens) {
                   at_corners(lens, eye_inputs,
                              [&](const Trial& trial) { check_corner_eye(trial, counts_); });
               });
}

TEST_P(Rays, are_finite_or_lost_at_random)
{
    Random random(1);
    const int eyes = is_schematic(GetParam()) ? 600 : 3000;
    constexpr int rays_per_eye = 20;
    for (int i = 0; i < eyes; ++i) {
        Trial trial = random.trial(GetParam());
        const auto eye = made(trial);
        if (!eye) {
            ++counts_.refused;
            continue;
        }
        ++counts_.made;
        check_blur(*eye, trial);
        for (int j = 0; j < rays_per_eye; ++j) {
            random.draw(trial, ray_inputs);
            check_ray(*eye, trial, counts_);
        }
    }
}

// The eyes that trace by a fit, where they are fitted and beyond.
TEST(SchematicRays, are_finite_or_lost_when_fitted_and_near_the_exact_ones)
{
    Random random(7);
    Counts counts;
    int in_field = 0;
    for (const EyeModelKind model : eye_model_kinds) {
        if (!is_schematic(model)) continue;
        for (int i = 0; i < 12; ++i) {
            Trial exact = random.trial(model);
            exact.exact_trace = true;
            exact.zero = RefractionZero::Paraxial;
            Trial fitted = exact;
            fitted.exact_trace = false;
            const auto exact_eye = made(exact);
            const auto fitted_eye = made(fitted);
            ASSERT_EQ(exact_eye == nullptr, fitted_eye == nullptr) << fitted;
            if (!fitted_eye) continue;
            ++counts.made;
            // The eye has tried a share of the rays, and only over the pupil.
            const double fit_arcmin = 1.5 * fitted_eye->approximation_arcmin() + 1e-6;
            for (int j = 0; j < 200; ++j) {
                random.draw(fitted, ray_inputs);
                check_ray(*fitted_eye, fitted, counts);
                const EyeRay a = ray_of(*fitted_eye, fitted);
                const EyeRay b = ray_of(*exact_eye, fitted);
                const double field_deg = fitted_eye->fitted_field_deg().value_or(0.0);
                if (chief_slope(fitted).length() <= std::tan(rad_from_deg(field_deg))) {
                    EXPECT_EQ(a.fate, b.fate) << fitted;
                    ++in_field;
                }
                if (a.fate != b.fate || a.fate != RayFate::Transmitted) continue;
                EXPECT_LE(arcmin_from_rad((a.slope - b.slope).length()) /
                              (1.0 + b.slope.length2()),
                          fit_arcmin)
                    << fitted;
            }
        }
    }
    EXPECT_GT(counts.made, 10);
    EXPECT_GT(in_field, 100);
    EXPECT_GT(counts.transmitted, counts.rays / 3);
}

INSTANTIATE_TEST_SUITE_P(OfEveryEye,
                         Rays,
                         testing::ValuesIn(eye_model_kinds),
                         [](const auto& eye) { return std::string(to_string(eye.param)); });

}  // namespace
}  // namespace eye_render::test
