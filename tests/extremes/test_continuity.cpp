// A small step of any input is a small step of the ray and of the blur. The bounds are derivatives
// in closed form (steepness.h); the steps are also taken across the places where the paper's
// equations, taken literally, have a pole or a branch.

#include "steepness.h"

#include <cmath>
#include <vector>

namespace eye_render::test {
namespace {

// Between the directions of two rays.
double angle_rad(const V2d& a, const V2d& b)
{
    const V3d from(a.x, a.y, -1.0);
    const V3d to(b.x, b.y, -1.0);
    return std::atan2(from.cross(to).length(), from.dot(to));
}

std::vector<Input> all_inputs()
{
    std::vector<Input> inputs(eye_inputs.begin(), eye_inputs.end());
    inputs.insert(inputs.end(), lens_inputs.begin(), lens_inputs.end());
    inputs.insert(inputs.end(), ray_inputs.begin(), ray_inputs.end());
    return inputs;
}

struct Step {
    Trial from;
    Trial to;
    Input input;

    [[nodiscard]] double size() const { return std::abs(to.*input.value - from.*input.value); }
};

std::ostream& operator<<(std::ostream& out, const Step& step)
{
    return out << "from " << step.from << "\nto " << step.input.name << ' '
               << step.to.*step.input.value;
}

class Continuity : public testing::TestWithParam<EyeModelKind> {
protected:
    // The change of the ray against what it may be; whether both rays exist.
    bool check(const Step& step)
    {
        const std::optional<double> changed = change(step);
        if (!changed) return false;
        const double bound = bound_of(step);
        EXPECT_LE(*changed, bound) << step;
        worst_ = std::max(worst_, *changed / bound);
        return true;
    }

    // Of the ray, in radians; nothing unless both rays exist.
    static std::optional<double> change(const Step& step)
    {
        const auto before = made(step.from);
        const auto after = made(step.to);
        if (!before || !after) return std::nullopt;
        const EyeRay a = ray_of(*before, step.from);
        const EyeRay b = ray_of(*after, step.to);
        if (a.fate != RayFate::Transmitted || b.fate != RayFate::Transmitted) return std::nullopt;
        return angle_rad(a.slope, b.slope);
    }

    double worst_ = 0.0;  // share of the bound

private:
    static double bound_of(const Step& step)
    {
        const Steepness before(step.from);
        const Steepness after(step.to);
        // Inside of the step the derivative is hardly more than at its ends.
        constexpr double curved = 1.01;
        const double steepness = curved * std::max(before.of(step.input), after.of(step.input));
        // Rounding: a few dozen operations on slopes of this size.
        const double rounding = 1e-14 * (1.0 + before.strongest_d() * 0.1);
        if (!is_schematic(step.from.model)) return steepness * step.size() + rounding;
        return schematic_bound(step, steepness);
    }

    // Real surfaces do what the thin lens does and aberrate: at a wide pupil's rim and 54 degrees
    // off the axis several times as much. The first term scales the thin lens's bound; the second
    // stands for aberrations that the thin lens has none of, as a share of each input's range.
    static double schematic_bound(const Step& step, double steepness)
    {
        constexpr double thin_lens = 10.0;
        constexpr double aberrations = 2.0;
        constexpr double search = 1e-9;  // how far the searches for a ray end from it
        const double share = step.size() / (step.input.maximum - step.input.minimum);
        return thin_lens * steepness * step.size() + aberrations * share + search;
    }
};

TEST_P(Continuity, small_steps_of_any_input_are_small_steps_of_the_ray)
{
    Random random(2);
    const int trials = is_schematic(GetParam()) ? 60 : 4000;
    int compared = 0;
    for (int i = 0; i < trials; ++i) {
        const Trial from = random.trial(GetParam());
        for (const Input& input : all_inputs()) {
            Step step{from, from, input};
            const double range = input.maximum - input.minimum;
            const double size = range * std::pow(10.0, random.uniform(-9.0, -4.0));
            double& value = step.to.*input.value;
            value += value + size <= input.maximum ? size : -size;
            compared += check(step) ? 1 : 0;
        }
    }
    EXPECT_GT(compared, trials * 4);
    RecordProperty("compared", compared);
    RecordProperty("worst_share_of_bound", std::to_string(worst_));
}

// Steps over a 64th of the range are halved, each time to the half in which the ray changes
// more, and so lead to a jump if there is one.
TEST_P(Continuity, has_no_jump_anywhere_over_the_range_of_an_input)
{
    constexpr int pieces = 64;
    constexpr int halvings = 24;
    Random random(6);
    int compared = 0;
    for (int i = 0; i < (is_schematic(GetParam()) ? 1 : 5); ++i) {
        const Trial trial = random.trial(GetParam());
        for (const Input& input : all_inputs()) {
            const double width = (input.maximum - input.minimum) / pieces;
            for (int piece = 0; piece < pieces; ++piece) {
                Step step{trial, trial, input};
                step.from.*input.value = input.minimum + piece * width;
                step.to.*input.value = input.minimum + (piece + 1) * width;
                for (int halving = 0; halving < halvings; ++halving) {
                    Trial middle = trial;
                    middle.*input.value = 0.5 * (step.from.*input.value + step.to.*input.value);
                    (change({step.from, middle, input}) > change({middle, step.to, input})
                         ? step.to
                         : step.from) = middle;
                }
                compared += check(step) ? 1 : 0;
            }
        }
    }
    EXPECT_GT(compared, pieces);
}

// Where equation 6 or 8, or a formula for the axis, has a pole or a branch, or may have one.
TEST_P(Continuity, has_no_jump_at_a_singular_spot)
{
    const Input spots[] = {
        {"sphere_d", &Trial::sphere_d, 0.0, 0.0},
        {"cylinder_d", &Trial::cylinder_d, 0.0, 0.0},
        {"axis_deg", &Trial::axis_deg, 90.0, 90.0},
        {"lens_sphere_d", &Trial::lens_sphere_d, 0.0, 0.0},
        {"lens_cylinder_d", &Trial::lens_cylinder_d, 0.0, 0.0},
        {"slope_x", &Trial::slope_x, 0.0, 0.0},
        {"slope_y", &Trial::slope_y, 0.0, 0.0},
        {"pupil_angle_deg", &Trial::pupil_angle_deg, 90.0, 90.0},
        {"pupil_angle_deg", &Trial::pupil_angle_deg, 180.0, 180.0},
        {"wavelength_nm", &Trial::wavelength_nm, 555.0, 555.0},
    };
    Random random(3);
    int compared = 0;
    for (int i = 0; i < (is_schematic(GetParam()) ? 12 : 1000); ++i) {
        const Trial trial = random.trial(GetParam());
        for (const Input& spot : spots) {
            for (const double size : {1e-4, 1e-8, 1e-300}) {
                Step step{trial, trial, {spot.name, spot.value, 0.0, 1.0}};
                step.from.*spot.value = spot.minimum - size;
                step.to.*spot.value = spot.minimum + size;
                compared += check(step) ? 1 : 0;
            }
        }
    }
    EXPECT_GT(compared, 100);
}

TEST_P(Continuity, accommodation_sets_in_without_a_jump)
{
    // The paper's distance D = 1/accommodation is infinite for none: inf - inf in equation 6.
    Random random(4);
    std::vector<double> sizes{1e-6, 1e-9};
    // The schematic eyes' lens is found by a search for what their surfaces do.
    if (!is_schematic(GetParam())) sizes.insert(sizes.end(), {1e-15, 1e-300, 5e-324});
    for (int i = 0; i < (is_schematic(GetParam()) ? 20 : 1000); ++i) {
        const Trial trial = random.trial(GetParam());
        for (const double size : sizes) {
            Step step{trial, trial, {"accommodation_d", &Trial::accommodation_d, 0.0, 1.0}};
            step.from.accommodation_d = 0.0;
            step.to.accommodation_d = size;
            check(step);
        }
    }
}

TEST_P(Continuity, the_blur_follows_the_object_from_1_cm_through_the_glasses_to_infinity)
{
    Random random(5);
    for (int i = 0; i < (is_schematic(GetParam()) ? 100 : 2000); ++i) {
        Trial trial = random.trial(GetParam());
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
            }
        }
        EXPECT_EQ(eye->error_d(0.0).xx_d, eye->error_d(-0.0).xx_d) << trial;
    }
}

INSTANTIATE_TEST_SUITE_P(OfEveryEye,
                         Continuity,
                         testing::ValuesIn(eye_model_kinds),
                         [](const auto& eye) { return std::string(to_string(eye.param)); });

}  // namespace
}  // namespace eye_render::test
