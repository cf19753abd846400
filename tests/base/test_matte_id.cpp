#include "base/matte_id.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace eye_render {
namespace {

// Of the reference implementation (smhasher), seed 0.
TEST(MurmurHash, gives_the_published_values)
{
    EXPECT_EQ(murmur3_32(""), 0u);
    EXPECT_EQ(murmur3_32("test"), 0xba6bd213u);
    EXPECT_EQ(murmur3_32("Hello, world!"), 0xc0363e43u);
    EXPECT_EQ(murmur3_32("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

// Of the Cryptomatte specification's sample implementation.
TEST(MatteId, gives_the_specification_s_examples)
{
    EXPECT_FLOAT_EQ(matte_id("hello"), 6.0705627102400005616e-17f);
    EXPECT_FLOAT_EQ(matte_id("cube"), -4.08461912519e+15f);
    EXPECT_FLOAT_EQ(matte_id("sphere"), 2.79018604383e+15f);
    EXPECT_FLOAT_EQ(matte_id("plane"), 3.66557617593e-11f);
}

TEST(MatteId, is_an_ordinary_number_whatever_the_name)
{
    for (int i = 0; i < 100'000; ++i) {
        EXPECT_TRUE(std::isnormal(matte_id(std::to_string(i)))) << i;
    }
}

}  // namespace
}  // namespace eye_render
