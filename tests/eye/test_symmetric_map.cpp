#include "eye/symmetric_map.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

TEST(SymmetricMap, is_exact_for_polynomials_of_its_form)
{
    const auto function = [](const V2d& p) -> Sought {
        const double xx = p.x * p.x;
        const double yy = p.y * p.y;
        return {.value = {p.x * (0.8 + 3.0 * xx - yy * yy), p.y * (0.7 - xx * yy + yy)}};
    };
    const auto map = SymmetricMap::fitted(function, 0.5);
    ASSERT_TRUE(map.has_value());
    for (const V2d& p : {V2d(0.0), V2d(0.3, 0.2), V2d(-0.1, 0.45), V2d(-0.2, -0.3)}) {
        EXPECT_NEAR(((*map)(p)-function(p).value).length(), 0.0, 1e-13) << p;
    }
}

TEST(SymmetricMap, is_not_made_of_lost_rays)
{
    EXPECT_FALSE(SymmetricMap::fitted(
                     [](const V2d& p) -> Sought {
                         return {p.length() < 0.9 ? TraceFate::Passed : TraceFate::Vignetted, p};
                     },
                     1.0)
                     .has_value());
}

}  // namespace
}  // namespace eye_render
