// A small step of the object is a small step of the blur, wherever the object is and whatever is
// worn before the eye.

#include "trial.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace eye_render::test {
namespace {

class Blur : public testing::TestWithParam<EyeModelKind> {};

TEST_P(Blur, follows_the_object_from_1_cm_through_the_glasses_to_infinity)
{
    Random random(5);
    const int count = is_schematic(GetParam()) ? 100 : 2000;
    int compared = 0;
    for (int i = 0; i < count; ++i) {
        const Trial trial = random.trial(GetParam());
        const auto eye = made(trial);
        if (!eye) continue;
        const auto lens = lens_of(trial);
        // The vergence that reaches the pupil: behind a lens of power F at d, with a = 1 - d X,
        // its derivative is at most 1 / (1 - d a F)^2. Without, X itself.
        double steepness = 1.0;
        if (lens) {
            const double left =
                1.0 - lens->distance_m *
                          std::max(0.0, lens->power_d.mean_d() + lens->power_d.astigmatism_d());
            steepness = 1.0 / (left * left);
        }
        std::vector<double> spots{0.0, trial.object_vergence_d, 1e-7};
        if (lens) spots.push_back(1.0 / lens->distance_m);
        for (const double spot_d : spots) {
            for (const double size_d : {1e-3, 1e-8, 1e-300}) {
                const double from_d = std::max(0.0, spot_d - size_d);
                const PowerMatrix change = eye->error_d(spot_d + size_d) - eye->error_d(from_d);
                const double rounding_d = 1e-13 * (1.0 + steepness) * (100.0 + spot_d);
                EXPECT_LE(std::abs(change.mean_d()) + change.astigmatism_d(),
                          1.01 * steepness * (spot_d + size_d - from_d) + rounding_d)
                    << "object at " << spot_d << " D +- " << size_d << " D, " << trial;
                ++compared;
            }
        }
        EXPECT_EQ(eye->error_d(0.0).xx_d, eye->error_d(-0.0).xx_d) << trial;
    }
    EXPECT_GT(compared, count);
}

INSTANTIATE_TEST_SUITE_P(OfEveryEye,
                         Blur,
                         testing::ValuesIn(eye_model_kinds),
                         [](const auto& eye) { return std::string(to_string(eye.param)); });

}  // namespace
}  // namespace eye_render::test
