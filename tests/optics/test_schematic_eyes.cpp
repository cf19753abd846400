// The published surfaces, relaxed and accommodated.

#include "optics/schematic_eyes.h"

#include "../optics_vectors.h"

namespace eye_render {
namespace {

using test::Json;

// Radii and distances as in the vector of that name.
void expect_surfaces(const LensSystem& system, const std::string& name)
{
    SCOPED_TRACE(name);
    bool found = false;
    for (const Json& vector : test::vectors_of_kind("schematic_eye_paraxial")) {
        if (vector["input"]["eye"] != name) continue;
        found = true;
        const Json& layers = vector["input"]["surfaces_R_mm_t_mm_n"];
        ASSERT_EQ(system.surfaces.size(), layers.size());
        double vertex_mm = 0.0;
        for (std::size_t i = 0; i < layers.size(); ++i) {
            const ConicSurface& shape = system.surfaces[i].shape;
            test::expect_vector_value(shape.vertex_m * 1e3, vertex_mm);
            test::expect_vector_value(1e-3 / layers[i][0].get<double>(),
                                      shape.curvature_x_per_m * 1e-6);
            vertex_mm += layers[i][1].get<double>();
        }
        test::expect_vector_value(system.retina.vertex_m * 1e3, vertex_mm);
    }
    EXPECT_TRUE(found);
}

TEST(SchematicEyes, le_grands_two_published_states_are_as_published)
{
    expect_surfaces(schematic_eye(SchematicEyeKind::LeGrand, 0.0), "le_grand_full_relaxed");
    const LensSystem accommodated = schematic_eye(SchematicEyeKind::LeGrand, 7.0525);
    expect_surfaces(accommodated, "le_grand_full_accommodated");
    EXPECT_NEAR(refractive_index(accommodated.surfaces[2].behind, 589.3), 1.427, 1e-4);
}

TEST(SchematicEyes, the_arizona_eye_at_4_dioptres_is_as_published)
{
    const LensSystem system = schematic_eye(SchematicEyeKind::Arizona, 4.0);
    expect_surfaces(system, "arizona_A4");
    EXPECT_NEAR(system.surfaces[2].shape.conic_x, -2.375869, 1e-12);
    EXPECT_NEAR(system.surfaces[3].shape.conic_x, -3.081019, 1e-12);
    EXPECT_NEAR(refractive_index(system.surfaces[2].behind, 587.5618), 1.42672, 1e-12);
}

TEST(SchematicEyes, navarros_lens_at_e_minus_1_dioptres_has_its_coefficients)
{
    // Where the logarithm of nominal accommodation + 1 is 1.
    const double nominal_d = std::exp(1.0) - 1.0;
    const LensSystem system = schematic_eye(SchematicEyeKind::Navarro, nominal_d);
    const auto radius_mm = [&](std::size_t i) {
        return 1e3 / system.surfaces[i].shape.curvature_x_per_m;
    };
    EXPECT_NEAR(radius_mm(2), 8.45, 1e-12);
    EXPECT_NEAR(radius_mm(3), -5.7706, 1e-12);
    EXPECT_NEAR(system.surfaces[2].shape.conic_x, -3.4716, 1e-12);
    EXPECT_NEAR(system.surfaces[3].shape.conic_x, -1.125, 1e-12);
    EXPECT_NEAR(system.stop_m, 3.55e-3, 1e-15);
    EXPECT_NEAR(system.surfaces[3].shape.vertex_m, 7.65e-3, 1e-15);
}

TEST(SchematicEyes, lens_surfaces_do_not_meet_within_a_9_mm_pupil_at_any_accommodation)
{
    constexpr double stop_radius_m = 4e-3;
    for (const SchematicEyeKind kind :
         {SchematicEyeKind::Navarro, SchematicEyeKind::Arizona, SchematicEyeKind::LeGrand}) {
        for (const double share : {0.0, 0.5, 1.0}) {
            const LensSystem system =
                schematic_eye(kind, share * max_nominal_accommodation_d(kind));
            const ConicSurface& front = system.surfaces[2].shape;
            const ConicSurface& back = system.surfaces[3].shape;
            const auto front_m = front.sag_m(stop_radius_m, 0.0);
            const auto back_m = back.sag_m(stop_radius_m, 0.0);
            ASSERT_TRUE(front_m && back_m) << int(kind) << ' ' << share;
            EXPECT_LT(front.vertex_m + *front_m, back.vertex_m + *back_m)
                << int(kind) << ' ' << share;
        }
    }
}

}  // namespace
}  // namespace eye_render
