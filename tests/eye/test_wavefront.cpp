// The wavefront eye: which parts of a wavefront it takes, their signs and sizes, and its spot.

#include "eye/eye_factory.h"

#include "../optics_vectors.h"

#include "base/units.h"
#include "optics/chromatic.h"
#include "optics/population_wavefront.h"

namespace eye_render {
namespace {

using test::Json;

Wavefront single_term(const ZernikeTerm& term, double coefficient_um, double pupil_diameter_m)
{
    Wavefront wavefront{.pupil_diameter_m = pupil_diameter_m};
    wavefront.coefficients_um.resize(static_cast<std::size_t>(osa_index(term)) + 1);
    wavefront.coefficients_um.back() = coefficient_um;
    return wavefront;
}

EyeSpec wavefront_spec(const Wavefront& wavefront, const Prescription& rx = {})
{
    return {.model = EyeModelKind::Wavefront,
            .rx = rx,
            .rx_plane = RxPlane::EntrancePupil,
            .pupil_diameter_m = wavefront.pupil_diameter_m,
            .wavefront = wavefront};
}

V2d slope_at(const EyeSpec& spec, const V2d& pupil_point_m)
{
    return make_eye(spec)->ray(V2d(0.0), pupil_point_m, reference_wavelength_nm).slope;
}

void expect_near(const V2d& actual, const V2d& expected, double tolerance)
{
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
}

constexpr std::array points_m{V2d(0.0, 0.0), V2d(1e-3, 0.0), V2d(-2e-3, 1.5e-3),
                              V2d(0.4e-3, -2.8e-3)};

TEST(WavefrontEye, without_aberrations_is_the_paraxial_eye_bit_for_bit)
{
    const Prescription rx{.sphere_d = -2.0, .cylinder_d = -1.25, .axis_deg = 30.0};
    EyeSpec paraxial = wavefront_spec({}, rx);
    paraxial.model = EyeModelKind::Paraxial;
    for (const V2d& p : points_m) {
        EXPECT_EQ(slope_at(wavefront_spec({}, rx), p), slope_at(paraxial, p));
    }
}

TEST(WavefrontEye, leaves_piston_tilt_and_second_order_to_the_prescription)
{
    const Prescription rx{.sphere_d = 1.0, .cylinder_d = -0.5, .axis_deg = 70.0};
    for (int j = 0; j < 6; ++j) {
        for (const V2d& p : points_m) {
            EXPECT_EQ(slope_at(wavefront_spec(single_term(osa_term(j), 2.0, 6e-3), rx), p),
                      slope_at(wavefront_spec({}, rx), p))
                << "index " << j << " at " << p;
        }
    }
}

TEST(WavefrontEye, refracted_by_its_own_wavefront_has_all_of_its_slope)
{
    // With the second order as its prescription the eye is the measured one: slope = -grad W in
    // the clinician's frame, but for the tilt at the centre.
    Wavefront wavefront{.pupil_diameter_m = 6e-3};
    for (std::size_t j = 0; j < max_zernike_terms; ++j) {
        wavefront.coefficients_um.push_back(0.3 * std::sin(2.0 * static_cast<double>(j) + 1.0));
    }
    const Prescription rx = prescription_from(paraxial_refraction(wavefront));
    const PupilPolynomial surface_um = polynomial_um(wavefront);
    for (const V2d& p : points_m) {
        const V2d p_osa(-p.x, p.y);
        const V2d steepness =
            (surface_um.gradient(p_osa / 3e-3) - surface_um.gradient(V2d(0.0))) * (1e-6 / 3e-3);
        expect_near(slope_at(wavefront_spec(wavefront, rx), p), {steepness.x, -steepness.y},
                    1e-15);
    }
}

TEST(WavefrontEye, defocus_is_a_sphere)
{
    // c20 = -M r^2 / (4 sqrt 3): 3.6084 um over 5 mm are -4 D.
    const Wavefront myope = single_term({2, 0}, 4.0 * 2.5 * 2.5 / (4.0 * std::sqrt(3.0)), 5e-3);
    const Prescription rx = prescription_from(paraxial_refraction(myope));
    for (const V2d& p : points_m) {
        expect_near(slope_at(wavefront_spec(myope, rx), p),
                    slope_at(wavefront_spec({}, {.sphere_d = -4.0}), p), 1e-15);
    }
}

TEST(WavefrontEye, becomes_the_paraxial_eye_as_the_pupil_closes)
{
    const Prescription rx{.sphere_d = -1.0, .cylinder_d = -0.75, .axis_deg = 30.0};
    const EyeSpec spec = wavefront_spec(population_wavefront(6e-3), rx);
    const auto eye = make_eye(spec);
    EXPECT_EQ(eye->ray({0.1, 0.2}, V2d(0.0), 555.0).slope, V2d(0.1, 0.2));
    // The population's slopes are below 3e-4 at these points and begin with the second power of
    // the distance: a thousandth of it leaves a thousandth of them, relative to what K does.
    const PowerMatrix k = eye->retinal_conjugate_d();
    for (const V2d& p : points_m) {
        expect_near(slope_at(spec, p * 1e-3) * 1e3, V2d(0.0) - k * p, 1e-3 * 3e-4);
    }
}

TEST(WavefrontEye, means_the_same_over_any_part_of_the_measured_pupil)
{
    Wavefront wavefront{.pupil_diameter_m = 7e-3};
    for (std::size_t j = 0; j < max_zernike_terms; ++j) {
        wavefront.coefficients_um.push_back(0.2 * std::cos(3.0 * static_cast<double>(j)));
    }
    EyeSpec narrow = wavefront_spec(wavefront);
    narrow.pupil_diameter_m = 5.8e-3;
    for (const V2d& p : points_m) {
        const V2d slope = slope_at(wavefront_spec(wavefront), p);
        EXPECT_EQ(slope_at(narrow, p), slope);
        expect_near(slope_at(wavefront_spec(rescaled(wavefront, 5.8e-3)), p), slope, 1e-15);
    }
}

TEST(WavefrontEye, positive_spherical_aberration_is_myopia_at_the_edge)
{
    // K(r) - K(0) = 24 sqrt(5) c40 r^2 / R^4 dioptres in um and mm: 0.56 D at the edge of the
    // population's 6 mm pupil.
    const double c40_um = 0.0942;
    const EyeSpec spec = wavefront_spec(single_term({4, 0}, c40_um, 6e-3), {.sphere_d = -1.0});
    for (const double r_mm : {0.5, 1.5, 3.0}) {
        const V2d p(0.6e-3 * r_mm, -0.8e-3 * r_mm);
        const double k_d = -slope_at(spec, p).dot(p) / p.length2();
        EXPECT_NEAR(k_d - 1.0, 24.0 * std::sqrt(5.0) * c40_um * r_mm * r_mm / 81.0, 1e-12);
    }
}

TEST(WavefrontEye, follows_the_vectors_in_the_patients_view)
{
    // The vectors are of whole Zernike terms; the eye leaves out their part of low degree.
    for (const Json& vector : test::vectors_of_kind("zernike_ray_slope")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        const double radius_m = m_from_mm(input["pupil_radius_mm"]);
        const ZernikeTerm term{input["n"], input["m"]};
        const Wavefront wavefront = single_term(term, input["c_um"], 2.0 * radius_m);
        const V2d p_osa_m(m_from_mm(input["point_mm"][0]), m_from_mm(input["point_mm"][1]));
        PupilPolynomial left_out = polynomial_um(wavefront);
        PupilPolynomial kept = left_out;
        kept.drop_below(3);
        const V2d low = left_out.gradient(p_osa_m / radius_m) - kept.gradient(p_osa_m / radius_m);
        const V2d slope = slope_at(wavefront_spec(wavefront), {-p_osa_m.x, p_osa_m.y});
        const Json& expected = vector["expect"]["slope_camera_at_same_physical_point"];
        expect_near(slope + V2d(low.x, -low.y) * (1e-6 / radius_m), {expected[0], expected[1]},
                    1e-15);
    }
}

TEST(WavefrontEye, vertical_coma_flares_upwards_or_downwards_by_its_sign)
{
    // W = sqrt(8) c (3 r^2 - 2) y: minus its slope along y is -3 sqrt(8) c (x^2 + 3 y^2),
    // one-sided.
    const EyeSpec spec = wavefront_spec(single_term({3, -1}, 0.15, 6e-3));
    for (const V2d& p : points_m) {
        const double x_mm = mm_from_m(p.x);
        const double y_mm = mm_from_m(p.y);
        const V2d expected = V2d(2.0 * x_mm * y_mm, x_mm * x_mm + 3.0 * y_mm * y_mm) *
                             (-3.0 * std::sqrt(8.0) * 0.15 / 27.0 * 1e-3);
        expect_near(slope_at(spec, p), expected, 1e-15);
    }
}

TEST(WavefrontEye, horizontal_coma_is_mirrored_into_the_patients_view)
{
    // Positive in the clinician's frame: rays bend towards his left, the patient's right.
    const EyeSpec spec = wavefront_spec(single_term({3, 1}, 0.15, 6e-3));
    EXPECT_NEAR(slope_at(spec, {1e-3, 0.0}).x, 9.0 * std::sqrt(8.0) * 0.15 / 27.0 * 1e-3, 1e-15);
    EXPECT_NEAR(slope_at(spec, {-1e-3, 0.0}).x, 9.0 * std::sqrt(8.0) * 0.15 / 27.0 * 1e-3, 1e-15);
}

TEST(WavefrontEye, aberrations_of_both_eyes_mirror_each_other)
{
    const EyeSpec right = wavefront_spec(population_wavefront(6e-3, EyeSide::Right));
    const EyeSpec left = wavefront_spec(population_wavefront(6e-3, EyeSide::Left));
    for (const V2d& p : points_m) {
        const V2d seen_left = slope_at(left, {-p.x, p.y});
        expect_near(slope_at(right, p), {-seen_left.x, seen_left.y}, 1e-15);
    }
}

TEST(WavefrontEye, is_as_chromatic_as_the_paraxial_eye)
{
    EyeSpec spec = wavefront_spec(population_wavefront(6e-3), {.sphere_d = -1.0});
    const V2d p(1e-3, -2e-3);
    const auto change = [&](const EyeSpec& s) {
        return make_eye(s)->ray(V2d(0.0), p, 450.0).slope - slope_at(s, p);
    };
    const V2d with_aberrations = change(spec);
    spec.model = EyeModelKind::Paraxial;
    expect_near(with_aberrations, change(spec), 1e-15);
    expect_near(with_aberrations, p * -0.8271033567246555, 1e-12);  // vector F02
}

// Means over the evenly filled pupil, by the midpoint rule in the square of the radius.
struct SlopeMoments {
    V2d mean{0.0};
    V2d mean_square{0.0};
};

SlopeMoments slope_moments(const EyeSpec& spec)
{
    const auto eye = make_eye(spec);
    constexpr int rings = 400;
    constexpr int spokes = 16;
    SlopeMoments moments;
    for (int ring = 0; ring < rings; ++ring) {
        const double radius_m = 0.5 * spec.pupil_diameter_m * std::sqrt((ring + 0.5) / rings);
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const double angle_rad = 2.0 * pi * (spoke + 0.5) / spokes;
            const V2d p = V2d(std::cos(angle_rad), std::sin(angle_rad)) * radius_m;
            const V2d slope = eye->ray(V2d(0.0), p, reference_wavelength_nm).slope;
            moments.mean += slope / (rings * spokes);
            moments.mean_square += slope * slope / (rings * spokes);
        }
    }
    return moments;
}

TEST(WavefrontEye, spot_has_the_moments_of_its_aberrations)
{
    // Of W = a r^4 the slope is 4 a r^3 outwards, its mean square 4 a^2, half of it along x; of
    // W = b r^2 y it is b (2 x y, x^2 + 3 y^2), with mean (0, b) and mean squares b^2 / 6 and
    // 3 b^2 / 2. All over the unit disk, then over 3 mm. Tolerance: of the quadrature.
    const double radius_um = 3e3;
    const double a = 6.0 * std::sqrt(5.0) * 0.0942 / radius_um;
    const SlopeMoments spherical =
        slope_moments(wavefront_spec(single_term({4, 0}, 0.0942, 6e-3)));
    expect_near(spherical.mean, V2d(0.0), 1e-15);
    expect_near(spherical.mean_square / (a * a), {2.0, 2.0}, 1e-4);
    const double b = 3.0 * std::sqrt(8.0) * 0.15 / radius_um;
    const SlopeMoments coma = slope_moments(wavefront_spec(single_term({3, -1}, 0.15, 6e-3)));
    expect_near(coma.mean / b, {0.0, -1.0}, 1e-4);
    expect_near(coma.mean_square / (b * b), {1.0 / 6.0, 1.5}, 1e-4);
}

TEST(WavefrontEye, needs_a_wavefront_as_wide_as_its_pupil)
{
    EyeSpec spec = wavefront_spec(population_wavefront(6e-3));
    const auto refusal = [&spec]() -> std::string {
        try {
            static_cast<void>(make_eye(spec));
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(refusal(), "accepted");
    spec.pupil_diameter_m = 6.5e-3;
    EXPECT_EQ(refusal(), "pupil_mm is 6.5 mm; expected at most the wavefront's 6 mm");
    spec.wavefront.reset();
    EXPECT_EQ(refusal(), "wavefront is missing; expected one for the model 'wavefront'");
    spec.wavefront = Wavefront{.coefficients_um = {NAN}};
    spec.model = EyeModelKind::Paraxial;
    EXPECT_EQ(refusal(), "wavefront coefficient 0 is nan um; expected -1000 to 1000 um");
}

}  // namespace
}  // namespace eye_render
