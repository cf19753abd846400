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

}  // namespace
}  // namespace eye_render
