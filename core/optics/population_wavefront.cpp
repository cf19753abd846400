// The table of the Indiana study's means.

#include "optics/population_wavefront.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eye_render {

namespace {

struct PopulationMean {
    double pupil_mm;
    std::array<double, 9> coefficients_um;  // OSA indices 6 to 14, right eye
};

constexpr std::array population_means{
    PopulationMean{3.0,
                   {-0.0078, 0.0009, 0.0024, 0.0003, -0.0008, 0.0000, 0.0069, -0.0015, -0.0038}},
    PopulationMean{4.5,
                   {-0.0171, -0.0037, 0.0004, 0.0002, -0.0042, 0.0022, 0.0304, -0.0024, -0.0132}},
    PopulationMean{6.0,
                   {-0.0206, -0.0319, 0.0017, -0.0034, -0.0172, 0.0086, 0.0942, -0.0097, -0.0107}},
    PopulationMean{7.5,
                   {-0.0638, -0.0469, -0.0215, -0.0090, -0.0333, 0.0240, 0.1652, -0.0036, 0.0108}},
};
constexpr std::size_t first_index = 6;
constexpr double measured_at_nm = 633.0;

}  // namespace

Wavefront population_wavefront(double pupil_diameter_m, EyeSide eye)
{
    require_range("pupil of the mean wavefront", mm_from_m(pupil_diameter_m),
                  mm_from_m(min_wavefront_pupil_m), mm_from_m(max_population_pupil_m), "mm");
    // Of the pupils measured, the next wider one and the one before it.
    const double pupil_mm = std::max(mm_from_m(pupil_diameter_m), population_means[0].pupil_mm);
    std::size_t wider = 1;
    while (population_means[wider].pupil_mm < pupil_mm) ++wider;
    const PopulationMean& a = population_means[wider - 1];
    const PopulationMean& b = population_means[wider];
    const double t = (pupil_mm - a.pupil_mm) / (b.pupil_mm - a.pupil_mm);
    Wavefront wavefront{.coefficients_um = std::vector<double>(first_index),
                        .pupil_diameter_m = m_from_mm(pupil_mm),
                        .wavelength_nm = measured_at_nm};
    for (std::size_t i = 0; i < a.coefficients_um.size(); ++i) {
        wavefront.coefficients_um.push_back(
            std::lerp(a.coefficients_um[i], b.coefficients_um[i], t));
    }
    return rescaled(eye == EyeSide::Left ? mirrored(wavefront) : wavefront, pupil_diameter_m);
}

}  // namespace eye_render
