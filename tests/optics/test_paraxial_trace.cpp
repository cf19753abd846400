// Cardinal points, pupils and refractions against the vectors and published tables.

#include "optics/paraxial_trace.h"

#include "../optics_vectors.h"
#include "lens_systems.h"

namespace eye_render {
namespace {

using test::Json;

TEST(ParaxialTrace, has_the_vectors_power_pupil_and_refraction)
{
    for (const Json& vector : test::vectors_of_kind("schematic_eye_paraxial")) {
        EYE_TRACE_VECTOR(vector);
        std::vector<test::Layer> layers;
        for (const Json& s : vector["input"]["surfaces_R_mm_t_mm_n"]) {
            layers.push_back({s[0], 0.0, s[1], s[2]});
        }
        const LensSystem system = test::lens_system(layers);
        const Indices indices = indices_at(system, 555.0);
        const Json& expected = vector["expect"];
        const CardinalPoints points = cardinal_points(system, indices, Meridian::X);
        test::expect_vector_value(points.power_d, expected["power_D"]);
        test::expect_vector_value(points.back_vertex_focal_m * 1e3,
                                  expected["back_vertex_focal_mm"]);
        test::expect_vector_value(-conjugate_vergence_d(system, indices, Meridian::X, 0.0),
                                  expected["refraction_at_cornea_D"]);
        const EntrancePupil pupil = entrance_pupil(system, indices, Meridian::X);
        test::expect_vector_value(pupil.position_m * 1e3, expected["entrance_pupil_mm"]);
        test::expect_vector_value(pupil.magnification, expected["entrance_pupil_magnification"]);
    }
}

TEST(ParaxialTrace, agrees_with_another_program_to_its_last_digit)
{
    // Optiland on the eye of Escudero-Sanz & Navarro 1999 at 543 nm with a stop of 3 mm.
    const LensSystem system = test::lens_system({{7.72, -0.26, 0.55, 1.3777},
                                                 {6.5, 0.0, 3.05, 1.3391},
                                                 {10.2, -3.1316, 4.0, 1.4222},
                                                 {-6.0, -1.0, 16.3203, 1.3377}});
    const Indices indices = indices_at(system, 543.0);
    const double power_d = cardinal_points(system, indices, Meridian::X).power_d;
    const EntrancePupil pupil = entrance_pupil(system, indices, Meridian::X);
    constexpr double printed = 0.6e-6;
    EXPECT_NEAR(1e3 / power_d, 16.467904, printed);
    EXPECT_NEAR(1337.7 / power_d, 22.029115, printed);
    EXPECT_NEAR(pupil.position_m * 1e3, 3.040096, printed);
    EXPECT_NEAR(pupil.magnification * 3.0, 3.400218, printed);
}

TEST(ParaxialTrace, meridians_of_a_biconic_have_their_own_power)
{
    LensSystem toric = test::navarro_589();
    const Indices indices = indices_at(toric, 589.0);
    LensSystem steep = toric;
    toric.surfaces.front().shape.curvature_y_per_m = 1.0 / 7.0e-3;
    steep.surfaces.front().shape = ConicSurface::of_revolution(0.0, 7.0e-3, -0.26);
    EXPECT_EQ(cardinal_points(toric, indices, Meridian::X).power_d,
              cardinal_points(test::navarro_589(), indices, Meridian::X).power_d);
    EXPECT_EQ(cardinal_points(toric, indices, Meridian::Y).power_d,
              cardinal_points(steep, indices, Meridian::X).power_d);
}

TEST(ParaxialTrace, moves_the_conjugate_between_planes_by_their_distance)
{
    LensSystem system = test::navarro_589();
    system.retina.vertex_m += 1e-3;
    const Indices indices = indices_at(system, 589.0);
    const double at_cornea_d = conjugate_vergence_d(system, indices, Meridian::X, 0.0);
    const double at_pupil_d = conjugate_vergence_d(system, indices, Meridian::X, 3.0e-3);
    EXPECT_GT(at_cornea_d, 2.0);
    EXPECT_NEAR(1.0 / at_pupil_d, 1.0 / at_cornea_d + 3.0e-3, 1e-14);
}

}  // namespace
}  // namespace eye_render
