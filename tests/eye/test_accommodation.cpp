// Amplitude by age and best focus against the vectors.

#include "eye/accommodation.h"

#include "../optics_vectors.h"

#include "optics/prescription.h"

namespace eye_render {
namespace {

using test::Json;

TEST(Accommodation, amplitude_follows_hofstetter)
{
    for (const Json& vector : test::vectors_of_kind("hofstetter")) {
        EYE_TRACE_VECTOR(vector);
        const double age_years = vector["input"]["age"];
        const Json& expected = vector["expect"];
        using enum AmplitudeFormula;
        test::expect_vector_value(accommodation_amplitude_d(age_years, HofstetterMinimum),
                                  expected["min"]);
        test::expect_vector_value(accommodation_amplitude_d(age_years, HofstetterMean),
                                  expected["mean"]);
        test::expect_vector_value(accommodation_amplitude_d(age_years, HofstetterMaximum),
                                  expected["max"]);
    }
}

TEST(Accommodation, amplitude_follows_anderson)
{
    // Anderson et al. 2008, Invest. Ophthalmol. Vis. Sci. 49: 20, 30 and 40 years.
    const auto amplitude_d = [](double age_years) {
        return accommodation_amplitude_d(age_years, AmplitudeFormula::Anderson);
    };
    EXPECT_NEAR(amplitude_d(20.0), 6.32, 0.005);
    EXPECT_NEAR(amplitude_d(30.0), 4.78, 0.005);
    EXPECT_NEAR(amplitude_d(40.0), 2.54, 0.005);
    EXPECT_EQ(amplitude_d(49.0), 0.0);
    EXPECT_EQ(amplitude_d(0.0), amplitude_d(3.0));
    EXPECT_THROW(static_cast<void>(amplitude_d(-1.0)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(amplitude_d(NAN)), std::invalid_argument);
}

TEST(Accommodation, best_focus_is_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("best_accommodation")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        const PowerMatrix rx = power_matrix_camera(
            {.sphere_d = input["S"], .cylinder_d = input["C"], .axis_deg = input["axis"]});
        const double object_vergence_d =
            input["object_m"].is_null() ? 0.0 : 1.0 / input["object_m"].get<double>();
        const double amplitude_d = input["amplitude_D"];
        const double accommodation_d =
            best_accommodation_d(PowerMatrix::sphere(-object_vergence_d) - rx, amplitude_d);
        const Json& expected = vector["expect"];
        test::expect_vector_value(accommodation_d, expected["A"]);
        test::expect_vector_value(accommodation_d - object_vergence_d - rx.mean_d(),
                                  expected["residual_M"]);
    }
}

TEST(Accommodation, an_emmetropes_far_point_is_infinitely_far_before_the_eye)
{
    EXPECT_EQ(distance_m(0.0), INFINITY);
    EXPECT_EQ(distance_m(-0.0), INFINITY);
    EXPECT_EQ(distance_m(4.0), 0.25);
    EXPECT_EQ(distance_m(-2.0), -0.5);
}

}  // namespace
}  // namespace eye_render
