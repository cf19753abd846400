// The chromatic eye against the vectors.

#include "optics/chromatic.h"

#include "../optics_vectors.h"

namespace eye_render {
namespace {

using test::Json;

TEST(Chromatic, difference_of_refraction_is_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("thibos_chromatic_eye")) {
        EYE_TRACE_VECTOR(vector);
        test::expect_vector_value(chromatic_difference_d(vector["input"]["lambda_nm"]),
                                  vector["expect"]["delta_Rx_vs_555_D"]);
    }
}

TEST(Chromatic, nothing_differs_at_the_reference)
{
    EXPECT_EQ(chromatic_difference_d(555.0), 0.0);
    EXPECT_EQ(chromatic_difference_d(470.0, 470.0), 0.0);
    EXPECT_DOUBLE_EQ(chromatic_difference_d(450.0, 650.0), -chromatic_difference_d(650.0, 450.0));
}

TEST(Chromatic, refraction_is_zero_at_590_nm)
{
    // Where the published formula crosses 0, by its constants: 214.102 + 633.46 / 1.68524.
    EXPECT_NEAR(chromatic_difference_d(550.0, 589.99), 1.68524 - 633.46 / (550.0 - 214.102), 1e-4);
}

TEST(Chromatic, what_nobody_sees_counts_as_the_end_of_the_spectrum)
{
    EXPECT_EQ(chromatic_difference_d(214.102), chromatic_difference_d(380.0));
    EXPECT_EQ(chromatic_difference_d(1e9), chromatic_difference_d(1100.0));
}

}  // namespace
}  // namespace eye_render
