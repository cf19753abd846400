#include "trial.h"

#include "base/units.h"
#include "optics/population_wavefront.h"

#include <cmath>
#include <ostream>
#include <regex>

namespace eye_render::test {

namespace {

// All terms to the 6th order, of both signs and different sizes.
Wavefront wavefront_of(const Trial& trial)
{
    Wavefront wavefront{.pupil_diameter_m = max_pupil_diameter_m};
    for (std::size_t j = 0; j < max_zernike_terms; ++j) {
        wavefront.coefficients_um.push_back(trial.wavefront_um *
                                            std::sin(2.0 * static_cast<double>(j) + 1.0));
    }
    return wavefront;
}

}  // namespace

std::optional<WornLens> lens_of(const Trial& trial)
{
    if (!trial.glasses) return std::nullopt;
    return glasses({.sphere_d = trial.lens_sphere_d,
                    .cylinder_d = trial.lens_cylinder_d,
                    .axis_deg = trial.lens_axis_deg},
                   m_from_mm(trial.vertex_mm));
}

EyeSpec spec_of(const Trial& trial)
{
    EyeSpec spec{.model = trial.model,
                 .rx = Prescription{.sphere_d = trial.sphere_d,
                                    .cylinder_d = trial.cylinder_d,
                                    .axis_deg = trial.axis_deg},
                 .rx_plane = trial.rx_plane,
                 .vertex_m = m_from_mm(trial.vertex_mm),
                 .pupil_diameter_m = m_from_mm(trial.pupil_mm),
                 .accommodation_d = trial.accommodation_d,
                 .eye_length_m = m_from_mm(trial.eye_length_mm),
                 .zero = trial.zero,
                 .exact_trace = trial.exact_trace,
                 .worn = lens_of(trial)};
    if (trial.model != EyeModelKind::Wavefront) return spec;
    spec.wavefront =
        trial.mean_wavefront
            ? population_wavefront(std::max(spec.pupil_diameter_m, min_wavefront_pupil_m))
            : wavefront_of(trial);
    return spec;
}

std::unique_ptr<EyeModel> made(const Trial& trial)
{
    try {
        return make_eye(spec_of(trial));
    } catch (const std::invalid_argument& error) {
        EXPECT_TRUE(is_proper_refusal(error.what())) << trial;
        return nullptr;
    }
}

testing::AssertionResult is_proper_refusal(const std::string& text)
{
    static const std::string number = R"((?:-?\d+(?:\.\d+)?(?:e[+-]\d+)?|-?nan|-?inf))";
    static const std::regex sentence("[A-Za-z][\\w ]* (?:is|of) " + number +
                                     "((?: prism dioptres| [A-Za-z][\\w/]*)?).*; expected .*" +
                                     number + "\\1(?: in .*)?");
    if (std::regex_match(text, sentence)) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "'" << text << "' lacks a name, a value, a unit or what is expected";
}

V2d chief_slope(const Trial& trial) { return {trial.slope_x, trial.slope_y}; }

V2d pupil_point_m(const Trial& trial)
{
    const double radius_m = m_from_mm(0.5 * trial.pupil_mm) * trial.pupil_share;
    const double angle_rad = rad_from_deg(trial.pupil_angle_deg);
    return {radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)};
}

EyeRay ray_of(const EyeModel& eye, const Trial& trial)
{
    return eye.ray(chief_slope(trial), pupil_point_m(trial), trial.wavelength_nm);
}

std::ostream& operator<<(std::ostream& out, const Trial& trial)
{
    const auto precision = out.precision(17);
    out << to_string(trial.model) << ", rx at " << to_string(trial.rx_plane) << ", zero "
        << to_string(trial.zero) << (trial.exact_trace ? ", exact" : ", fitted")
        << (trial.mean_wavefront ? ", mean wavefront" : "") << (trial.glasses ? ", glasses" : "");
    for (const std::span<const Input> inputs :
         {std::span<const Input>(eye_inputs), std::span<const Input>(lens_inputs),
          std::span<const Input>(ray_inputs), std::span<const Input>(&object_input, 1)}) {
        for (const Input& input : inputs) out << ", " << input.name << ' ' << trial.*input.value;
    }
    out.precision(precision);
    return out;
}

double Random::uniform(double minimum, double maximum)
{
    constexpr double bits_53 = 0x1p-53;
    return minimum + (maximum - minimum) * (static_cast<double>(bits_() >> 11) * bits_53);
}

std::size_t Random::index(std::size_t count) { return bits_() % count; }

double Random::value(const Input& input)
{
    switch (index(8)) {
    case 0: return input.minimum;
    case 1: return input.maximum;
    default: return uniform(input.minimum, input.maximum);
    }
}

void Random::draw(Trial& trial, std::span<const Input> inputs)
{
    for (const Input& input : inputs) trial.*input.value = value(input);
}

Trial Random::trial(EyeModelKind model)
{
    Trial trial{.model = model,
                .rx_plane = rx_planes[index(rx_planes.size())],
                // The search for the least spot takes longer than a hundred rays.
                .zero = index(8) == 0 ? RefractionZero::MinimumRmsSpot : RefractionZero::Paraxial,
                .glasses = index(2) == 0};
    trial.exact_trace = !is_schematic(model) || index(32) != 0;
    draw(trial, eye_inputs);
    draw(trial, lens_inputs);
    draw(trial, ray_inputs);
    trial.object_vergence_d = index(8) == 0 ? 0.0 : std::pow(10.0, uniform(-7.0, 2.0));
    return trial;
}

}  // namespace eye_render::test
