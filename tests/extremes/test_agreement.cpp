// Different ways to say the same eye see the same, whatever the numbers: forms of a prescription,
// models where theory makes them one, corrections and their absence.

#include "trial.h"

#include "api/eye.h"
#include "base/units.h"

#include <cmath>

namespace eye_render::test {
namespace {

constexpr int thin_trials = 5000;
constexpr int schematic_trials = 200;

int trials_of(EyeModelKind model) { return is_schematic(model) ? schematic_trials : thin_trials; }

// Of the slopes of two rays that are the same but for rounding: 1e-16 of the vergence at the
// pupil, up to 400 D for a prescription near its own focus, times 4.5 mm, through steps that
// magnify by up to 100 there.
constexpr double thin_rounding = 1e-12;
// How far apart the searches of an exact trace may end.
constexpr double search_rounding = 1e-9;

// Whether both eyes exist, and then their rays, compared.
bool compare(const Trial& a, const Trial& b)
{
    const auto eye_a = made(a);
    const auto eye_b = made(b);
    EXPECT_EQ(eye_a == nullptr, eye_b == nullptr) << a << "\nand\n" << b;
    if (!eye_a || !eye_b) return false;
    const EyeRay ray_a = ray_of(*eye_a, a);
    const EyeRay ray_b = ray_of(*eye_b, b);
    EXPECT_EQ(ray_a.fate, ray_b.fate) << a << "\nand\n" << b;
    const double rounding = is_schematic(a.model) ? search_rounding : thin_rounding;
    EXPECT_LE((ray_a.slope - ray_b.slope).length(), rounding) << a << "\nand\n" << b;
    EXPECT_LE((ray_a.origin_eye_m - ray_b.origin_eye_m).length(), rounding) << a << "\nand\n" << b;
    return true;
}

class Agreement : public testing::TestWithParam<EyeModelKind> {};

TEST_P(Agreement, both_forms_of_a_prescription_give_the_same_rays)
{
    Random random(11);
    int compared = 0;
    for (int i = 0; i < trials_of(GetParam()); ++i) {
        const Trial minus = random.trial(GetParam());
        Trial plus = minus;
        const auto transpose = [](double& sphere_d, double& cylinder_d, double& axis_deg) {
            const Prescription other =
                transposed({.sphere_d = sphere_d, .cylinder_d = cylinder_d, .axis_deg = axis_deg});
            sphere_d = other.sphere_d;
            cylinder_d = other.cylinder_d;
            axis_deg = other.axis_deg;
        };
        transpose(plus.sphere_d, plus.cylinder_d, plus.axis_deg);
        transpose(plus.lens_sphere_d, plus.lens_cylinder_d, plus.lens_axis_deg);
        // The other form's sphere may be more than a lens has.
        if (std::max(std::abs(plus.sphere_d), std::abs(plus.lens_sphere_d)) > max_sphere_d) {
            continue;
        }
        compared += compare(minus, plus) ? 1 : 0;
    }
    EXPECT_GT(compared, trials_of(GetParam()) / 10);
}

TEST_P(Agreement, axis_0_is_axis_180)
{
    Random random(12);
    for (int i = 0; i < trials_of(GetParam()); ++i) {
        Trial zero = random.trial(GetParam());
        zero.axis_deg = zero.lens_axis_deg = 0.0;
        Trial half_turn = zero;
        half_turn.axis_deg = half_turn.lens_axis_deg = 180.0;
        compare(zero, half_turn);
    }
}

TEST_P(Agreement, the_axis_of_no_cylinder_means_nothing)
{
    Random random(13);
    for (int i = 0; i < trials_of(GetParam()); ++i) {
        Trial some = random.trial(GetParam());
        some.cylinder_d = some.lens_cylinder_d = 0.0;
        Trial other = some;
        other.axis_deg = random.uniform(0.0, 180.0);
        other.lens_axis_deg = random.uniform(0.0, 180.0);
        compare(some, other);
    }
}

// Bent by glasses, if there are any. An eye with surfaces sees other wavelengths beside it, and
// its pupil seen from the side is not where it is from the front, where the glasses bend
// otherwise.
TEST_P(Agreement, a_closed_pupil_sees_along_the_chief_ray)
{
    Random random(14);
    for (int i = 0; i < trials_of(GetParam()); ++i) {
        Trial trial = random.trial(GetParam());
        trial.pupil_mm = 0.0;
        if (is_schematic(GetParam())) {
            trial.wavelength_nm = 555.0;
            trial.glasses = false;
        }
        const auto eye = made(trial);
        if (!eye) continue;
        const EyeRay ray = ray_of(*eye, trial);
        if (ray.fate != RayFate::Transmitted) continue;
        V2d expected = chief_slope(trial);
        if (trial.glasses && GetParam() != EyeModelKind::Pinhole) {
            const WornLens lens = lens_of(trial).value();
            expected -= lens.power_d * expected * lens.distance_m;
        }
        // A fitted eye is as near as a fit has to be: 0.02 arcmin.
        const double fitted = 0.02 / arcmin_from_rad(1.0);
        const double searched = trial.exact_trace ? search_rounding : fitted;
        EXPECT_LE((ray.slope - expected).length(), is_schematic(GetParam()) ? searched : 1e-15)
            << trial;
    }
}

TEST_P(Agreement, lenses_to_the_eyes_own_prescription_make_it_an_emmetrope)
{
    Random random(15);
    int compared = 0;
    for (int i = 0; i < trials_of(GetParam()); ++i) {
        const Trial trial = random.trial(GetParam());
        for (const Correction correction : {Correction::Glasses, Correction::Contacts}) {
            std::unique_ptr<EyeModel> eye;
            try {
                eye = make_eye(EyeDescription{.model = GetParam(),
                                              .rx = {.sphere_d = trial.sphere_d,
                                                     .cylinder_d = trial.cylinder_d,
                                                     .axis_deg = trial.axis_deg},
                                              .rx_plane = trial.rx_plane,
                                              .vertex_mm = trial.vertex_mm,
                                              .pupil_mm = trial.pupil_mm,
                                              .correction = correction,
                                              .exact_trace = true,
                                              .wavefront = spec_of(trial).wavefront});
            } catch (const std::invalid_argument& refusal) {
                EXPECT_TRUE(is_proper_refusal(refusal.what())) << trial;
                continue;
            }
            ++compared;
            const PowerMatrix left_d = eye->error_d(0.0);
            // Roundings of up to 400 D; the lengths and radii of surfaces are found by search.
            const double rounding_d = is_schematic(GetParam()) ? 1e-6 : 1e-10;
            EXPECT_LE(std::abs(left_d.mean_d()) + left_d.astigmatism_d(), rounding_d)
                << to_string(correction) << " of " << trial;
            if (GetParam() != EyeModelKind::Paraxial) continue;
            const V2d u = chief_slope(trial);
            const V2d apart = eye->ray(u, pupil_point_m(trial), 555.0).slope -
                              eye->ray(u, V2d(0.0), 555.0).slope;
            EXPECT_LE(apart.length(), thin_rounding) << to_string(correction) << " of " << trial;
        }
    }
    EXPECT_GT(compared, trials_of(GetParam()) / 4);
}

// What the retinal conjugate means, for a ray by a micrometre from the axis.
TEST_P(Agreement, rays_next_to_the_axis_come_from_the_retinal_conjugate)
{
    Random random(19);
    constexpr double beside_m = 1e-6;
    // Aberrations of the third order and above, 1 um each over 4.5 mm, by Markov's inequality:
    // less than 0.1 slopes times the square of 1 um / 4.5 mm. Far below 0.01 D of a micrometre.
    constexpr double aberrations = 0.01 * beside_m;
    for (int i = 0; i < trials_of(GetParam()); ++i) {
        Trial trial = random.trial(GetParam());
        trial.glasses = false;
        trial.slope_x = trial.slope_y = 0.0;
        trial.wavelength_nm = 555.0;
        trial.zero = RefractionZero::Paraxial;
        if (GetParam() == EyeModelKind::Paper) trial.cylinder_d = 0.0;  // its own is no matrix
        const auto eye = made(trial);
        if (!eye) continue;
        const double angle_rad = random.uniform(0.0, 2.0 * pi);
        const V2d p_m = V2d(std::cos(angle_rad), std::sin(angle_rad)) * beside_m;
        const EyeRay ray = eye->ray(V2d(0.0), p_m, trial.wavelength_nm);
        ASSERT_EQ(ray.fate, RayFate::Transmitted) << trial;
        const V2d leaves_m(ray.origin_eye_m.x, ray.origin_eye_m.y);
        EXPECT_LE((ray.slope + eye->retinal_conjugate_d() * leaves_m).length(), aberrations)
            << trial;
    }
}

INSTANTIATE_TEST_SUITE_P(OfEveryEye,
                         Agreement,
                         testing::ValuesIn(eye_model_kinds),
                         [](const auto& eye) { return std::string(to_string(eye.param)); });

TEST(ModelAgreement, the_papers_eye_with_a_sphere_is_the_paraxial_one)
{
    Random random(16);
    int compared = 0;
    for (int i = 0; i < thin_trials; ++i) {
        Trial paper = random.trial(EyeModelKind::Paper);
        paper.cylinder_d = 0.0;
        paper.wavelength_nm = 555.0;  // the paper's eye has no colours
        if (!paper.glasses) paper.rx_plane = RxPlane::EntrancePupil;
        paper.eye_length_mm = random.uniform(10.0, 16.0);  // longer ones do not reach +54 D
        Trial paraxial = paper;
        paraxial.model = EyeModelKind::Paraxial;
        if (!made(paper)) continue;
        compared += compare(paper, paraxial) ? 1 : 0;
    }
    EXPECT_GT(compared, thin_trials / 2);
}

TEST(ModelAgreement, a_flat_wavefront_is_the_paraxial_eye)
{
    Random random(17);
    for (int i = 0; i < thin_trials; ++i) {
        Trial flat = random.trial(EyeModelKind::Wavefront);
        flat.wavefront_um = 0.0;
        Trial paraxial = flat;
        paraxial.model = EyeModelKind::Paraxial;
        compare(flat, paraxial);
    }
}

// Of rays by 0.05 mm from the axis. Their spherical aberration is that of 3 mm, up to 4 D in
// emmetropes, times (0.05 / 3)^2: 1e-3 D, and more in the steep corneas of high cylinders. Such a
// cornea shows the pupil at another depth and size along each of its meridians, so the thin eye is
// asked where the ray leaves rather than where it was aimed.
TEST(ModelAgreement, schematic_eyes_with_a_narrow_pupil_are_the_paraxial_one)
{
    Random random(18);
    constexpr double narrow_mm = 0.1;
    constexpr double first_order_d = 0.01;
    int compared = 0;
    for (int i = 0; i < 1000; ++i) {
        Trial trial = random.trial(eye_model_kinds[random.index(eye_model_kinds.size())]);
        if (!is_schematic(trial.model)) continue;
        trial.glasses = false;
        trial.pupil_mm = narrow_mm;
        trial.accommodation_d = 0.0;
        trial.slope_x = trial.slope_y = 0.0;
        trial.wavelength_nm = 555.0;
        const auto surfaces = made(trial);
        if (!surfaces) continue;
        const EyeRay ray = ray_of(*surfaces, trial);
        ASSERT_EQ(ray.fate, RayFate::Transmitted) << trial;
        trial.model = EyeModelKind::Paraxial;
        const V2d leaves_m(ray.origin_eye_m.x, ray.origin_eye_m.y);
        const V2d expected = make_eye(spec_of(trial))->ray(V2d(0.0), leaves_m, 555.0).slope;
        EXPECT_LE((ray.slope - expected).length(), first_order_d * m_from_mm(0.5 * narrow_mm))
            << trial;
        ++compared;
    }
    EXPECT_GT(compared, 200);
}

}  // namespace
}  // namespace eye_render::test
