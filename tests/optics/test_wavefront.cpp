// Wavefronts against the vectors, published conversions and quadrature.

#include "optics/wavefront.h"

#include "../optics_vectors.h"

#include "base/units.h"

#include <array>

namespace eye_render {
namespace {

using test::Json;

double& coefficient(Wavefront& wavefront, const ZernikeTerm& term)
{
    const auto j = static_cast<std::size_t>(osa_index(term));
    wavefront.coefficients_um.resize(std::max(wavefront.coefficients_um.size(), j + 1));
    return wavefront.coefficients_um[j];
}

// The keys of the vectors, "n,m".
ZernikeTerm term_named(const std::string& name)
{
    const std::size_t comma = name.find(',');
    return {std::stoi(name.substr(0, comma)), std::stoi(name.substr(comma + 1))};
}

// A wavefront with every term to the 6th order.
Wavefront full_wavefront(double pupil_diameter_m)
{
    Wavefront wavefront{.pupil_diameter_m = pupil_diameter_m};
    for (std::size_t j = 0; j < max_zernike_terms; ++j) {
        wavefront.coefficients_um.push_back(0.3 * std::sin(2.0 * static_cast<double>(j) + 1.0));
    }
    return wavefront;
}

std::string refusal(const Wavefront& wavefront)
{
    try {
        require_valid(wavefront);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Wavefront, that_a_prescription_corrects_is_the_vectors_both_ways)
{
    for (const Json& vector : test::vectors_of_kind("rx_to_zernike")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        const PowerVector rx = power_vector(
            {.sphere_d = input["S"], .cylinder_d = input["C"], .axis_deg = input["axis"]});
        Wavefront wavefront =
            wavefront_corrected_by(rx, m_from_mm(2.0 * input["pupil_radius_mm"].get<double>()));
        const Json& expected = vector["expect"];
        test::expect_vector_value(coefficient(wavefront, {2, 0}), expected["c20_um"]);
        test::expect_vector_value(coefficient(wavefront, {2, 2}), expected["c22_um"]);
        test::expect_vector_value(coefficient(wavefront, {2, -2}), expected["c2m2_um"]);
        const PowerVector back = paraxial_refraction(wavefront);
        EXPECT_NEAR(back.m_d, rx.m_d, 1e-12);
        EXPECT_NEAR(back.j0_d, rx.j0_d, 1e-12);
        EXPECT_NEAR(back.j45_d, rx.j45_d, 1e-12);
    }
}

TEST(Wavefront, sends_rays_down_its_slope_as_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("zernike_ray_slope")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        const double radius_mm = input["pupil_radius_mm"];
        Wavefront wavefront{.pupil_diameter_m = m_from_mm(2.0 * radius_mm)};
        coefficient(wavefront, {input["n"], input["m"]}) = input["c_um"];
        const V2d point_mm(input["point_mm"][0], input["point_mm"][1]);
        const auto slope_at = [&](const Wavefront& w, const V2d& p_mm) {
            return polynomial_um(w).gradient(p_mm / radius_mm) * (-1e-3 / radius_mm);
        };
        // Slopes are small numbers: compared in microradians.
        const auto expect_slope = [](const V2d& slope, const Json& expected) {
            EXPECT_NEAR(slope.x * 1e6, expected[0].get<double>() * 1e6, 1e-9);
            EXPECT_NEAR(slope.y * 1e6, expected[1].get<double>() * 1e6, 1e-9);
        };
        expect_slope(slope_at(wavefront, point_mm), vector["expect"]["slope_osa"]);
        expect_slope(slope_at(mirrored(wavefront), {-point_mm.x, point_mm.y}),
                     vector["expect"]["slope_camera_at_same_physical_point"]);
    }
}

TEST(Wavefront, rescales_as_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("pupil_rescale")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        Wavefront wavefront{.pupil_diameter_m = 8e-3};
        for (const auto& [name, value] : input["c_um"].items()) {
            coefficient(wavefront, term_named(name)) = value;
        }
        Wavefront smaller = rescaled(wavefront, 8e-3 * input["radius_ratio"].get<double>());
        for (const auto& [name, value] : vector["expect"].items()) {
            test::expect_vector_value(coefficient(smaller, term_named(name)), value);
        }
    }
}

TEST(Wavefront, rescaled_is_the_same_surface)
{
    const Wavefront wide = full_wavefront(6e-3);
    const Wavefront narrow = rescaled(wide, 4.5e-3);
    for (const V2d& p : {V2d(0.0, 0.0), V2d(0.9, 0.1), V2d(-0.4, 0.6)}) {
        EXPECT_NEAR(polynomial_um(narrow).value(p), polynomial_um(wide).value(p * 0.75), 1e-13);
    }
    EXPECT_EQ(rescaled(wide, 6e-3).coefficients_um.size(), max_zernike_terms);
    for (std::size_t j = 0; j < max_zernike_terms; ++j) {
        EXPECT_NEAR(rescaled(wide, 6e-3).coefficients_um[j], wide.coefficients_um[j], 1e-14);
    }
}

TEST(Wavefront, refuses_to_grow_and_names_both_pupils)
{
    try {
        static_cast<void>(rescaled({.pupil_diameter_m = 5e-3}, 6e-3));
        FAIL() << "a pupil of 6 mm was accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "pupil_mm is 6 mm; expected at most the wavefront's 5 mm");
    }
    EXPECT_THROW(static_cast<void>(rescaled({}, 0.5e-3)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(rescaled({}, NAN)), std::invalid_argument);
}

TEST(Wavefront, mirrored_is_the_surface_seen_from_behind)
{
    const Wavefront wavefront = full_wavefront(6e-3);
    const PupilPolynomial seen = polynomial_um(mirrored(wavefront));
    for (const V2d& p : {V2d(0.9, 0.1), V2d(-0.4, 0.6), V2d(0.2, -0.7)}) {
        EXPECT_NEAR(seen.value(p), polynomial_um(wavefront).value({-p.x, p.y}), 1e-13);
    }
    EXPECT_EQ(mirrored(mirrored(wavefront)).coefficients_um, wavefront.coefficients_um);
}

TEST(Wavefront, changes_between_left_and_right_eyes_by_the_standards_signs)
{
    // Thibos et al. 2002: the diagonal of the matrix that turns right eyes into left ones.
    constexpr std::array signs{+1, +1, -1, -1, +1, +1, +1, +1, -1, -1, -1, -1, +1, +1, +1};
    const Wavefront ones{.coefficients_um = std::vector<double>(signs.size(), 1.0)};
    for (std::size_t j = 0; j < signs.size(); ++j) {
        EXPECT_EQ(mirrored(ones).coefficients_um[j], signs[j]) << "index " << j;
    }
}

TEST(Wavefront, rms_is_that_of_the_surface_above_the_second_order)
{
    Wavefront wavefront = full_wavefront(6e-3);
    const double rms_um = higher_order_rms_um(wavefront);
    for (std::size_t j = 0; j < 6; ++j) {
        wavefront.coefficients_um[j] = 0.0;
    }
    const PupilPolynomial surface_um = polynomial_um(wavefront);
    constexpr int rings = 400;
    constexpr int spokes = 16;
    double sum_um2 = 0.0;
    for (int ring = 0; ring < rings; ++ring) {
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const double rho = std::sqrt((ring + 0.5) / rings);
            const double theta = 2.0 * pi * (spoke + 0.5) / spokes;
            const double w_um = surface_um.value({rho * std::cos(theta), rho * std::sin(theta)});
            sum_um2 += w_um * w_um / (rings * spokes);
        }
    }
    EXPECT_NEAR(rms_um, std::sqrt(sum_um2), 1e-3 * rms_um);
    EXPECT_EQ(higher_order_rms_um({.coefficients_um = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}}), 0.0);
}

TEST(Wavefront, is_refracted_at_its_centre_as_published)
{
    // Thibos et al. 2004, the paraxial curvature of a Zernike expansion to the 6th order.
    Wavefront w = full_wavefront(5e-3);
    const PowerVector rx = paraxial_refraction(w);
    const double r2_mm2 = 2.5 * 2.5;
    EXPECT_NEAR(rx.m_d,
                (-4.0 * std::sqrt(3.0) * coefficient(w, {2, 0}) +
                 12.0 * std::sqrt(5.0) * coefficient(w, {4, 0}) -
                 24.0 * std::sqrt(7.0) * coefficient(w, {6, 0})) /
                    r2_mm2,
                1e-12);
    EXPECT_NEAR(rx.j0_d,
                (-2.0 * std::sqrt(6.0) * coefficient(w, {2, 2}) +
                 6.0 * std::sqrt(10.0) * coefficient(w, {4, 2}) -
                 12.0 * std::sqrt(14.0) * coefficient(w, {6, 2})) /
                    r2_mm2,
                1e-12);
    EXPECT_NEAR(rx.j45_d,
                (-2.0 * std::sqrt(6.0) * coefficient(w, {2, -2}) +
                 6.0 * std::sqrt(10.0) * coefficient(w, {4, -2}) -
                 12.0 * std::sqrt(14.0) * coefficient(w, {6, -2})) /
                    r2_mm2,
                1e-12);
}

TEST(Wavefront, measured_in_the_red_is_refracted_for_555_nm)
{
    // Flat at 633 nm, the eye is too strong for 555 nm by the chromatic difference.
    const PowerVector rx = paraxial_refraction({.wavelength_nm = 633.0});
    EXPECT_DOUBLE_EQ(rx.m_d, -chromatic_difference_d(633.0));
    EXPECT_LT(rx.m_d, -0.3);
    EXPECT_EQ(rx.j0_d, 0.0);
}

TEST(Wavefront, is_refused_out_of_range)
{
    EXPECT_EQ(refusal({}), "accepted");
    EXPECT_EQ(refusal(full_wavefront(10e-3)), "accepted");
    EXPECT_EQ(refusal({.coefficients_um = std::vector<double>(29)}),
              "the wavefront has 29 coefficients; expected up to 28, the OSA indices 0 to 27");
    EXPECT_EQ(refusal({.coefficients_um = {0.0, NAN}}),
              "wavefront coefficient 1 is nan um; expected -1000 to 1000 um");
    EXPECT_EQ(refusal({.pupil_diameter_m = 0.5e-3}),
              "wavefront pupil_mm is 0.5 mm; expected 1 to 10 mm");
    EXPECT_EQ(refusal({.wavelength_nm = 1200.0}),
              "wavefront wavelength_nm is 1200 nm; expected 380 to 1100 nm");
    EXPECT_EQ(refusal({.wavelength_nm = 850.0}), "accepted") << "an aberrometer's infrared";
}

}  // namespace
}  // namespace eye_render
