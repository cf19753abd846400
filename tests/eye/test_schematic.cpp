// The schematic eyes as models of an eye: exact, fitted, to first order and at the extremes.

#include "eye/schematic.h"

#include "base/units.h"
#include "eye/eye_factory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eye_render {
namespace {

constexpr std::array kinds{EyeModelKind::Navarro, EyeModelKind::Arizona, EyeModelKind::LeGrand};

TEST(SchematicEye, tends_to_the_paraxial_eye_as_the_pupil_closes)
{
    const Prescription rx{.sphere_d = -2.0, .cylinder_d = -0.75, .axis_deg = 160.0};
    for (const EyeModelKind kind : kinds) {
        for (const RefractionZero zero : refraction_zeros) {
            const EyeSpec spec{.model = kind,
                               .rx = rx,
                               .pupil_diameter_m = 0.1e-3,
                               .accommodation_d = 3.0,
                               .zero = zero,
                               .exact_trace = true};
            EyeSpec first_order = spec;
            first_order.model = EyeModelKind::Paraxial;
            const auto eye = make_eye(spec);
            const auto paraxial = make_eye(first_order);
            const PowerMatrix difference_d =
                eye->retinal_conjugate_d() - paraxial->retinal_conjugate_d();
            EXPECT_NEAR(difference_d.mean_d(), 0.0, 1e-4);
            // An accommodated eye's entrance pupil lies nearer to the cornea, where the cylinder
            // is.
            EXPECT_NEAR(difference_d.astigmatism_d(), 0.0, 0.01);
            for (const V2d& p_m : {V2d(0.05e-3, 0.0), V2d(-0.03e-3, 0.04e-3)}) {
                const EyeRay ray = eye->ray(V2d(0.0), p_m, 555.0);
                ASSERT_EQ(ray.fate, RayFate::Transmitted);
                const V2d expected = paraxial->ray(V2d(0.0), p_m, 555.0).slope;
                // 0.01 D of the pupil's 0.05 mm.
                EXPECT_NEAR((ray.slope - expected).length(), 0.0, 0.01 * 0.05e-3)
                    << to_string(kind);
                EXPECT_NEAR((V2d(ray.origin_eye_m.x, ray.origin_eye_m.y) - p_m).length(), 0.0,
                            1e-8);
            }
        }
    }
}

TEST(SchematicEye, has_the_spherical_aberration_of_its_surfaces)
{
    // Marginal minus paraxial conjugate in dioptres at 1, 2 and 3 mm in the entrance pupil.
    struct Row {
        EyeModelKind kind;
        std::array<double, 3> aberration_d;
    };
    constexpr std::array<Row, 3> table{{{EyeModelKind::LeGrand, {0.37, 1.56, 3.94}},
                                        {EyeModelKind::Navarro, {0.13, 0.57, 1.44}},
                                        {EyeModelKind::Arizona, {0.11, 0.50, 1.34}}}};
    for (const Row& row : table) {
        const auto eye =
            make_eye({.model = row.kind, .pupil_diameter_m = 6e-3, .exact_trace = true});
        for (int mm = 1; mm <= 3; ++mm) {
            const EyeRay ray = eye->ray(V2d(0.0), {mm * 1e-3, 0.0}, 555.0);
            EXPECT_NEAR(-ray.slope.x / ray.origin_eye_m.x,
                        row.aberration_d[static_cast<std::size_t>(mm - 1)], 0.02)
                << to_string(row.kind) << ' ' << mm << " mm";
        }
    }
}

TEST(SchematicEye, axis_30_tilts_the_streak_to_60_degrees)
{
    // -6 x 30: the power acts across the axis, which the patient sees at 150 degrees.
    const auto eye = make_eye({.model = EyeModelKind::Navarro,
                               .rx = Prescription{.cylinder_d = -6.0, .axis_deg = 30.0},
                               .pupil_diameter_m = 1e-3});
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (int i = 0; i < 360; i += 5) {
        const double angle_rad = i * std::acos(-1.0) / 180.0;
        const V2d p_m = V2d(std::cos(angle_rad), std::sin(angle_rad)) * 0.5e-3;
        const V2d slope = eye->ray(V2d(0.0), p_m, 555.0).slope;
        xx += slope.x * slope.x;
        xy += slope.x * slope.y;
        yy += slope.y * slope.y;
    }
    EXPECT_NEAR(0.5 * std::atan2(2.0 * xy, xx - yy) * 180.0 / std::acos(-1.0), 60.0, 0.01);
}

TEST(SchematicEye, is_too_strong_in_the_blue)
{
    // K(wavelength) - K(555 nm), dioptres, paraxially traced.
    struct Row {
        double wavelength_nm, navarro_d, le_grand_d;
    };
    constexpr std::array<Row, 4> table{{{400.0, 1.906, 1.301},
                                        {486.0, 0.511, 0.440},
                                        {589.0, -0.171, -0.169},
                                        {700.0, -0.558, -0.579}}};
    constexpr double height_m = 0.05e-3;
    for (const auto kind : {EyeModelKind::Navarro, EyeModelKind::LeGrand}) {
        const auto eye =
            make_eye({.model = kind, .pupil_diameter_m = 2.0 * height_m, .exact_trace = true});
        for (const Row& row : table) {
            const EyeRay ray = eye->ray(V2d(0.0), {height_m, 0.0}, row.wavelength_nm);
            EXPECT_NEAR(-ray.slope.x / ray.origin_eye_m.x,
                        kind == EyeModelKind::Navarro ? row.navarro_d : row.le_grand_d, 0.003)
                << to_string(kind) << ' ' << row.wavelength_nm;
        }
    }
}

TEST(SchematicEye, answers_or_refuses_at_the_extremes_but_never_nan)
{
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int answered = 0;
    for (int i = 0; i < 24; ++i) {
        const EyeSpec spec{
            .model = kinds[static_cast<std::size_t>(i % 3)],
            .rx = Prescription{.sphere_d = uniform(-30.0, 30.0),
                               .cylinder_d = uniform(-12.0, 12.0),
                               .axis_deg = uniform(0.0, 180.0)},
            .pupil_diameter_m = i % 5 == 0 ? 0.0 : uniform(0.0, 9e-3),
            .accommodation_d = i % 2 == 0 ? 0.0 : uniform(0.0, 15.0),
            .zero = refraction_zeros[static_cast<std::size_t>(i / 3 % 2)],
            .exact_trace = i % 4 != 0,
        };
        std::unique_ptr<EyeModel> eye;
        try {
            eye = make_eye(spec);
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).find(" D"), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find("nan"), std::string::npos) << error.what();
            continue;
        }
        ++answered;
        const PowerMatrix k = eye->retinal_conjugate_d();
        EXPECT_TRUE(std::isfinite(k.xx_d + k.xy_d + k.yy_d));
        for (int j = 0; j < 40; ++j) {
            const double far = j % 4 == 0 ? 50.0 : 1.0;
            const V2d u(far * uniform(-1.0, 1.0), far * uniform(-1.0, 1.0));
            const double radius_m = 0.5 * spec.pupil_diameter_m;
            const V2d p_m(radius_m * uniform(-1.0, 1.0), radius_m * uniform(-1.0, 1.0));
            const EyeRay ray = eye->ray(u, p_m, uniform(300.0, 900.0));
            EXPECT_TRUE(std::isfinite(ray.slope.x + ray.slope.y + ray.origin_eye_m.x +
                                      ray.origin_eye_m.y));
            EXPECT_EQ(ray.weight, ray.fate == RayFate::Transmitted ? 1.0 : 0.0);
        }
    }
    EXPECT_GE(answered, 12);
}

// A fitted ray is the exact one but for its last digits, and never to all of them.
bool is_fitted_at(double field_deg, EyeSpec spec)
{
    const V2d chief(std::tan(rad_from_deg(field_deg)), 0.0);
    const auto slope = [&] { return make_eye(spec)->ray(chief, {1e-3, 0.0}, 500.0).slope; };
    spec.exact_trace = false;
    const V2d fitted = slope();
    spec.exact_trace = true;
    return fitted != slope();
}

TEST(SchematicEye, fitted_rays_are_exact_rays_to_0_02_arcmin)
{
    // 0.02 arcmin; and of the places on the plane of the pupil, what this makes on the way from
    // the cornea.
    constexpr double tolerance = 5.8e-6;
    constexpr double tolerance_m = 1e-7;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const std::array prescriptions{
        Prescription{.sphere_d = -6.0},
        Prescription{.sphere_d = 4.0, .cylinder_d = -3.0, .axis_deg = 30.0}};
    for (const EyeModelKind kind : kinds) {
        for (const Prescription& rx : prescriptions) {
            EyeSpec spec{.model = kind, .rx = rx, .pupil_diameter_m = 6e-3};
            const auto fitted = make_eye(spec);
            spec.exact_trace = true;
            const auto exact = make_eye(spec);
            EXPECT_TRUE(is_fitted_at(39.9, spec));
            EXPECT_GT(fitted->approximation_arcmin(), 0.0);
            EXPECT_LT(fitted->approximation_arcmin(), 0.006);
            for (int i = 0; i < 50; ++i) {
                const V2d u(0.36 * uniform(random), 0.36 * uniform(random));
                const V2d p_m(2.1e-3 * uniform(random), 2.1e-3 * uniform(random));
                const double wavelength_nm = 580.0 + 200.0 * uniform(random);
                const EyeRay a = fitted->ray(u, p_m, wavelength_nm);
                const EyeRay b = exact->ray(u, p_m, wavelength_nm);
                ASSERT_EQ(a.fate, b.fate);
                EXPECT_NEAR((a.slope - b.slope).length(), 0.0, tolerance) << u << p_m;
                EXPECT_NEAR((a.origin_eye_m - b.origin_eye_m).length(), 0.0, tolerance_m);
                EXPECT_NE(a.slope, b.slope);
            }
        }
    }
}

TEST(SchematicEye, is_fitted_over_a_narrower_field_when_that_is_what_it_takes)
{
    // The conics of the accommodated Arizona eye are strong.
    const EyeSpec spec{.model = EyeModelKind::Arizona, .accommodation_d = 5.0};
    EXPECT_FALSE(is_fitted_at(39.0, spec));
    EXPECT_TRUE(is_fitted_at(19.0, spec));
    const auto eye = make_eye(spec);
    EXPECT_GT(eye->approximation_arcmin(), 0.0);
    EXPECT_LE(eye->approximation_arcmin(), 0.02);
    EXPECT_TRUE(eye->fitted_field_deg() == 20.0 || eye->fitted_field_deg() == 30.0);
}

TEST(SchematicEye, that_no_fit_does_right_says_so_and_is_traced_exactly)
{
    const EyeSpec spec{
        .model = EyeModelKind::Arizona, .pupil_diameter_m = 8e-3, .accommodation_d = 6.67};
    EXPECT_FALSE(is_fitted_at(1.0, spec));
    const auto eye = make_eye(spec);
    EXPECT_EQ(eye->fitted_field_deg(), std::nullopt);
    EXPECT_EQ(eye->approximation_arcmin(), 0.0);
}

TEST(SchematicEye, sees_invisible_wavelengths_as_the_nearest_visible_one)
{
    for (const bool exact_trace : {false, true}) {
        const auto eye = make_eye({.model = EyeModelKind::Navarro, .exact_trace = exact_trace});
        const V2d u(0.1, 0.0);
        const V2d p_m(1e-3, 0.0);
        EXPECT_EQ(eye->ray(u, p_m, 130.0).slope, eye->ray(u, p_m, 380.0).slope);
        EXPECT_EQ(eye->ray(u, p_m, 1e4).slope, eye->ray(u, p_m, 780.0).slope);
        EXPECT_NE(eye->ray(u, p_m, 381.0).slope, eye->ray(u, p_m, 380.0).slope);
    }
}

TEST(SchematicEye, is_traced_exactly_beyond_its_fitted_field)
{
    EyeSpec spec{.model = EyeModelKind::Navarro};
    EXPECT_TRUE(is_fitted_at(39.9, spec));
    EXPECT_FALSE(is_fitted_at(40.1, spec));
    EXPECT_EQ(make_eye(spec)->fitted_field_deg(), 40.0);
    spec.worn = glasses({.sphere_d = 2.0}, 12e-3);
    EXPECT_EQ(make_eye(spec)->fitted_field_deg(), 40.0);
    spec.worn.reset();
    spec.exact_trace = true;
    EXPECT_EQ(make_eye(spec)->approximation_arcmin(), 0.0);
    EXPECT_EQ(make_eye(spec)->fitted_field_deg(), std::nullopt);
}

TEST(SchematicEye, refracts_a_person_by_the_least_spot_when_asked_to)
{
    // Of the spots at all distances, seen from the eye, that at the far point has the least RMS.
    const auto eye = make_eye({.model = EyeModelKind::Navarro,
                               .rx = Prescription{.sphere_d = -2.0},
                               .rx_plane = RxPlane::EntrancePupil,
                               .pupil_diameter_m = 6e-3,
                               .zero = RefractionZero::MinimumRmsSpot});
    EXPECT_NEAR(eye->retinal_conjugate_d().mean_d(), 2.0, 1e-9);
    const auto spot = [&](double vergence_d) {
        double sum = 0.0;
        for (int i = 0; i < 256; ++i) {
            const double height_m = 3e-3 * std::sqrt((i + 0.5) / 256.0);
            const EyeRay ray = eye->ray(V2d(0.0), {height_m, 0.0}, 555.0);
            const double blur = ray.slope.x + vergence_d * ray.origin_eye_m.x;
            sum += blur * blur;
        }
        return sum;
    };
    EXPECT_LT(spot(2.0), spot(1.99));
    EXPECT_LT(spot(2.0), spot(2.01));
    // Its paraxial refraction is less myopic: its aberration is positive.
    EXPECT_LT(-eye->ray(V2d(0.0), {0.1e-3, 0.0}, 555.0).slope.x / 0.1e-3, 1.5);
}

TEST(SchematicEye, transmits_all_of_a_wide_pupil_on_the_axis_and_is_vignetted_far_from_it)
{
    const auto eye = make_eye({.model = EyeModelKind::Navarro, .pupil_diameter_m = 8e-3});
    EXPECT_EQ(eye->ray(V2d(0.0), {0.0, 4e-3}, 555.0).fate, RayFate::Transmitted);
    EXPECT_EQ(eye->ray({1.5, 0.0}, {-4e-3, 0.0}, 555.0).fate, RayFate::Vignetted);
    EXPECT_EQ(eye->ray({1.5, 0.0}, {0.0, 0.0}, 555.0).fate, RayFate::Transmitted);
}

}  // namespace
}  // namespace eye_render
