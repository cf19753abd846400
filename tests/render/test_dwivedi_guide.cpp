#include "render/dwivedi_guide.h"

#include "base/sobol.h"

#include <gtest/gtest.h>

#include <array>

namespace eye_render {
namespace {

TEST(DwivediGuide, directions_are_spread_as_their_density_says)
{
    const V3f outwards = V3f(0.3f, -0.5f, 0.7f).normalized();
    for (const float albedo : {0.2f, 0.7f, 0.99f, 0.999999f}) {
        const DwivediGuide guide(albedo);
        constexpr std::size_t cells = 16;
        constexpr std::uint32_t count = 1 << 14;
        std::array<double, cells> found{};
        for (std::uint32_t i = 0; i < count; ++i) {
            const auto u = sobol_4d(1, i, 0);
            const V3f wi = guide.sample(outwards, V2f(u[0], u[1]));
            ASSERT_NEAR(wi.length(), 1.0f, 1e-5f) << "albedo " << albedo;
            const float place = 0.5f * (1.0f + wi.dot(outwards)) * cells;
            found[std::min(static_cast<std::size_t>(std::max(place, 0.0f)), cells - 1)] +=
                1.0 / count;
        }
        // Cosines are given in closed form where the density grows without end.
        const auto below = [&](double cosine) {
            const double length = static_cast<double>(guide.diffusion_length());
            return 1.0 - std::log((length - cosine) / (length - 1.0)) /
                             std::log((length + 1.0) / (length - 1.0));
        };
        for (std::size_t cell = 0; cell < cells; ++cell) {
            const double from = 2.0 * static_cast<double>(cell) / cells - 1.0;
            EXPECT_NEAR(found[cell], below(from + 2.0 / cells) - below(from), 2e-3)
                << "albedo " << albedo << ", cosine " << from;
        }
        // And the density is its slope.
        constexpr double step = 1e-3;
        for (const double cosine : {-0.9, 0.0, 0.5}) {
            const double slope = (below(cosine + step) - below(cosine - step)) /
                                 (2.0 * step * 2.0 * std::numbers::pi);
            EXPECT_NEAR(static_cast<double>(guide.pdf(static_cast<float>(cosine))), slope,
                        1e-3 * slope)
                << "albedo " << albedo << ", cosine " << cosine;
        }
    }
}

TEST(DwivediGuide, flights_are_longer_on_the_way_out)
{
    const DwivediGuide guide(0.9f);
    EXPECT_LT(guide.extinction_factor(1.0f), 1.0f);
    EXPECT_GT(guide.extinction_factor(1.0f), 0.0f);
    EXPECT_FLOAT_EQ(guide.extinction_factor(0.0f), 1.0f);
    EXPECT_GT(guide.extinction_factor(-1.0f), 1.0f);
}

}  // namespace
}  // namespace eye_render
