// Exact rays against the vectors, and there and back again.

#include "optics/lens_system.h"

#include "../optics_vectors.h"
#include "lens_systems.h"

#include <cmath>

namespace eye_render {
namespace {

using test::Json;

TEST(LensSystem, traces_rays_to_the_retina_as_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("schematic_eye_real_ray")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        std::vector<test::Layer> layers;
        for (const Json& s : input["surfaces_R_Q_t_n"]) layers.push_back({s[0], s[1], s[2], s[3]});
        const LensSystem system = test::lens_system(layers, input["retina_R_Q"][0]);
        const V3d origin_mm(input["origin_mm"][0], input["origin_mm"][1], input["origin_mm"][2]);
        const V3d direction(input["direction"][0], input["direction"][1], input["direction"][2]);
        const TraceResult traced = traced_to_retina(system, indices_at(system, 555.0),
                                                    {origin_mm * 1e-3, direction.normalized()});
        ASSERT_EQ(traced.fate, TraceFate::Passed);
        const V3d point_mm = traced.ray.origin_m * 1e3;
        const Json& expected = vector["expect"]["retina_point_mm"];
        test::expect_vector_value(point_mm.x, expected[0]);
        test::expect_vector_value(point_mm.y, expected[1]);
        test::expect_vector_value(point_mm.z, expected[2]);
    }
}

TEST(LensSystem, a_ray_from_the_retina_goes_back_the_way_it_came)
{
    const LensSystem system = test::navarro_589();
    const Indices indices = indices_at(system, 589.0);
    const std::size_t count = system.surfaces.size();
    for (const double x_mm : {-4.0, -1.0, 0.0, 2.5}) {
        for (const double slope : {-0.4, 0.0, 0.2}) {
            const OpticalRay into{{x_mm * 1e-3 - slope * 5e-3, 0.7e-3, -5e-3},
                                  V3d(slope, 0.1, 1.0).normalized()};
            const TraceResult landed = traced_to_retina(system, indices, into);
            ASSERT_EQ(landed.fate, TraceFate::Passed) << into.origin_m;
            const TraceResult back = traced_outward(
                system, indices, {landed.ray.origin_m, -landed.ray.direction}, 0, count);
            ASSERT_EQ(back.fate, TraceFate::Passed);
            EXPECT_NEAR((back.ray.direction + into.direction).length(), 0.0, 1e-13);
            EXPECT_NEAR((at_plane(back.ray, into.origin_m.z).origin_m - into.origin_m).length(),
                        0.0, 1e-15);
        }
    }
}

TEST(LensSystem, says_what_became_of_a_ray)
{
    LensSystem system = test::le_grand_589();
    const Indices indices = indices_at(system, 589.0);
    const auto fate_at = [&](double x_mm) {
        return traced_to_retina(system, indices, {{x_mm * 1e-3, 0.0, -1e-3}, {0.0, 0.0, 1.0}})
            .fate;
    };
    EXPECT_EQ(fate_at(1.0), TraceFate::Passed);
    EXPECT_EQ(fate_at(7.9), TraceFate::Missed);
    system.surfaces.front().semi_aperture_m = 0.5e-3;
    EXPECT_EQ(fate_at(1.0), TraceFate::Vignetted);
    // From within the lens a ray can be caught by its back.
    const OpticalRay steep{{4e-3, 0.0, 6e-3}, V3d(-1.0, 0.0, 0.8).normalized()};
    EXPECT_EQ(traced_inward(system, indices, steep, 3, 4).fate, TraceFate::TotalReflection);
}

TEST(LensSystem, light_does_not_run_backwards_to_surfaces_that_cross)
{
    // A lens as thin as this has an edge at 1.9 mm, where its surfaces cross.
    LensSystem system = test::lens_system({{10.0, 0.0, 0.36, 1.42}, {-10.0, 0.0, 16.0, 1.336}});
    const Indices indices = indices_at(system, 589.0);
    const auto fate_at = [&](double x_mm) {
        return traced_to_retina(system, indices, {{x_mm * 1e-3, 0.0, -1e-3}, {0.0, 0.0, 1.0}})
            .fate;
    };
    EXPECT_EQ(fate_at(1.7), TraceFate::Passed);
    EXPECT_EQ(fate_at(2.1), TraceFate::Missed);
}

}  // namespace
}  // namespace eye_render
