// One eye, perhaps behind glasses, and one ray through it, told by numbers alone: a sweep steps
// any of them over its whole range, and a failure prints all of them.

#pragma once

#include "eye/eye_factory.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>

namespace eye_render::test {

struct Trial {
    EyeModelKind model = EyeModelKind::Paraxial;
    RxPlane rx_plane = RxPlane::EntrancePupil;
    RefractionZero zero = RefractionZero::Paraxial;
    bool exact_trace = true;  // at a corner: a fit takes longer than a trial's rays
    bool glasses = false;

    double sphere_d = 0.0;
    double cylinder_d = 0.0;
    double axis_deg = 180.0;
    double vertex_mm = 12.0;
    double pupil_mm = 4.0;
    double accommodation_d = 0.0;
    double eye_length_mm = 17.0;
    double wavefront_um = 0.0;    // scale of a wavefront with all of its coefficients
    bool mean_wavefront = false;  // instead, the population's over this pupil

    double lens_sphere_d = 0.0;
    double lens_cylinder_d = 0.0;
    double lens_axis_deg = 180.0;

    double slope_x = 0.0;
    double slope_y = 0.0;
    double pupil_share = 0.0;  // of the pupil's radius
    double pupil_angle_deg = 0.0;
    double wavelength_nm = 555.0;

    double object_vergence_d = 0.0;
};

struct Input {
    std::string_view name;
    double Trial::*value;
    double minimum;
    double maximum;
};

inline constexpr std::array eye_inputs{
    Input{"sphere_d", &Trial::sphere_d, -30.0, 30.0},
    Input{"cylinder_d", &Trial::cylinder_d, -12.0, 12.0},
    Input{"axis_deg", &Trial::axis_deg, 0.0, 180.0},
    Input{"vertex_mm", &Trial::vertex_mm, 0.0, 20.0},
    Input{"pupil_mm", &Trial::pupil_mm, 0.0, 9.0},
    Input{"accommodation_d", &Trial::accommodation_d, 0.0, 15.0},
    Input{"eye_length_mm", &Trial::eye_length_mm, 10.0, 40.0},
    Input{"wavefront_um", &Trial::wavefront_um, -1.0, 1.0},
};

inline constexpr std::array lens_inputs{
    Input{"lens_sphere_d", &Trial::lens_sphere_d, -30.0, 30.0},
    Input{"lens_cylinder_d", &Trial::lens_cylinder_d, -12.0, 12.0},
    Input{"lens_axis_deg", &Trial::lens_axis_deg, 0.0, 180.0},
};

inline constexpr std::array ray_inputs{
    Input{"slope_x", &Trial::slope_x, -1.0, 1.0},
    Input{"slope_y", &Trial::slope_y, -1.0, 1.0},
    Input{"pupil_share", &Trial::pupil_share, 0.0, 1.0},
    Input{"pupil_angle_deg", &Trial::pupil_angle_deg, 0.0, 360.0},
    Input{"wavelength_nm", &Trial::wavelength_nm, 380.0, 780.0},
};

// 1 cm to infinity.
inline constexpr Input object_input{"object_vergence_d", &Trial::object_vergence_d, 0.0, 100.0};

// What the trial's eye looks through. Throws what glasses() throws.
[[nodiscard]] std::optional<WornLens> lens_of(const Trial& trial);

// The eye, with what its kind needs besides. Throws what glasses() throws.
[[nodiscard]] EyeSpec spec_of(const Trial& trial);

// The eye, or nothing when it is refused. A refusal that does not name what is wrong, its value
// and what is expected fails the test.
[[nodiscard]] std::unique_ptr<EyeModel> made(const Trial& trial);

// Whether a refusal has a name, a value and the range that was expected, with the same unit.
[[nodiscard]] testing::AssertionResult is_proper_refusal(const std::string& text);

[[nodiscard]] V2d chief_slope(const Trial& trial);
[[nodiscard]] V2d pupil_point_m(const Trial& trial);
[[nodiscard]] EyeRay ray_of(const EyeModel& eye, const Trial& trial);

std::ostream& operator<<(std::ostream& out, const Trial& trial);

// The same numbers with every compiler's library.
class Random {
public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}

    [[nodiscard]] double uniform(double minimum, double maximum);
    [[nodiscard]] std::size_t index(std::size_t count);

    // Anywhere in the range, and every fourth time one of its ends.
    [[nodiscard]] double value(const Input& input);

    void draw(Trial& trial, std::span<const Input> inputs);

    // All inputs, the plane of the prescription, whether glasses are worn and, for one schematic
    // eye of 32 (a fit takes as long as a hundred thousand rays), that it is fitted. The object is
    // as often near as far: its distance is uniform in the logarithm, from 1 cm to 10,000 km.
    [[nodiscard]] Trial trial(EyeModelKind model);

private:
    std::mt19937_64 bits_;
};

// Calls visit(trial) with each of the inputs at one of its ends, in all combinations.
template <typename Visit>
void at_corners(Trial trial, std::span<const Input> inputs, const Visit& visit)
{
    for (std::size_t corner = 0; corner < std::size_t{1} << inputs.size(); ++corner) {
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const bool upper = (corner >> i & 1) != 0;
            trial.*inputs[i].value = upper ? inputs[i].maximum : inputs[i].minimum;
        }
        visit(trial);
    }
}

}  // namespace eye_render::test
