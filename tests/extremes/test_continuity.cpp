// A small step of any input is a small step of the ray. The bounds are derivatives in closed form
// (steepness.h), or for eyes that have none what longer steps show (below); the steps are also
// taken across the places where the paper's equations, taken literally, have a pole or a branch.

#include "steepness.h"

#include "base/units.h"

#include <algorithm>
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

// A kind of eye, and where its wavefront comes from.
struct Eye {
    EyeModelKind model;
    bool mean_wavefront = false;

    // Whether its rays have closed derivatives: not through real surfaces, nor with a wavefront
    // from a table.
    [[nodiscard]] bool is_closed() const { return !is_schematic(model) && !mean_wavefront; }
};

std::vector<Eye> all_eyes()
{
    std::vector<Eye> eyes;
    for (const EyeModelKind model : eye_model_kinds) eyes.push_back({model});
    eyes.push_back({EyeModelKind::Wavefront, true});
    return eyes;
}

void PrintTo(const Eye& eye, std::ostream* out)
{
    *out << to_string(eye.model) << (eye.mean_wavefront ? "_of_the_population" : "");
}

const Input& input_of(double Trial::*value)
{
    static const std::vector<Input> inputs = all_inputs();
    return *std::ranges::find(inputs, value, &Input::value);
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

class Continuity : public testing::TestWithParam<Eye> {
protected:
    void TearDown() override { RecordProperty("worst_share_of_bound", std::to_string(worst_)); }

    [[nodiscard]] static Trial trial_of(Random& random)
    {
        Trial trial = random.trial(GetParam().model);
        trial.mean_wavefront = GetParam().mean_wavefront;
        return trial;
    }

    // How many trials there is time for.
    [[nodiscard]] static int trials(int of_thin_eyes, int of_schematic_eyes)
    {
        return is_schematic(GetParam().model) ? of_schematic_eyes : of_thin_eyes;
    }

    // The change of the ray against what it may be; whether both can be told.
    bool check(const Step& step)
    {
        const std::optional<double> changed = change(step);
        if (!changed) return false;
        const std::optional<double> bound =
            GetParam().is_closed() ? closed_bound(step) : bound_by_longer_steps(exact(step));
        if (!bound) return false;
        const double most = *bound + fit_rad(step);
        EXPECT_LE(*changed, most) << step;
        worst_ = std::max(worst_, *changed / most);
        return true;
    }

    // The step of the eye that traces every ray.
    static Step exact(Step step)
    {
        step.from.exact_trace = step.to.exact_trace = true;
        return step;
    }

    // By what a fit may be off: it has tried a share of the rays.
    static double fit_rad(const EyeModel& eye)
    {
        constexpr double untried = 1.5;
        return untried * eye.approximation_arcmin() / arcmin_from_rad(1.0);
    }

    // Of both eyes, one of which may be fitted over another field.
    static double fit_rad(const Step& step)
    {
        if (step.from.exact_trace) return 0.0;
        return fit_rad(*made(step.from)) + fit_rad(*made(step.to));
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

    // How far the searches of an exact trace may end from the ray: 1e-15 m on the retina of an eye
    // that is 10 mm long or more, and ten times that where rays leave it obliquely.
    static constexpr double search_rad = 1e-12;

private:
    static double closed_bound(const Step& step)
    {
        const Steepness before(step.from);
        const Steepness after(step.to);
        // Inside of the step the derivative is hardly more than at its ends.
        constexpr double curved = 1.01;
        const double steepness = curved * std::max(before.of(step.input), after.of(step.input));
        // Rounding: a few dozen operations on slopes of this size.
        const double rounding = 1e-14 * (1.0 + before.strongest_d() * 0.1);
        return steepness * step.size() + rounding;
    }

    // From where a step starts, what it changes is g(t) = a t + b t^2 to second order. Steps of
    // the lengths H and 2 H in its direction change g(H) and g(2 H), neither more than M, so that
    //     |a| = |4 g(H) - g(2 H)| / 2 H <= 5 M / 2 H,   |b| = |g(2 H) - 2 g(H)| / 2 H^2 <= 3 M / 2
    //     H^2
    // and the step of length h changes at most M (h / H) (5 + 3 h / H) / 2. Higher orders may add
    // as much again; so may what begins like the root of t, where a ray comes out of grazing. A
    // jump within the step is as high for the longer ones and so is above a third of M. Steps
    // that leave the input's range, or rays that are lost on the way, are replaced by those of the
    // step back; nothing when those fail as well.
    static std::optional<double> bound_by_longer_steps(const Step& step)
    {
        constexpr double longer = 16.0;
        constexpr double higher_orders = 2.0;
        constexpr double per_change = higher_orders * (5.0 + 3.0 / longer) / (2.0 * longer);
        for (const Step& first : {step, Step{step.to, step.from, step.input}}) {
            const Step twice = lengthened(first, 2.0 * longer);
            const double end = twice.to.*step.input.value;
            if (end < step.input.minimum || end > step.input.maximum) continue;
            const auto changed = change(lengthened(first, longer));
            const auto changed_twice = change(twice);
            if (changed && changed_twice) {
                return per_change * std::max(*changed, *changed_twice) + search_rad;
            }
        }
        return std::nullopt;
    }

    static Step lengthened(const Step& step, double times)
    {
        Step result = step;
        double Trial::*value = step.input.value;
        result.to.*value = step.from.*value + times * (step.to.*value - step.from.*value);
        return result;
    }
};

TEST_P(Continuity, small_steps_of_any_input_are_small_steps_of_the_ray)
{
    Random random(2);
    const int count = trials(4000, 60);
    int compared = 0;
    for (int i = 0; i < count; ++i) {
        const Trial from = trial_of(random);
        for (const Input& input : all_inputs()) {
            Step step{from, from, input};
            const double range = input.maximum - input.minimum;
            const double size = range * std::pow(10.0, random.uniform(-9.0, -4.0));
            double& value = step.to.*input.value;
            value += value + size <= input.maximum ? size : -size;
            compared += check(step) ? 1 : 0;
        }
    }
    EXPECT_GT(compared, count * 4);
}

// Steps over a 64th of the range are halved, each time to the half in which the ray changes
// more, and so lead to a jump if there is one.
TEST_P(Continuity, has_no_jump_anywhere_over_the_range_of_an_input)
{
    constexpr int pieces = 64;
    constexpr int halvings = 24;
    Random random(6);
    int compared = 0;
    for (int i = 0; i < (GetParam().is_closed() ? 5 : 1); ++i) {
        Trial trial = trial_of(random);
        trial.exact_trace = true;  // a fit for each of 50000 eyes would take an hour
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
    struct Spot {
        double Trial::*value;
        double at;
    };
    constexpr Spot spots[] = {
        {&Trial::sphere_d, 0.0},          {&Trial::cylinder_d, 0.0},
        {&Trial::axis_deg, 90.0},         {&Trial::lens_sphere_d, 0.0},
        {&Trial::lens_cylinder_d, 0.0},   {&Trial::slope_x, 0.0},
        {&Trial::slope_y, 0.0},           {&Trial::pupil_angle_deg, 90.0},
        {&Trial::pupil_angle_deg, 180.0}, {&Trial::wavelength_nm, 555.0},
    };
    Random random(3);
    int compared = 0;
    for (int i = 0; i < trials(1000, 12); ++i) {
        const Trial trial = trial_of(random);
        for (const Spot& spot : spots) {
            for (const double size : {1e-4, 1e-8, 1e-300}) {
                Step step{trial, trial, input_of(spot.value)};
                step.from.*spot.value = spot.at - size;
                step.to.*spot.value = spot.at + size;
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
    constexpr double sizes_d[] = {1e-6, 1e-9, 1e-15, 1e-300, 5e-324};
    const int count = trials(1000, 20);
    int compared = 0;
    for (int i = 0; i < count; ++i) {
        const Trial trial = trial_of(random);
        for (const double size_d : sizes_d) {
            Step step{trial, trial, input_of(&Trial::accommodation_d)};
            step.from.accommodation_d = 0.0;
            step.to.accommodation_d = size_d;
            compared += check(step) ? 1 : 0;
        }
    }
    EXPECT_GT(compared, count);
}

// Inside of the edge rays are fitted, outside they are traced.
TEST_P(Continuity, crosses_the_edge_of_the_fitted_field_within_what_the_fit_is_off_by)
{
    if (!is_schematic(GetParam().model)) GTEST_SKIP() << "has no fit";
    Random random(8);
    int compared = 0;
    for (int i = 0; i < 24; ++i) {
        Trial trial = trial_of(random);
        trial.zero = RefractionZero::Paraxial;
        trial.exact_trace = true;
        const auto exact_eye = made(trial);
        trial.exact_trace = false;
        const auto eye = made(trial);
        if (!eye || !eye->fitted_field_deg()) continue;
        const double edge = std::tan(rad_from_deg(*eye->fitted_field_deg()));
        for (int j = 0; j < 24; ++j) {
            random.draw(trial, std::span(ray_inputs).subspan(2));
            const double direction_rad = random.uniform(0.0, 2.0 * pi);
            const auto ray_at = [&](const EyeModel& of, double share) {
                const V2d slope =
                    V2d(std::cos(direction_rad), std::sin(direction_rad)) * (share * edge);
                return of.ray(slope, pupil_point_m(trial), trial.wavelength_nm);
            };
            for (const double size : {1e-4, 1e-7, 1e-12}) {
                const EyeRay inside = ray_at(*eye, 1.0 - size);
                const EyeRay exact_inside = ray_at(*exact_eye, 1.0 - size);
                const EyeRay outside = ray_at(*eye, 1.0 + size);
                EXPECT_EQ(inside.fate, exact_inside.fate) << trial;
                // Beyond the edge a ray may be lost: the fit ends there for that.
                if (inside.fate != RayFate::Transmitted) continue;
                if (outside.fate != RayFate::Transmitted) continue;
                EXPECT_LE(angle_rad(inside.slope, outside.slope),
                          angle_rad(exact_inside.slope, outside.slope) + fit_rad(*eye) +
                              search_rad)
                    << "at " << *eye->fitted_field_deg() << " degrees, " << size << ", " << trial;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 300);
}

INSTANTIATE_TEST_SUITE_P(OfEveryEye,
                         Continuity,
                         testing::ValuesIn(all_eyes()),
                         [](const auto& eye) { return testing::PrintToString(eye.param); });

}  // namespace
}  // namespace eye_render::test
