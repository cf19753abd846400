// Accommodation for the least blur, against the blur beside it and against closed forms.

#include "analysis/least_blur.h"

#include "eyes.h"

#include "analysis/spot.h"
#include "analysis/through_focus.h"
#include "base/units.h"
#include "eye/eye_factory.h"
#include "optics/population_wavefront.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace eye_render {
namespace {

constexpr double near_d = 2.5;

EyeSpec spec_of(EyeModelKind model, double accommodation_d)
{
    EyeSpec spec{.model = model,
                 .pupil_diameter_m = 6e-3,
                 .accommodation_d = accommodation_d,
                 .exact_trace = true};
    if (model == EyeModelKind::Wavefront) spec.wavefront = population_wavefront(6e-3);
    return spec;
}

double rms_arcmin(const EyeModel& eye, double object_vergence_d)
{
    // Many more rays than the search has.
    const PupilTrace trace = trace_pupil(eye, {.samples = 2048});
    return arcmin_from_rad(spot_moments(make_spot(trace, object_vergence_d)).rms_radius_rad());
}

class LeastBlur : public testing::TestWithParam<EyeModelKind> {};

TEST_P(LeastBlur, is_no_more_than_a_tenth_of_a_dioptre_beside_it)
{
    const auto eye_at = [](double a_d) { return make_eye(spec_of(GetParam(), a_d)); };
    for (const double object_d : {0.0, 1.0, near_d, 4.0}) {
        constexpr double amplitude_d = 6.0;
        constexpr double beside_d = 0.1;
        const double a_d = least_blur_accommodation_d(eye_at, object_d, amplitude_d);
        ASSERT_GE(a_d, 0.0);
        ASSERT_LE(a_d, amplitude_d);
        const double least_arcmin = rms_arcmin(*eye_at(a_d), object_d);
        for (const double other_d : {a_d - beside_d, a_d + beside_d}) {
            if (other_d < 0.0 || other_d > amplitude_d) continue;
            EXPECT_LE(least_arcmin, rms_arcmin(*eye_at(other_d), object_d))
                << "accommodates by " << a_d << " D for an object at " << object_d << " D";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OfEveryEyeWithAberrations,
                         LeastBlur,
                         testing::Values(EyeModelKind::Wavefront,
                                         EyeModelKind::Navarro,
                                         EyeModelKind::Arizona,
                                         EyeModelKind::LeGrand),
                         [](const auto& eye) { return std::string(to_string(eye.param)); });

TEST(LeastBlur, is_far_below_that_of_the_paraxial_focus)
{
    // Le Grand's spherical surfaces, 6 mm: 21 arcmin at the paraxial focus, 7 when relaxed.
    const auto eye_at = [](double a_d) { return make_eye(spec_of(EyeModelKind::LeGrand, a_d)); };
    const double a_d = least_blur_accommodation_d(eye_at, near_d, 6.0);
    EXPECT_LT(rms_arcmin(*eye_at(a_d), near_d), 0.4 * rms_arcmin(*eye_at(near_d), near_d));
}

// Accommodation adds a sphere to a thin eye and changes nothing else.
TEST(LeastBlur, of_a_thin_eye_is_what_its_best_focus_lacks)
{
    for (const bool has_wavefront : {false, true}) {
        const auto eye_at = [&](double a_d) {
            return make_eye(
                spec_of(has_wavefront ? EyeModelKind::Wavefront : EyeModelKind::Paraxial, a_d));
        };
        const double best_d = through_focus(*eye_at(0.0)).best_focus_d.value();
        // 128 points of the pupil instead of 4096.
        constexpr double sampling_d = 0.02;
        EXPECT_NEAR(least_blur_accommodation_d(eye_at, near_d, 8.0), near_d - best_d, sampling_d);
    }
}

TEST(LeastBlur, beyond_what_the_amplitude_allows_is_at_its_ends)
{
    const auto eye_at = [](double a_d) { return make_eye(spec_of(EyeModelKind::Wavefront, a_d)); };
    EXPECT_EQ(least_blur_accommodation_d(eye_at, 9.0, 2.0), 2.0);
    EXPECT_EQ(least_blur_accommodation_d(eye_at, -9.0, 2.0), 0.0);
    EXPECT_EQ(least_blur_accommodation_d(eye_at, 9.0, 0.0), 0.0);
}

TEST(LeastBlur, is_sought_among_the_eyes_that_there_are)
{
    constexpr double most_d = 3.0;
    const auto eye_at = [](double a_d) {
        if (a_d > most_d) throw std::invalid_argument("accommodation_d");
        return make_eye(spec_of(EyeModelKind::Paraxial, a_d));
    };
    EXPECT_NEAR(least_blur_accommodation_d(eye_at, 2.0, 10.0), 2.0, 1e-6);
    const auto none = [](double) -> std::unique_ptr<EyeModel> {
        return std::make_unique<test::ClosedEye>();
    };
    EXPECT_EQ(least_blur_accommodation_d(none, 2.0, 10.0), 0.0);
}

}  // namespace
}  // namespace eye_render
