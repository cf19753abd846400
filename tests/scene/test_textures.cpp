// Texture lookups against values worked out by hand and against Cycles.
//
// Cycles' values: Blender 3.4.1, an emitting plane with an Image Texture node whose alpha output
// is in use, seen by an orthographic camera over 1 um of it, 32-bit EXR. The image is
// straight_alpha_4x3.png: texel (x, y), counted from the bottom left, is
// (60 x, 100 y, 30 x y, alpha), with alpha 100 where x + y is divisible by 3 and else 255.

#include "scene/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <future>
#include <limits>
#include <thread>

namespace eye_render {
namespace {

const std::string data_dir = std::string(EYE_TEST_DATA_DIR) + "/textures/";

void expect_near(const Color4f& actual, const Color4f& expected, float tolerance, const char* what)
{
    for (int c = 0; c < 4; ++c) {
        EXPECT_NEAR(actual[c], expected[c], tolerance) << what << ", channel " << c;
    }
}

const Color4f magenta(1.0f, 0.0f, 1.0f, 1.0f);

// 2 x 2, bottom row first: red 1 2, then red 3 4; opaque.
const std::vector<float> two_by_two = {1, 0, 0, 1, 2, 0, 0, 1, 3, 0, 0, 1, 4, 0, 0, 1};

int add_two_by_two(TextureSet& set, Extension extension, Interpolation interpolation)
{
    return set.add_pixels("2x2", PixelsF32{2, 2, two_by_two},
                          {.colorspace = Colorspace::Linear,
                           .extension = extension,
                           .interpolation = interpolation});
}

TEST(Textures, openimageio_is_not_started_without_images)
{
    TextureSet set;
    EXPECT_FALSE(set.started());
    EXPECT_EQ(set.lookup(0, {0.5f, 0.5f}), magenta);
    EXPECT_FALSE(set.started());
    add_two_by_two(set, Extension::Repeat, Interpolation::Linear);
    EXPECT_TRUE(set.started());
}

TEST(Textures, lookups_are_bilinear_with_v_zero_at_the_bottom)
{
    TextureSet set;
    const int t = add_two_by_two(set, Extension::Extend, Interpolation::Linear);
    EXPECT_FLOAT_EQ(set.lookup(t, {0.25f, 0.25f}).r, 1.0f);
    EXPECT_FLOAT_EQ(set.lookup(t, {0.75f, 0.25f}).r, 2.0f);
    EXPECT_FLOAT_EQ(set.lookup(t, {0.25f, 0.75f}).r, 3.0f);
    EXPECT_FLOAT_EQ(set.lookup(t, {0.5f, 0.5f}).r, 2.5f);
    // 0.3 and 0.8 of the way between texel centres: 1 + 0.3 + 2 * 0.8.
    EXPECT_NEAR(set.lookup(t, {0.4f, 0.65f}).r, 2.9f, 1e-5f);
}

TEST(Textures, extension_modes_differ_outside)
{
    TextureSet set;
    const int repeat = add_two_by_two(set, Extension::Repeat, Interpolation::Linear);
    const int extend = add_two_by_two(set, Extension::Extend, Interpolation::Linear);
    const int clip = add_two_by_two(set, Extension::Clip, Interpolation::Linear);
    EXPECT_NEAR(set.lookup(repeat, {-0.75f, 3.25f}).r, 1.0f, 1e-5f);
    EXPECT_NEAR(set.lookup(repeat, {0.0f, 0.25f}).r, 1.5f, 1e-5f);  // between the last and first
    EXPECT_NEAR(set.lookup(extend, {-0.75f, 3.25f}).r, 3.0f, 1e-5f);
    EXPECT_NEAR(set.lookup(extend, {0.0f, 0.25f}).r, 1.0f, 1e-5f);
    expect_near(set.lookup(clip, {-0.75f, 0.25f}), Color4f(0.0f), 0.0f, "clip, outside");
    // Half of the footprint lies outside: half as opaque, of the same colour.
    expect_near(set.lookup(clip, {0.0f, 0.25f}), {1, 0, 0, 0.5f}, 1e-5f, "clip, on the edge");
}

TEST(Textures, images_without_alpha_are_clear_outside_when_clipped)
{
    TextureSet set;
    const TextureOptions clip{.colorspace = Colorspace::Linear, .extension = Extension::Clip};
    const int t = set.add_file(data_dir + "flat.hdr", clip);  // 8 x 8, three channels
    expect_near(set.lookup(t, {0.5f, 0.5f}), {3.0f, 1.5f, 0.75f, 1.0f}, 0.02f, "inside");
    expect_near(set.lookup(t, {0.0f, 0.5f}), {3.0f, 1.5f, 0.75f, 0.5f}, 0.02f, "left edge");
    expect_near(set.lookup(t, {1.0f, 1.0f}), {3.0f, 1.5f, 0.75f, 0.25f}, 0.02f, "corner");
    expect_near(set.lookup(t, {1.1f, 0.5f}), Color4f(0.0f), 0.0f, "outside");
}

TEST(Textures, closest_takes_one_texel)
{
    TextureSet set;
    const int t = add_two_by_two(set, Extension::Repeat, Interpolation::Closest);
    EXPECT_EQ(set.lookup(t, {0.49f, 0.49f}).r, 1.0f);
    EXPECT_EQ(set.lookup(t, {0.51f, 0.49f}).r, 2.0f);
    EXPECT_EQ(set.lookup(t, {-0.01f, 0.51f}).r, 4.0f);
}

TEST(Textures, srgb_is_decoded_after_interpolation)
{
    TextureSet set;
    const std::vector<std::uint8_t> black_white = {0, 0, 0, 255, 255, 255, 255, 255};
    const PixelsU8 pixels{2, 1, black_white};
    const int srgb = set.add_pixels("s", pixels, {.extension = Extension::Extend});
    const int data = set.add_pixels(
        "n", pixels, {.colorspace = Colorspace::NonColor, .extension = Extension::Extend});
    EXPECT_NEAR(set.lookup(srgb, {0.5f, 0.5f}).g, 0.214041f, 1e-5f);
    EXPECT_NEAR(set.lookup(data, {0.5f, 0.5f}).g, 0.5f, 1e-5f);
}

TEST(Textures, alpha_is_left_alone_in_data)
{
    TextureSet set;
    const std::vector<std::uint8_t> half = {200, 100, 50, 51};
    const int t = set.add_pixels("n", PixelsU8{1, 1, half}, {.colorspace = Colorspace::NonColor});
    expect_near(set.lookup(t, {0.5f, 0.5f}), {200 / 255.0f, 100 / 255.0f, 50 / 255.0f, 0.2f},
                1e-5f, "data");
    // Texel (3, 0) of the file is (180, 0, 0) with alpha 100.
    const int file =
        set.add_file(data_dir + "straight_alpha_4x3.png", {.colorspace = Colorspace::NonColor});
    expect_near(set.lookup(file, {3.5f / 4.0f, 0.5f / 3.0f}),
                {180 / 255.0f, 0.0f, 0.0f, 100 / 255.0f}, 1e-5f, "data file");
}

TEST(Textures, associated_colour_is_dimmed_before_it_is_decoded)
{
    TextureSet set;
    // Half opaque, but for rounding: 128 of 255 of 200 is 100.
    const std::vector<std::uint8_t> half = {200, 200, 200, 128};
    const PixelsU8 pixels{1, 1, half};
    const V2f middle(0.5f, 0.5f);
    const int bytes = set.add_pixels("b", pixels, {});
    EXPECT_NEAR(set.lookup(bytes, middle, TextureAlpha::Associated).r, 0.127438f, 1e-5f);
    // 100 over 128 is 199.2 of 255.
    EXPECT_NEAR(set.lookup(bytes, middle, TextureAlpha::Straight).r, 0.572533f, 1e-5f);
    // Other numbers come dimmed, and are linear.
    const std::vector<float> dimmed = {2.0f, 1.0f, 0.5f, 0.5f};
    const int floats =
        set.add_pixels("f", PixelsF32{1, 1, dimmed}, {.colorspace = Colorspace::Linear});
    expect_near(set.lookup(floats, middle, TextureAlpha::Associated), {2.0f, 1.0f, 0.5f, 0.5f},
                1e-6f, "associated");
    expect_near(set.lookup(floats, middle), {4.0f, 2.0f, 1.0f, 0.5f}, 1e-6f, "straight");
}

TEST(Textures, are_in_the_working_space)
{
    TextureSet set(WorkingSpace::AcesCg);
    const std::vector<float> red = {1.0f, 0.0f, 0.0f, 1.0f};
    const auto read_as = [&](Colorspace colorspace) {
        return set.lookup(set.add_pixels("r", PixelsF32{1, 1, red}, {.colorspace = colorspace}),
                          V2f(0.5f));
    };
    const Color4f converted(0.613097f, 0.070194f, 0.020616f, 1.0f);
    expect_near(read_as(Colorspace::Srgb), converted, 1e-4f, "sRGB");
    expect_near(read_as(Colorspace::LinearRec709), converted, 1e-4f, "Rec. 709");
    expect_near(read_as(Colorspace::Linear), {1.0f, 0.0f, 0.0f, 1.0f}, 0.0f, "already");
    expect_near(read_as(Colorspace::NonColor), {1.0f, 0.0f, 0.0f, 1.0f}, 0.0f, "data");
}

TEST(Textures, alpha_that_is_packed_or_ignored_dims_nothing)
{
    TextureSet set;
    for (const TextureAlpha use : {TextureAlpha::Straight, TextureAlpha::Associated}) {
        const int packed =
            set.add_file(data_dir + "straight_alpha_4x3.png",
                         {.interpolation = Interpolation::Closest, .alpha = AlphaChannel::Packed});
        const int ignored = set.add_file(
            data_dir + "straight_alpha_4x3.png",
            {.interpolation = Interpolation::Closest, .alpha = AlphaChannel::Ignored});
        // Texel (3, 0) is (180, 0, 0) with alpha 100.
        const V2f texel(3.5f / 4.0f, 0.5f / 3.0f);
        expect_near(set.lookup(packed, texel, use), {0.45641f, 0.0f, 0.0f, 100 / 255.0f}, 1e-5f,
                    "packed");
        expect_near(set.lookup(ignored, texel, use), {0.45641f, 0.0f, 0.0f, 1.0f}, 1e-5f,
                    "ignored");
    }
}

TEST(Textures, cubic_is_the_uniform_b_spline)
{
    TextureSet set;
    // One bright texel: the spline itself, of which 2/3 is the middle and 1/6 is a texel away.
    std::vector<float> spot(4 * 9 * 9, 0.0f);
    for (std::size_t i = 3; i < spot.size(); i += 4) {
        spot[i] = 1.0f;
    }
    spot[4 * (9 * 4 + 4)] = 1.0f;
    const auto spline = [](float x) {
        const float a = std::abs(x);
        return a < 1.0f   ? (4.0f - 6.0f * a * a + 3.0f * a * a * a) / 6.0f
               : a < 2.0f ? (2.0f - a) * (2.0f - a) * (2.0f - a) / 6.0f
                          : 0.0f;
    };
    const TextureOptions cubic{.colorspace = Colorspace::Linear,
                               .interpolation = Interpolation::Cubic};
    const int t = set.add_pixels("spot", PixelsF32{9, 9, spot}, cubic);
    for (const V2f& texels : {V2f(0, 0), V2f(1, 0), V2f(0.3f, -0.6f), V2f(-1.7f, 1.2f)}) {
        const V2f uv = (V2f(4.5f) + texels) / 9.0f;
        EXPECT_NEAR(set.lookup(t, uv).r, spline(texels.x) * spline(texels.y), 1e-5f) << texels;
    }
    // Of an image without alpha that is clipped, as much shows as of the spline lies on it.
    const int clipped =
        set.add_file(data_dir + "flat.hdr", {.colorspace = Colorspace::Linear,
                                             .extension = Extension::Clip,
                                             .interpolation = Interpolation::Cubic});
    EXPECT_NEAR(set.lookup(clipped, {0.0f, 0.5f}).a, 0.5f, 1e-5f);
    EXPECT_NEAR(set.lookup(clipped, {0.5f / 8.0f, 0.5f}).a, 5.0f / 6.0f, 1e-5f);
    EXPECT_NEAR(set.lookup(clipped, {-0.5f / 8.0f, 0.5f}).a, 1.0f / 6.0f, 1e-5f);
    EXPECT_EQ(set.lookup(clipped, {-1.6f / 8.0f, 0.5f}).a, 0.0f);
}

TEST(Textures, lookups_agree_with_cycles)
{
    using enum Extension;
    using enum Interpolation;
    struct Figure {
        Interpolation interpolation;
        Extension extension;
        V2f uv;
        Color3f color;
    };
    const Figure figures[] = {
        {Linear, Repeat, {0.3f, 0.4f}, {0.02564f, 0.06857f, 0.00500f}},
        {Linear, Repeat, {0.02f, 0.5f}, {0.07150f, 0.12744f, 0.01920f}},
        {Linear, Repeat, {-0.05f, 0.5f}, {0.20864f, 0.12744f, 0.04971f}},
        {Linear, Repeat, {-0.2f, 0.5f}, {0.40907f, 0.12723f, 0.09192f}},
        {Linear, Repeat, {0.7f, 0.98f}, {0.23937f, 0.19383f, 0.08870f}},
        {Linear, Repeat, {1.03f, 1.02f}, {0.05816f, 0.23613f, 0.02692f}},
        {Linear, Extend, {0.3f, 0.4f}, {0.02564f, 0.06857f, 0.00500f}},
        {Linear, Extend, {-0.2f, 0.5f}, {0.0f, 0.12744f, 0.0f}},
        {Linear, Extend, {0.7f, 0.98f}, {0.25415f, 0.57758f, 0.25415f}},
        {Linear, Extend, {1.03f, 1.02f}, {0.45641f, 0.57758f, 0.45641f}},
        {Linear, Clip, {0.3f, 0.4f}, {0.02564f, 0.06857f, 0.00500f}},
        {Linear, Clip, {0.02f, 0.5f}, {0.0f, 0.12744f, 0.0f}},
        {Linear, Clip, {-0.05f, 0.5f}, {0.0f, 0.12744f, 0.0f}},
        {Linear, Clip, {-0.2f, 0.5f}, {0.0f, 0.0f, 0.0f}},
        {Linear, Clip, {0.7f, 0.98f}, {0.25415f, 0.57758f, 0.25415f}},
        {Linear, Clip, {1.03f, 1.02f}, {0.45641f, 0.57758f, 0.45641f}},
        {Closest, Repeat, {0.3f, 0.4f}, {0.04519f, 0.12744f, 0.01298f}},
        {Closest, Repeat, {0.02f, 0.5f}, {0.0f, 0.12744f, 0.0f}},
        {Closest, Repeat, {-0.05f, 0.5f}, {0.45641f, 0.12744f, 0.10224f}},
        {Closest, Repeat, {0.7f, 0.98f}, {0.18782f, 0.57758f, 0.18782f}},
        {Closest, Repeat, {1.03f, 1.02f}, {0.0f, 0.0f, 0.0f}},
    };
    TextureSet set;
    for (const Figure& f : figures) {
        const int t = set.add_file(data_dir + "straight_alpha_4x3.png",
                                   {.extension = f.extension, .interpolation = f.interpolation});
        const Color4f actual = set.lookup(t, f.uv);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(actual[c], f.color[c], 1e-4f)
                << "uv " << f.uv << ", extension " << int(f.extension) << ", channel " << c;
        }
    }
    EXPECT_TRUE(set.warnings().empty());
}

TEST(Textures, pixels_and_the_file_they_came_from_look_the_same)
{
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            const int alpha = (x + y) % 3 == 0 ? 100 : 255;
            for (const int value : {60 * x, 100 * y, 30 * x * y, alpha}) {
                rgba.push_back(static_cast<std::uint8_t>(value));
            }
        }
    }
    TextureSet set;
    const int pixels = set.add_pixels("packed", PixelsU8{4, 3, rgba}, {});
    const int file = set.add_file(data_dir + "straight_alpha_4x3.png", {});
    for (float v = -0.3f; v < 1.3f; v += 0.07f) {
        for (float u = -0.3f; u < 1.3f; u += 0.07f) {
            expect_near(set.lookup(pixels, {u, v}), set.lookup(file, {u, v}), 1e-6f, "packed");
        }
    }
}

TEST(Textures, jpeg_and_radiance_files_are_read)
{
    TextureSet set;
    const int jpeg = set.add_file(data_dir + "flat.jpg", {.colorspace = Colorspace::NonColor});
    const int hdr = set.add_file(data_dir + "flat.hdr", {.colorspace = Colorspace::Linear});
    expect_near(set.lookup(jpeg, {0.5f, 0.5f}), {0.5f, 0.25f, 0.125f, 1.0f}, 0.01f, "jpeg");
    expect_near(set.lookup(hdr, {0.5f, 0.5f}), {3.0f, 1.5f, 0.75f, 1.0f}, 0.02f, "hdr");
    EXPECT_TRUE(set.warnings().empty());
}

TEST(Textures, unreadable_files_are_magenta_with_one_warning_each)
{
    const auto folder = std::filesystem::path(testing::TempDir());
    const std::string not_an_image = (folder / "eye_render_not_an_image.png").string();
    std::ofstream(not_an_image) << "this is no picture";
    TextureSet set;
    const int missing = set.add_file("/nowhere/missing.png", {});
    const int broken = set.add_file(not_an_image, {});
    for (const int t : {missing, broken, missing}) {
        EXPECT_EQ(set.lookup(t, {0.5f, 0.5f}), magenta);
    }
    ASSERT_EQ(set.warnings().size(), 2u);
    EXPECT_NE(set.warnings()[0].find("/nowhere/missing.png"), std::string::npos);
    EXPECT_NE(set.warnings()[1].find(not_an_image), std::string::npos);
    EXPECT_EQ(set.width(missing), 1);
    std::filesystem::remove(not_an_image);
}

TEST(Textures, a_file_cut_short_never_throws_and_warns_once)
{
    const std::string whole = data_dir + "directions_8x4.exr";
    const auto cut = std::filesystem::path(testing::TempDir()) / "eye_render_cut.exr";
    std::filesystem::copy_file(whole, cut, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(cut, std::filesystem::file_size(whole) / 2);
    TextureSet set;
    const int t = set.add_file(cut.string(), {.colorspace = Colorspace::Linear});
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(set.lookup(t, {0.5f, 0.05f}), magenta);
    }
    EXPECT_EQ(set.warnings().size(), 1u);
    std::filesystem::remove(cut);
}

TEST(Textures, uv_beyond_reason_gives_an_answer)
{
    TextureSet set;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const Extension extension : {Extension::Repeat, Extension::Extend, Extension::Clip}) {
        const int t = add_two_by_two(set, extension, Interpolation::Linear);
        EXPECT_EQ(set.lookup(t, {NAN, 0.0f}), magenta);
        EXPECT_EQ(set.lookup(t, {0.0f, infinity}), magenta);
        for (const float huge : {1e8f, -1e20f, std::numeric_limits<float>::max()}) {
            const Color4f c = set.lookup(t, {huge, 0.3f});
            EXPECT_TRUE(c.r >= 0.0f && c.r <= 4.0f) << huge;
        }
    }
}

TEST(Textures, pixels_that_do_not_fit_their_size_are_refused)
{
    TextureSet set;
    EXPECT_THROW(set.add_pixels("short", PixelsF32{2, 3, two_by_two}, {}), std::invalid_argument);
    EXPECT_THROW(set.add_pixels("empty", PixelsF32{0, 0, {}}, {}), std::invalid_argument);
}

TEST(Textures, threads_see_the_same_as_one)
{
    TextureSet set;
    const int t = set.add_file(data_dir + "straight_alpha_4x3.png", {});
    const auto sum_of_lookups = [&] {
        double sum = 0.0;
        for (int i = 0; i < 20000; ++i) {
            sum += double(set.lookup(t, {float(i) * 0.013f, float(i) * 0.007f}).g);
        }
        return sum;
    };
    std::vector<double> sums(4);
    std::vector<std::thread> threads;
    for (double& sum : sums) {
        threads.emplace_back([&] { sum = sum_of_lookups(); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const double sum : sums) {
        EXPECT_EQ(sum, sum_of_lookups());
    }
}

TEST(Textures, a_thread_that_outlives_a_set_sees_nothing_of_it_in_the_next)
{
    // Enough sets for one to be where an earlier one was.
    constexpr int sets = 16;
    std::array<std::promise<TextureSet*>, sets> asked;
    std::array<std::promise<Color4f>, sets> looked_up;
    std::thread worker([&] {
        for (std::size_t i = 0; i < sets; ++i) {
            const TextureSet& set = *asked[i].get_future().get();
            looked_up[i].set_value(set.lookup(0, {0.5f, 0.5f}));
        }
    });
    for (std::size_t i = 0; i < sets; ++i) {
        const auto value = static_cast<float>(i);
        const std::vector<float> pixel = {value, value, value, 1.0f};
        TextureSet set;
        set.add_pixels("pixel", PixelsF32{1, 1, pixel}, {.colorspace = Colorspace::Linear});
        asked[i].set_value(&set);
        EXPECT_EQ(looked_up[i].get_future().get(), Color4f(value, value, value, 1.0f));
    }
    worker.join();
}

TEST(Textures, width_is_the_files_in_pixels)
{
    TextureSet set;
    EXPECT_EQ(set.width(set.add_file(data_dir + "directions_8x4.exr", {})), 8);
    EXPECT_EQ(set.width(add_two_by_two(set, Extension::Repeat, Interpolation::Linear)), 2);
    EXPECT_EQ(set.width(99), 1);
}

}  // namespace
}  // namespace eye_render
