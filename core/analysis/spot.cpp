#include "analysis/spot.h"

#include "base/units.h"

namespace eye_render {

namespace {

// From differences of slopes in the picture to angles.
class Picture {
public:
    explicit Picture(const V2d& chief_slope)
    {
        const double cosine = 1.0 / std::sqrt(1.0 + chief_slope.length2());
        const V2d chief = chief_slope * cosine;
        const double bend = 1.0 / (1.0 + cosine);
        axis_x_ = V2d(1.0 - chief.x * chief.x * bend, -chief.x * chief.y * bend) * cosine;
        axis_y_ = V2d(-chief.x * chief.y * bend, 1.0 - chief.y * chief.y * bend) * cosine;
    }

    [[nodiscard]] V2d angle_rad(const V2d& slope_difference) const
    {
        return {axis_x_.dot(slope_difference), axis_y_.dot(slope_difference)};
    }

private:
    V2d axis_x_;
    V2d axis_y_;
};

// By how much the chief slope changes for the ray to move by `miss` at the object.
V2d chief_change(const TracedRay& ray, double object_vergence_d, const V2d& miss)
{
    const V2d x = ray.change_x.slope_at(object_vergence_d);
    const V2d y = ray.change_y.slope_at(object_vergence_d);
    return V2d(miss.cross(y), x.cross(miss)) / x.cross(y);
}

}  // namespace

Spot make_spot(const PupilTrace& trace, double object_vergence_d)
{
    const Picture picture(trace.chief_slope);
    const V2d object_slope = trace.chief.slope_at(object_vergence_d);
    Spot spot;
    spot.points.reserve(trace.rays.size());
    for (const TracedRay& ray : trace.rays) {
        const V2d miss = object_slope - ray.line.slope_at(object_vergence_d);
        spot.points.push_back(
            {.pupil_point_m = ray.pupil_point_m,
             .angle_rad = picture.angle_rad(chief_change(ray, object_vergence_d, miss)),
             .weight = ray.weight});
        spot.weight += ray.weight;
    }
    spot.transmitted = spot.weight / trace.counts.all();
    return spot;
}

SpotMoments spot_moments(const Spot& spot)
{
    SpotMoments moments;
    if (spot.weight <= 0.0) {
        return moments;
    }
    for (const SpotPoint& point : spot.points) {
        moments.mean_rad += point.angle_rad * (point.weight / spot.weight);
    }
    // A second pass, because a mean far from 0 would swallow a small spot's moments.
    for (const SpotPoint& point : spot.points) {
        const V2d offset = point.angle_rad - moments.mean_rad;
        const double share = point.weight / spot.weight;
        moments.xx += share * offset.x * offset.x;
        moments.xy += share * offset.x * offset.y;
        moments.yy += share * offset.y * offset.y;
    }
    return moments;
}

BlurEllipse spot_ellipse(const SpotMoments& moments)
{
    // Sampling leaves a round spot this much out of round.
    constexpr double round = 1e-3;

    const double mean = 0.5 * (moments.xx + moments.yy);
    const double difference = 0.5 * (moments.xx - moments.yy);
    const double stretch = std::hypot(difference, moments.xy);
    BlurEllipse ellipse;
    // The standard deviation along a diameter of an even ellipse is a quarter of it.
    ellipse.major_arcmin = arcmin_from_rad(4.0 * std::sqrt(mean + stretch));
    ellipse.minor_arcmin = arcmin_from_rad(4.0 * std::sqrt(std::max(0.0, mean - stretch)));
    ellipse.rms_radius_arcmin = arcmin_from_rad(moments.rms_radius_rad());
    if (stretch > round * mean) {
        const double angle_deg = deg_from_rad(0.5 * std::atan2(moments.xy, difference));
        ellipse.angle_deg = std::fmod(angle_deg + 180.0, 180.0);
    }
    return ellipse;
}

}  // namespace eye_render
