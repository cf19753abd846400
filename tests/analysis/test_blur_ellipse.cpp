// The closed forms of blur against the vectors.

#include "analysis/blur_ellipse.h"

#include "../optics_vectors.h"

#include "base/units.h"
#include "eye/eye_factory.h"

namespace eye_render {
namespace {

using test::Json;

double vergence_of(const Json& object_m)
{
    return object_m.is_null() ? 0.0 : 1.0 / object_m.get<double>();
}

PowerMatrix error_of(const EyeSpec& spec, double object_vergence_d)
{
    return make_eye(spec)->retinal_conjugate_d() - PowerMatrix::sphere(object_vergence_d);
}

void expect_blur(const PowerMatrix& error_d, double pupil_diameter_m, const Json& expected)
{
    test::expect_vector_value(error_d.xx_d, expected["E_camera"][0][0]);
    test::expect_vector_value(error_d.xy_d, expected["E_camera"][0][1]);
    test::expect_vector_value(error_d.yy_d, expected["E_camera"][1][1]);
    const BlurEllipse blur = blur_ellipse(error_d, pupil_diameter_m);
    test::expect_vector_value(blur.major_arcmin, expected["major_arcmin"]);
    test::expect_vector_value(blur.minor_arcmin, expected["minor_arcmin"]);
    test::expect_vector_value(blur.rms_radius_arcmin, expected["rms_radius_arcmin"]);
    const Json& angle_deg = expected["major_angle_deg"];
    ASSERT_EQ(blur.angle_deg.has_value(), !angle_deg.is_null());
    if (blur.angle_deg) {
        test::expect_same_axis(*blur.angle_deg, angle_deg);
        EXPECT_GE(*blur.angle_deg, 0.0);
        EXPECT_LT(*blur.angle_deg, 180.0);
    }
}

Prescription rx_of(const Json& input)
{
    return {.sphere_d = input["S"], .cylinder_d = input["C"], .axis_deg = input["axis"]};
}

TEST(BlurEllipse, is_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("blur_ellipse")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        const EyeSpec spec{.rx = rx_of(input),
                           .rx_plane = RxPlane::EntrancePupil,
                           .accommodation_d = input["accommodation_D"]};
        expect_blur(error_of(spec, vergence_of(input["object_m"])), m_from_mm(input["pupil_mm"]),
                    vector["expect"]);
    }
}

TEST(BlurEllipse, of_an_uncorrected_eye_starts_from_its_spectacle_prescription)
{
    for (const Json& vector : test::vectors_of_kind("blur_ellipse_spectacle_rx")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        ASSERT_DOUBLE_EQ(input["cornea_to_entrance_pupil_mm"].get<double>(),
                         mm_from_m(cornea_to_entrance_pupil_m));
        const EyeSpec spec{.rx = rx_of(input),
                           .rx_plane = RxPlane::Spectacle,
                           .vertex_m = m_from_mm(input["vertex_to_cornea_mm"]),
                           .accommodation_d = input["accommodation_D"]};
        expect_blur(error_of(spec, vergence_of(input["object_m_from_entrance_pupil"])),
                    m_from_mm(input["pupil_mm"]), vector["expect"]);
    }
}

TEST(LineSpread, lines_are_as_clear_as_the_vectors)
{
    constexpr double pupil_diameter_m = 4e-3;
    for (const Json& vector : test::vectors_of_kind("clear_lines_4mm")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        const PowerMatrix error_d = error_of({.rx = rx_of(input),
                                              .rx_plane = RxPlane::EntrancePupil,
                                              .accommodation_d = input["accommodation_D"]},
                                             vergence_of(input["object_m"]));
        test::expect_vector_value(line_spread_rms_arcmin(error_d, pupil_diameter_m, 0.0),
                                  vector["expect"]["horizontal_line_rms_arcmin"]);
        test::expect_vector_value(line_spread_rms_arcmin(error_d, pupil_diameter_m, 90.0),
                                  vector["expect"]["vertical_line_rms_arcmin"]);
    }
}

}  // namespace
}  // namespace eye_render
