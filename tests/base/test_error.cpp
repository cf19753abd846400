// The text of a refusal.

#include "base/error.h"

#include <gtest/gtest.h>

#include <limits>

namespace eye_render {
namespace {

std::string refusal(double value)
{
    try {
        require_range("sphere_d", value, -30.0, 30.0, "D");
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Error, says_name_value_unit_and_range)
{
    EXPECT_EQ(refusal(45.5), "sphere_d is 45.5 D; expected -30 to 30 D");
    EXPECT_THROW(require_range("axis_deg", 190.0, 0.0, 180.0, ""), std::invalid_argument);
}

TEST(Error, accepts_both_ends_and_refuses_what_is_no_number)
{
    EXPECT_EQ(refusal(-30.0), "accepted");
    EXPECT_EQ(refusal(30.0), "accepted");
    EXPECT_EQ(refusal(std::numeric_limits<double>::quiet_NaN()),
              "sphere_d is nan D; expected -30 to 30 D");
    EXPECT_EQ(refusal(std::numeric_limits<double>::infinity()),
              "sphere_d is inf D; expected -30 to 30 D");
}

TEST(Error, tells_a_value_from_the_bound_it_is_just_beyond)
{
    EXPECT_EQ(refusal(30.000001), "sphere_d is 30.000001 D; expected -30 to 30 D");
    try {
        require_range("samples", 16777217, 1, 1 << 24, "");
        FAIL() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "samples is 16777217; expected 1 to 16777216");
    }
}

}  // namespace
}  // namespace eye_render
