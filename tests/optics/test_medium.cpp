// Dispersion against the published tables.

#include "optics/medium.h"

#include <gtest/gtest.h>

#include <array>

namespace eye_render {
namespace {

TEST(Medium, herzberger_gives_navarros_table)
{
    // Escudero-Sanz & Navarro 1999, table 2: cornea, aqueous, lens, vitreous, rounded there.
    const std::array<HerzbergerDispersion, 4> media{{{1.3975, 1.3807, 1.37405, 1.3668},
                                                     {1.3593, 1.3422, 1.3354, 1.3278},
                                                     {1.4492, 1.42625, 1.4175, 1.4097},
                                                     {1.3565, 1.3407, 1.3341, 1.3273}}};
    struct Row {
        double wavelength_nm;
        std::array<double, 4> indices;
    };
    const std::array<Row, 4> table{{{458.0, {1.3828, 1.3445, 1.4292, 1.3428}},
                                    {543.0, {1.3777, 1.3391, 1.4222, 1.3377}},
                                    {589.3, {1.3760, 1.3374, 1.4200, 1.3360}},
                                    {632.8, {1.3747, 1.3360, 1.4183, 1.3347}}}};
    for (const Row& row : table) {
        for (std::size_t i = 0; i < media.size(); ++i) {
            EXPECT_NEAR(refractive_index(media[i], row.wavelength_nm), row.indices[i], 2e-4)
                << row.wavelength_nm << " nm, medium " << i;
        }
    }
}

TEST(Medium, herzbergers_weights_add_up_to_one)
{
    // A medium without dispersion keeps its index at every wavelength.
    for (const double wavelength_nm : {380.0, 500.0, 780.0}) {
        EXPECT_NEAR(refractive_index(HerzbergerDispersion{1.4, 1.4, 1.4, 1.4}, wavelength_nm), 1.4,
                    1e-7);
    }
}

TEST(Medium, cornu_gives_le_grands_indices_at_the_sodium_line)
{
    EXPECT_NEAR(refractive_index(CornuDispersion{1.3610, 7.4147}, 589.3), 1.3771, 1e-4);
    EXPECT_NEAR(refractive_index(CornuDispersion{1.3221, 7.0096}, 589.3), 1.3374, 1e-4);
    EXPECT_NEAR(refractive_index(CornuDispersion{1.3999, 9.2492}, 589.3), 1.4200, 1e-4);
    EXPECT_NEAR(refractive_index(CornuDispersion{1.3208, 6.9806}, 589.3), 1.3360, 1e-4);
}

TEST(Medium, cauchy_has_the_index_and_abbe_number_that_were_asked_for)
{
    const Medium cornea = cauchy_from_abbe(1.377, 57.1);
    EXPECT_NEAR(refractive_index(cornea, 587.5618), 1.377, 1e-12);
    EXPECT_NEAR(0.377 / (refractive_index(cornea, 486.1327) - refractive_index(cornea, 656.2725)),
                57.1, 1e-9);
}

}  // namespace
}  // namespace eye_render
