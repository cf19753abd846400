// Every number of what makes an eye, when it is no number, infinite or beyond its range: refused
// in every model, by name, value, unit and range.

#include "trial.h"

#include "api/eye.h"
#include "base/units.h"

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace eye_render::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A field of `Subject` and its range, in the field's own unit.
template <typename Subject>
struct Field {
    std::string_view name;  // as the refusal says it
    std::function<void(Subject&, double)> set;
    double minimum;
    double maximum;
};

// Just beyond the range as well as far from it.
std::vector<double> bad_values(double minimum, double maximum)
{
    const double step = 1e-9 * (maximum - minimum);
    return {NAN, -infinity, infinity, minimum - step, maximum + step, -1e300, 1e300};
}

// Calls attempt(subject) with each bad value in each field; all must be refused.
template <typename Subject, typename Attempt>
void expect_refusals(const Subject& good,
                     const std::vector<Field<Subject>>& fields,
                     const Attempt& attempt)
{
    ASSERT_NO_THROW(attempt(good));
    for (const Field<Subject>& field : fields) {
        for (const double value : bad_values(field.minimum, field.maximum)) {
            Subject bad = good;
            field.set(bad, value);
            try {
                attempt(bad);
                ADD_FAILURE() << field.name << " of " << value << " was accepted";
            } catch (const std::invalid_argument& error) {
                const std::string text = error.what();
                EXPECT_TRUE(is_proper_refusal(text)) << field.name << " of " << value;
                EXPECT_NE(text.find(field.name), std::string::npos)
                    << field.name << " of " << value << ": " << text;
            }
        }
    }
}

std::vector<Field<Prescription>> prescription_fields()
{
    return {{"sphere_d", [](auto& rx, double v) { rx.sphere_d = v; }, -30.0, 30.0},
            {"cylinder_d", [](auto& rx, double v) { rx.cylinder_d = v; }, -15.0, 15.0},
            {"axis_deg", [](auto& rx, double v) { rx.axis_deg = v; }, 0.0, 180.0},
            {"add_d", [](auto& rx, double v) { rx.add_d = v; }, 0.0, 4.0},
            {"base_in_pd", [](auto& rx, double v) { rx.base_in_pd = v; }, -30.0, 30.0},
            {"base_up_pd", [](auto& rx, double v) { rx.base_up_pd = v; }, -30.0, 30.0}};
}

class Refusals : public testing::TestWithParam<EyeModelKind> {};

TEST_P(Refusals, of_every_number_of_an_eye)
{
    using Spec = EyeSpec;
    std::vector<Field<Spec>> fields{
        {"vertex_mm", [](Spec& s, double v) { s.vertex_m = v; }, 0.0, 20e-3},
        {"pupil_mm", [](Spec& s, double v) { s.pupil_diameter_m = v; }, 0.0, 9e-3},
        {"accommodation_d", [](Spec& s, double v) { s.accommodation_d = v; }, 0.0, 20.0}};
    if (GetParam() == EyeModelKind::Paper) {
        fields.push_back(
            {"eye_length_mm", [](Spec& s, double v) { s.eye_length_m = v; }, 10e-3, 40e-3});
    }
    for (const Field<Prescription>& field : prescription_fields()) {
        fields.push_back(
            {field.name,
             [set = field.set](Spec& s, double v) { set(std::get<Prescription>(s.rx), v); },
             field.minimum, field.maximum});
    }
    Spec good = spec_of({.model = GetParam(), .rx_plane = RxPlane::Spectacle});
    expect_refusals(good, fields, [](const Spec& spec) { static_cast<void>(make_eye(spec)); });
}

TEST_P(Refusals, of_every_number_of_a_power_matrix)
{
    using Spec = EyeSpec;
    const auto set = [](double PowerMatrix::*element) {
        return [element](Spec& spec, double value) {
            std::get<PowerMatrix>(spec.rx).*element = value;
        };
    };
    Spec good = spec_of({.model = GetParam()});
    good.rx = PowerMatrix{};
    // One element beyond 15 D is cylinder alone.
    expect_refusals(good,
                    {{" of rx", set(&PowerMatrix::xx_d), -15.0, 15.0},
                     {" of rx", set(&PowerMatrix::xy_d), -7.5, 7.5},
                     {" of rx", set(&PowerMatrix::yy_d), -15.0, 15.0}},
                    [](const Spec& spec) { static_cast<void>(make_eye(spec)); });
}

TEST_P(Refusals, of_every_number_of_a_wavefront)
{
    using Spec = EyeSpec;
    Spec good = spec_of({.model = GetParam(), .pupil_mm = 0.5});
    good.wavefront = Wavefront{.coefficients_um = std::vector<double>(max_zernike_terms)};
    std::vector<Field<Spec>> fields{
        {"wavefront pupil_mm", [](Spec& s, double v) { s.wavefront->pupil_diameter_m = v; }, 1e-3,
         10e-3},
        {"wavefront wavelength_nm", [](Spec& s, double v) { s.wavefront->wavelength_nm = v; },
         380.0, 1100.0}};
    for (std::size_t j = 0; j < max_zernike_terms; ++j) {
        fields.push_back({"wavefront coefficient",
                          [j](Spec& s, double v) { s.wavefront->coefficients_um[j] = v; }, -1000.0,
                          1000.0});
    }
    expect_refusals(good, fields, [](const Spec& spec) { static_cast<void>(make_eye(spec)); });
}

TEST_P(Refusals, of_every_number_of_a_worn_lens)
{
    if (GetParam() == EyeModelKind::Pinhole) GTEST_SKIP() << "the pinhole ignores it";
    using Spec = EyeSpec;
    const auto set_power = [](double PowerMatrix::*element) {
        return [element](Spec& spec, double value) { spec.worn->power_d.*element = value; };
    };
    Spec good = spec_of({.model = GetParam()});
    good.worn = contact_lens({});
    expect_refusals(
        good,
        {{"worn lens", [](Spec& s, double v) { s.worn->distance_m = v; }, 0.0, 23.05e-3},
         {"worn lens", set_power(&PowerMatrix::xx_d), -15.0, 15.0},
         {"worn lens", set_power(&PowerMatrix::xy_d), -7.5, 7.5},
         {"worn lens", set_power(&PowerMatrix::yy_d), -15.0, 15.0},
         {"worn lens", [](Spec& s, double v) { s.worn->prism_slope.x = v; }, -0.3, 0.3},
         {"worn lens", [](Spec& s, double v) { s.worn->prism_slope.y = v; }, -0.3, 0.3}},
        [](const Spec& spec) { static_cast<void>(make_eye(spec)); });
}

TEST_P(Refusals, not_of_the_strongest_lens_at_any_axis)
{
    for (int axis_deg = 0; axis_deg <= 180; ++axis_deg) {
        for (const double sign : {-1.0, 1.0}) {
            EyeSpec spec = spec_of({.model = GetParam()});
            spec.worn = contact_lens({.sphere_d = sign * max_sphere_d,
                                      .cylinder_d = sign * max_cylinder_d,
                                      .axis_deg = static_cast<double>(axis_deg),
                                      .base_up_pd = sign * max_prism_pd});
            EXPECT_NO_THROW(static_cast<void>(make_eye(spec))) << sign << ", " << axis_deg;
        }
    }
}

TEST_P(Refusals, of_every_number_of_a_description)
{
    using Described = EyeDescription;
    for (const Correction correction : corrections) {
        SCOPED_TRACE(to_string(correction));
        std::vector<Field<Described>> fields{
            {"pupil_mm", [](Described& d, double v) { d.pupil_mm = v; }, 0.0, 9.0},
            {"accommodation_d", [](Described& d, double v) { d.accommodation_d = v; }, 0.0, 20.0},
            {"vertex_mm", [](Described& d, double v) { d.vertex_mm = v; }, 0.0, 20.0}};
        for (const Field<Prescription>& field : prescription_fields()) {
            fields.push_back({field.name,
                              [set = field.set](Described& d, double v) { set(d.rx, v); },
                              field.minimum, field.maximum});
            if (correction == Correction::None) continue;
            fields.push_back({field.name,
                              [set = field.set](Described& d, double v) { set(*d.worn, v); },
                              field.minimum, field.maximum});
        }
        Described described{.model = GetParam(),
                            .rx = {.eye = EyeSide::Right},
                            .correction = correction,
                            .wavefront = spec_of({.model = GetParam()}).wavefront};
        if (correction != Correction::None) {
            described.worn = Prescription{.eye = EyeSide::Right};
        }
        expect_refusals(described, fields,
                        [](const Described& eye) { static_cast<void>(make_eye(eye)); });
    }
}

TEST(WavefrontRefusals, of_a_pupil_wider_than_its_wavefront)
{
    EyeSpec spec = spec_of({.model = EyeModelKind::Wavefront, .pupil_mm = 6.5});
    spec.wavefront->pupil_diameter_m = 6e-3;
    try {
        static_cast<void>(make_eye(spec));
        ADD_FAILURE() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_TRUE(is_proper_refusal(error.what()));
    }
}

TEST_P(Refusals, of_objects_at_no_distance)
{
    const auto eye = make_eye(spec_of({.model = GetParam()}));
    for (const double bad_m : {static_cast<double>(NAN), 0.0, -0.0, 0.0099, -1.0, -infinity}) {
        try {
            static_cast<void>(blur_at(*eye, bad_m));
            ADD_FAILURE() << bad_m << " m was accepted";
        } catch (const std::invalid_argument& error) {
            EXPECT_TRUE(is_proper_refusal(error.what())) << bad_m;
        }
    }
    EXPECT_NEAR(blur_at(*eye, 1e300).major_arcmin, blur_at(*eye, infinity).major_arcmin, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(InEveryEye,
                         Refusals,
                         testing::ValuesIn(eye_model_kinds),
                         [](const auto& eye) { return std::string(to_string(eye.param)); });

}  // namespace
}  // namespace eye_render::test
