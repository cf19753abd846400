#include "analysis/refraction.h"

#include "../optics_vectors.h"

#include "eye/eye_factory.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

std::vector<ClearRange> ranges_of(const Prescription& rx, double amplitude_d)
{
    EyeSpec spec{.rx = rx, .rx_plane = RxPlane::EntrancePupil};
    const PowerMatrix relaxed_d = make_eye(spec)->retinal_conjugate_d();
    spec.accommodation_d = amplitude_d;
    return clear_ranges(relaxed_d, make_eye(spec)->retinal_conjugate_d());
}

TEST(ClearRanges, go_from_the_far_to_the_near_point_of_the_vectors)
{
    for (const test::Json& vector : test::vectors_of_kind("best_accommodation")) {
        EYE_TRACE_VECTOR(vector);
        const test::Json& input = vector["input"];
        const auto ranges = ranges_of(
            {.sphere_d = input["S"], .cylinder_d = input["C"], .axis_deg = input["axis"]},
            input["amplitude_D"]);
        test::expect_vector_value(ranges[0].far_d, vector["expect"]["far_vergence_D"]);
        test::expect_vector_value(ranges[0].near_d, vector["expect"]["near_vergence_D"]);
    }
}

TEST(ClearRanges, of_a_sphere_are_one)
{
    const auto ranges = ranges_of({.sphere_d = -2.0}, 4.0);
    ASSERT_EQ(ranges.size(), 1u);
    EXPECT_FALSE(ranges[0].meridian_deg.has_value());
    EXPECT_DOUBLE_EQ(ranges[0].far_d, 2.0);
    EXPECT_DOUBLE_EQ(ranges[0].near_d, 6.0);
}

TEST(ClearRanges, of_a_cylinder_are_the_mean_and_the_two_meridians)
{
    // A -2.00 -1.00 x 160 eye is 2 D too strong along its axis, which the patient sees at 20
    // degrees, and 3 D across it.
    const auto ranges = ranges_of({.sphere_d = -2.0, .cylinder_d = -1.0, .axis_deg = 160.0}, 4.0);
    ASSERT_EQ(ranges.size(), 3u);
    EXPECT_DOUBLE_EQ(ranges[0].far_d, 2.5);
    EXPECT_NEAR(ranges[1].meridian_deg.value(), 20.0, 1e-9);
    EXPECT_NEAR(ranges[1].far_d, 2.0, 1e-12);
    EXPECT_NEAR(ranges[1].near_d, 6.0, 1e-12);
    EXPECT_NEAR(ranges[2].meridian_deg.value(), 110.0, 1e-9);
    EXPECT_NEAR(ranges[2].far_d, 3.0, 1e-12);
    EXPECT_NEAR(ranges[2].near_d, 7.0, 1e-12);
}

}  // namespace
}  // namespace eye_render
