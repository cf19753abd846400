// Prescription algebra at the ends of its ranges and near its singular places, and the parser
// under garbage.

#include "trial.h"

#include "optics/prescription_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace eye_render::test {
namespace {

constexpr int trials = 20000;

double norm_d(const PowerMatrix& power)
{
    return std::abs(power.mean_d()) + power.astigmatism_d();
}

// Relative to `scale_d`, the strongest lens on the way.
testing::AssertionResult are_same(const PowerMatrix& a, const PowerMatrix& b, double scale_d)
{
    constexpr double relative = 1e-12;
    if (norm_d(a - b) <= relative * (scale_d + 1e-12)) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "[" << a.xx_d << ' ' << a.xy_d << ' ' << a.yy_d << "] and [" << b.xx_d << ' '
           << b.xy_d << ' ' << b.yy_d << "] differ by " << norm_d(a - b) << " D";
}

Prescription any_prescription(Random& random)
{
    Trial trial;
    random.draw(trial, eye_inputs);
    return {
        .sphere_d = trial.sphere_d, .cylinder_d = trial.cylinder_d, .axis_deg = trial.axis_deg};
}

TEST(PrescriptionExtremes, all_forms_are_one_lens)
{
    Random random(41);
    for (int i = 0; i < trials; ++i) {
        const Prescription rx = any_prescription(random);
        SCOPED_TRACE(format_prescription(rx));
        const PowerMatrix power = power_matrix_tabo(rx);
        const double scale_d = norm_d(power) + std::abs(rx.sphere_d);
        EXPECT_TRUE(are_same(power_matrix_tabo(transposed(rx)), power, scale_d));
        EXPECT_TRUE(are_same(power_matrix_tabo(transposed(transposed(rx))), power, scale_d));
        EXPECT_TRUE(are_same(mirrored(power_matrix_camera(rx)), power, 0.0));
        for (const CylinderForm form : {CylinderForm::Minus, CylinderForm::Plus}) {
            const Prescription back = prescription_from(power, form);
            EXPECT_TRUE(are_same(power_matrix_tabo(back), power, scale_d));
            EXPECT_GT(back.axis_deg, 0.0);
            EXPECT_LE(back.axis_deg, 180.0);
            EXPECT_TRUE(form == CylinderForm::Minus ? back.cylinder_d <= 0.0
                                                    : back.cylinder_d >= 0.0);
        }
    }
}

// Against the closed form P / (1 - d P) of both meridians, up to a tenth of the focal length.
TEST(PrescriptionExtremes, a_lens_is_moved_up_to_its_focus_and_back)
{
    Random random(42);
    for (int i = 0; i < trials; ++i) {
        const Prescription rx = any_prescription(random);
        const double other_d = rx.sphere_d + rx.cylinder_d;
        const double most_d = std::max(rx.sphere_d, other_d);
        const double left = random.index(4) == 0 ? 0.1 + 1e-9 : random.uniform(0.1 + 1e-9, 1.0);
        const double distance_m =
            most_d > 0.0 ? std::min(0.02305, (1.0 - left) / most_d) : 0.02305;
        SCOPED_TRACE(testing::Message() << format_prescription(rx) << " moved " << distance_m);
        const PowerMatrix power = power_matrix_tabo(rx);
        const PowerMatrix moved = moved_toward_eye(power, distance_m);
        const auto effective_d = [&](double power_d) {
            return power_d / (1.0 - distance_m * power_d);
        };
        const PowerMatrix expected =
            power_matrix_tabo({.sphere_d = effective_d(rx.sphere_d),
                               .cylinder_d = effective_d(other_d) - effective_d(rx.sphere_d),
                               .axis_deg = rx.axis_deg});
        // Near the focus a rounding of the lens is magnified by 1 / 0.1^2.
        const double scale_d = norm_d(expected) + norm_d(power) / (left * left);
        EXPECT_TRUE(are_same(moved, expected, scale_d));
        EXPECT_TRUE(
            are_same(moved_toward_eye(moved, -distance_m), power, norm_d(power) + norm_d(moved)));
    }
}

TEST(PrescriptionExtremes, a_lens_is_not_moved_to_its_focus)
{
    for (const double power_d : {-40.0, -1.0, 1.0, 40.0}) {
        for (const double beyond : {0.9 + 1e-9, 1.0, 1.0 + 1e-15, 2.0, 1e300}) {
            try {
                static_cast<void>(
                    moved_toward_eye(PowerMatrix::sphere(power_d), beyond / power_d));
                ADD_FAILURE() << power_d << " D over " << beyond << " focal lengths";
            } catch (const std::invalid_argument& error) {
                EXPECT_TRUE(is_proper_refusal(error.what())) << power_d << " D, " << beyond;
            }
        }
    }
    EXPECT_THROW(static_cast<void>(moved_toward_eye(PowerMatrix::sphere(1.0), NAN)),
                 std::invalid_argument);
    EXPECT_THROW(static_cast<void>(moved_toward_eye(PowerMatrix::sphere(NAN), 0.01)),
                 std::invalid_argument);
}

TEST(PrescriptionExtremes, crossed_lenses_add_and_opposite_ones_cancel)
{
    Random random(43);
    for (int i = 0; i < trials; ++i) {
        const Prescription a = any_prescription(random);
        const Prescription b = any_prescription(random);
        SCOPED_TRACE(format_prescription(a) + " and " + format_prescription(b));
        const PowerMatrix sum = power_matrix_tabo(a) + power_matrix_tabo(b);
        const double scale_d = norm_d(power_matrix_tabo(a)) + norm_d(power_matrix_tabo(b));
        EXPECT_TRUE(are_same(power_matrix_tabo(crossed(a, b)), sum, scale_d));
        EXPECT_TRUE(are_same(power_matrix_tabo(crossed(b, a)), sum, scale_d));
        Prescription opposite = a;
        opposite.sphere_d = -a.sphere_d;
        opposite.cylinder_d = -a.cylinder_d;
        const Prescription nothing = crossed(a, opposite);
        EXPECT_NEAR(nothing.sphere_d, 0.0, 1e-13);
        EXPECT_EQ(nothing.cylinder_d, 0.0);
        // Jackson's crossed cylinders: opposite signs at right angles are twice one of them.
        const Prescription jackson = crossed(
            {.cylinder_d = a.cylinder_d, .axis_deg = a.axis_deg},
            {.cylinder_d = -a.cylinder_d, .axis_deg = normalized_axis_deg(a.axis_deg + 90.0)});
        EXPECT_NEAR(std::abs(jackson.cylinder_d), 2.0 * std::abs(a.cylinder_d), 1e-12);
        EXPECT_NEAR(jackson.sphere_d + 0.5 * jackson.cylinder_d, 0.0, 1e-12);
    }
}

TEST(PrescriptionText, what_is_written_is_read_bit_for_bit)
{
    Random random(44);
    for (int i = 0; i < trials; ++i) {
        Prescription rx = any_prescription(random);
        rx.sphere_d *= std::pow(10.0, -std::floor(random.uniform(0.0, 4.0) * 3.0));
        rx.axis_deg = rx.cylinder_d == 0.0 ? 180.0 : normalized_axis_deg(rx.axis_deg);
        if (random.index(2) == 0) rx.add_d = random.uniform(0.0, max_add_d);
        if (random.index(2) == 0) rx.base_in_pd = random.uniform(-max_prism_pd, max_prism_pd);
        if (random.index(2) == 0) rx.base_up_pd = random.uniform(-max_prism_pd, max_prism_pd);
        const std::string text = format_prescription(rx);
        EXPECT_EQ(parse_prescription(text), rx) << text;
    }
}

// Anything may be thrown at the parser; what it takes is in range.
void expect_valid_or_refused(const std::string& text, int& read)
{
    try {
        const Prescription rx = parse_prescription(text);
        EXPECT_NO_THROW(require_valid(rx)) << testing::PrintToString(text);
        EXPECT_TRUE(std::isfinite(rx.sphere_d + rx.cylinder_d + rx.axis_deg));
        ++read;
    } catch (const PrescriptionError& error) {
        EXPECT_FALSE(std::string_view(error.what()).empty()) << testing::PrintToString(text);
    }
}

TEST(PrescriptionText, random_bytes_are_refused_or_in_range)
{
    Random random(45);
    int read = 0;
    for (int i = 0; i < 100000; ++i) {
        std::string text;
        const std::size_t length = random.index(24);
        for (std::size_t j = 0; j < length; ++j) {
            text += static_cast<char>(static_cast<unsigned char>(random.index(256)));
        }
        expect_valid_or_refused(text, read);
    }
}

// Shuffled pieces of prescriptions get deeper into the grammar than bytes do.
TEST(PrescriptionText, random_words_are_refused_or_in_range)
{
    const std::vector<std::string> pieces{
        "OD",   "os",    "Rx",     "(",      ")",
        "[",    "]",     "-2.00",  "+0.75",  "-",
        "+",    "30.00", "15.01",  "-30",    "plano",
        "DS",   "DC",    "sph",    "cyl",    "x",
        "@",    "axis",  "160",    "180",    "181",
        "0",    "A",     "/",      "add",    "4.00",
        "4.01", "2",     "\u0394", "^",      "pd",
        "BU",   "BD",    "BI",     "BO",     "base",
        "in",   ",",     ".",      "\u2212", "\u00b0",
        "1e9",  "nan",   "inf",    "0x1p3",  std::string(400, '9'),
        "\xff", " "};
    Random random(46);
    int read = 0;
    for (int i = 0; i < 100000; ++i) {
        std::string text = random.index(2) == 0 ? "-2.00" : "";
        const std::size_t length = random.index(10);
        for (std::size_t j = 0; j < length; ++j) {
            text += random.index(4) == 0 ? "" : " ";
            text += pieces[random.index(pieces.size())];
        }
        expect_valid_or_refused(text, read);
    }
    EXPECT_GT(read, 1000);
}

TEST(PrescriptionText, prisms_that_add_up_beyond_the_range_are_refused)
{
    for (const char* text : {"0.00 20\u0394 BI 20\u0394 BI", "0.00 16.00^ BD 15.00^ BD"}) {
        EXPECT_THROW(static_cast<void>(parse_prescription(text)), PrescriptionError) << text;
    }
    EXPECT_EQ(parse_prescription("0.00 20\u0394 BI 20\u0394 BO").base_in_pd, 0.0);
}

}  // namespace
}  // namespace eye_render::test
