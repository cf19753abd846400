// The scene's float rays against the eye's doubles, at all distances and in all units: what the
// rounding of origin and direction moves in the picture.

#include "trial.h"

#include "base/units.h"
#include "render/camera.h"

#include <cmath>

namespace eye_render::test {
namespace {

// Half the distance between floats next to 1: the rounding of each coordinate, relative.
constexpr double float_rounding = 0x1p-24;

// A camera that is turned anyhow.
CameraFrame turned_frame(Random& random)
{
    CameraFrame frame;
    const V3d towards =
        V3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0))
            .normalized();
    const V3d beside = V3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 2.0);
    frame.axis_z = towards;
    frame.axis_x = beside.cross(towards).normalized();
    frame.axis_y = frame.axis_z.cross(frame.axis_x);
    frame.clip_near = 1e-3;
    frame.clip_far = 1e8;
    return frame;
}

// Back from the world to the eye.
V3d to_eye(const CameraFrame& frame, const V3d& v_world)
{
    return {v_world.dot(frame.axis_x), v_world.dot(frame.axis_y), v_world.dot(frame.axis_z)};
}

// Where a ray is that leaves from `origin_m`, at this distance before the eye.
V2d across_m(const V3d& origin_m, const V3d& direction, double distance_m)
{
    const double t = (distance_m + origin_m.z) / -direction.z;
    return {origin_m.x + t * direction.x, origin_m.y + t * direction.y};
}

class FloatRays : public testing::TestWithParam<EyeModelKind> {};

// With L the length of the ray per depth, rounding tilts the direction by at most one float
// rounding, which moves the point at a distance z by L^2 z of it, and shifts the origin o by one
// of |o|, seen under L |o| / z. That is 0.0006' for 45 degrees off the axis in both directions.
TEST_P(FloatRays, are_the_eyes_rays_within_one_rounding_at_all_distances)
{
    Random random(21);
    double worst_arcmin = 0.0;
    double worst_share = 0.0;
    int compared = 0;
    for (int i = 0; i < (is_schematic(GetParam()) ? 500 : 5000); ++i) {
        const Trial trial = random.trial(GetParam());
        const auto eye = made(trial);
        if (!eye) continue;
        CameraFrame frame = turned_frame(random);
        frame.metres_per_unit = std::pow(10.0, random.uniform(-3.0, 3.0));
        const EyeRay exact = ray_of(*eye, trial);
        const CameraRay camera =
            camera_ray(frame, *eye, chief_slope(trial), pupil_point_m(trial), trial.wavelength_nm);
        ASSERT_EQ(camera.fate, exact.fate) << trial;
        if (exact.fate != RayFate::Transmitted) continue;
        const V3d origin_m = to_eye(frame, V3d(camera.ray.origin)) * frame.metres_per_unit;
        const V3d direction = to_eye(frame, V3d(camera.ray.direction));
        const V3d exact_direction(exact.slope.x, exact.slope.y, -1.0);
        const double length = exact_direction.length();
        for (const double distance_m : {0.01, 0.03, 0.4, 6.0, 1e3, 1e7}) {
            if (distance_m < -exact.origin_eye_m.z) continue;  // between the glasses and the eye
            const double apart = (across_m(origin_m, direction, distance_m) -
                                  across_m(exact.origin_eye_m, exact_direction, distance_m))
                                     .length() /
                                 distance_m;
            const double bound =
                float_rounding * length *
                (length + 2.0 * length * exact.origin_eye_m.length() / distance_m);
            EXPECT_LE(apart, 1.001 * bound + 1e-15 * length * length)
                << distance_m << " m, " << frame.metres_per_unit << " m/unit, " << trial;
            if (chief_slope(trial).length() <= 1.0 && !trial.glasses) {
                worst_arcmin = std::max(worst_arcmin, arcmin_from_rad(apart));
            }
            worst_share = std::max(worst_share, apart / bound);
            ++compared;
        }
    }
    EXPECT_GT(compared, 500);
    EXPECT_GT(worst_share, 0.1) << "the bound says nothing";
    RecordProperty("compared", compared);
    RecordProperty("worst_arcmin_within_45_deg", std::to_string(worst_arcmin));
    RecordProperty("worst_share_of_bound", std::to_string(worst_share));
}

TEST_P(FloatRays, do_not_know_where_in_the_world_the_eye_is_and_in_which_units)
{
    Random random(22);
    for (int i = 0; i < (is_schematic(GetParam()) ? 100 : 1000); ++i) {
        const Trial trial = random.trial(GetParam());
        const auto eye = made(trial);
        if (!eye) continue;
        CameraFrame frame = turned_frame(random);
        const auto ray = [&] {
            return camera_ray(frame, *eye, chief_slope(trial), pupil_point_m(trial),
                              trial.wavelength_nm)
                .ray;
        };
        const Ray at_origin = ray();
        frame.position_world = {1e6, -1e6, 1e6};
        EXPECT_EQ(ray().origin, at_origin.origin) << trial;
        EXPECT_EQ(ray().direction, at_origin.direction) << trial;
        for (const double metres_per_unit : {1e-3, 0.0254, 1e3}) {
            frame.metres_per_unit = metres_per_unit;
            const Ray rescaled = ray();
            EXPECT_EQ(rescaled.direction, at_origin.direction) << trial;
            const V3d moved_m = V3d(rescaled.origin) * metres_per_unit - V3d(at_origin.origin);
            EXPECT_LE(moved_m.length(), 2.001 * float_rounding * V3d(at_origin.origin).length())
                << metres_per_unit << " m/unit, " << trial;
        }
    }
}

TEST(FloatRay, keeps_the_clipping_distances_from_a_micrometre_to_1e30_units)
{
    Random random(23);
    for (int i = 0; i < 1000; ++i) {
        const Trial trial = random.trial(EyeModelKind::Paraxial);
        const auto eye = made(trial);
        if (!eye) continue;
        CameraFrame frame = turned_frame(random);
        frame.clip_near = std::pow(10.0, random.uniform(-6.0, 4.0));
        frame.clip_far = std::pow(10.0, random.uniform(5.0, 30.0));
        const CameraRay camera = camera_ray(frame, *eye, chief_slope(trial), pupil_point_m(trial));
        ASSERT_TRUE(std::isfinite(camera.ray.t_max)) << trial;
        EXPECT_GE(camera.ray.t_min, 0.0f) << trial;
        EXPECT_NEAR(camera.depth(camera.ray.t_max) / frame.clip_far, 1.0, 2.0 * float_rounding)
            << trial;
        const double near = std::max(frame.clip_near, camera.origin_depth);
        EXPECT_NEAR(camera.depth(camera.ray.t_min) / near, 1.0, 2.0 * float_rounding) << trial;
    }
}

INSTANTIATE_TEST_SUITE_P(OfEveryEye,
                         FloatRays,
                         testing::ValuesIn(eye_model_kinds),
                         [](const auto& eye) { return std::string(to_string(eye.param)); });

}  // namespace
}  // namespace eye_render::test
