// A schematic eye against a commercial lens-design program's print of its contrast.

#include "analysis/retinal_spot.h"

#include "optics/schematic_eyes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace eye_render {
namespace {

constexpr std::array frequencies_per_m{10e3, 20e3, 30e3, 50e3, 100e3};

TEST(RetinalSpot, of_navarros_eye_has_the_contrast_that_a_lens_design_program_prints)
{
    // Escudero-Sanz & Navarro 1999, stop 4 mm, object at infinity, vitreous 16.32 mm; the
    // geometric transfer function in ISET3d's validation data, at 10 to 100 cycles/mm.
    struct Row {
        double wavelength_nm;
        std::array<double, 5> mtf;
    };
    constexpr std::array<Row, 2> table{{{550.0, {0.8695, 0.5949, 0.3920, 0.3265, 0.2209}},
                                        {650.0, {0.9801, 0.9218, 0.8310, 0.5860, 0.0549}}}};
    LensSystem system = schematic_eye(SchematicEyeKind::Navarro, 0.0);
    system.retina.vertex_m = system.surfaces.back().shape.vertex_m + 16.32e-3;
    for (const Row& row : table) {
        const auto spot_m = retinal_spot_m(system, 4e-3, row.wavelength_nm);
        const auto mtf = retinal_mtf(spot_m, frequencies_per_m);
        for (std::size_t i = 0; i < mtf.size(); ++i) {
            EXPECT_NEAR(mtf[i], row.mtf[i], 0.003)
                << row.wavelength_nm << " nm, " << frequencies_per_m[i] << " cycles/m";
        }
    }
}

TEST(RetinalMtf, of_two_points_is_a_cosine)
{
    constexpr std::array<V2d, 2> spot_m{V2d(-1e-6, 0.0), V2d(1e-6, 5e-6)};
    const auto mtf = retinal_mtf(spot_m, frequencies_per_m);
    for (std::size_t i = 0; i < mtf.size(); ++i) {
        EXPECT_NEAR(mtf[i],
                    std::abs(std::cos(2.0 * std::acos(-1.0) * frequencies_per_m[i] * 1e-6)),
                    1e-14);
    }
    EXPECT_EQ(retinal_mtf({}, frequencies_per_m), std::vector<double>(5, 0.0));
}

}  // namespace
}  // namespace eye_render
