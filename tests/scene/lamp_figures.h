// The irradiance that Cycles gives a plane under one lamp, measured.

#pragma once

#include "base/units.h"
#include "scene/lamp.h"

#include <cmath>
#include <string>
#include <vector>

namespace eye_render {

[[nodiscard]] inline float rad(double angle_deg) { return float(rad_from_deg(angle_deg)); }

// Blender 3.4.1: a white diffuse plane at the origin, facing +Z, under one lamp of 100 W (sun:
// 3 W/m^2) that shines straight down from (x, 0, 2); 16 x 16 pixels of an orthographic camera over
// 2 mm of it, 256 samples, no bounces, 32-bit EXR; irradiance = pi times the pixels' mean. The
// noise is below 0.01 %, but 0.1 % at the steep edges of spots. Area lamps have their 100 W since
// Blender 4.0 (4.3.2 and 5.2 measured); 3.4.1 takes pi / 4 of it and was given 127.324 W.
struct CyclesFigure {
    std::string name;
    LampSettings settings;
    float x;
    double irradiance;
};

[[nodiscard]] inline std::vector<CyclesFigure> cycles_figures()
{
    using enum LampKind;
    const LampSettings point{.kind = Point, .color = Color3f(100.0f)};
    const LampSettings sun{.kind = Sun, .color = Color3f(3.0f)};
    const LampSettings area{
        .kind = Area, .color = Color3f(100.0f), .size_x = 0.5f, .size_y = 0.25f};
    const auto point_of = [=](float radius) {
        LampSettings s = point;
        s.radius = radius;
        return s;
    };
    const auto sun_of = [=](double angle_deg) {
        LampSettings s = sun;
        s.angle_rad = rad(angle_deg);
        return s;
    };
    const auto area_of = [=](LampShape shape, float size_x, float size_y, double spread_deg) {
        LampSettings s = area;
        s.shape = shape;
        s.size_x = size_x;
        s.size_y = size_y;
        s.spread_rad = rad(spread_deg);
        return s;
    };
    const auto spot_of = [=](double angle_deg, float blend, float radius) {
        LampSettings s = point;
        s.kind = Spot;
        s.radius = radius;
        s.spot_angle_rad = rad(angle_deg);
        s.spot_blend = blend;
        s.spot_cosine_falloff = true;
        return s;
    };
    using enum LampShape;
    std::vector<CyclesFigure> figures = {
        {"point, radius 0", point_of(0.0f), 0, 1.989433},
        {"point, radius 0.02", point_of(0.02f), 0, 1.989237},
        {"point, radius 0.1", point_of(0.1f), 0, 1.984476},
        {"point, radius 0.5", point_of(0.5f), 0, 1.872414},
        {"sun, 0 degrees", sun_of(0.0), 0, 2.999997},
        {"sun, 10 degrees", sun_of(10.0), 0, 2.994277},
        {"rectangle 0.5 x 0.25", area_of(Rectangle, 0.5f, 0.25f, 180), 0, 7.855565},
        {"rectangle 2 x 1", area_of(Rectangle, 2.0f, 1.0f, 180), 0, 6.618628},
        {"disk 0.5", area_of(Disk, 0.5f, 0.5f, 180), 0, 7.835318},
        {"disk 2", area_of(Disk, 2.0f, 2.0f, 180), 0, 6.366260},
        {"ellipse 0.5 x 0.25", area_of(Disk, 0.5f, 0.25f, 180), 0, 7.880929},
        {"spread 150", area_of(Rectangle, 0.02f, 0.02f, 150), 0, 12.222329},
        {"spread 90", area_of(Rectangle, 0.02f, 0.02f, 90), 0, 36.873703},
        {"spread 30", area_of(Rectangle, 0.02f, 0.02f, 30), 0, 341.163834},
        {"spread 5", area_of(Rectangle, 0.02f, 0.02f, 5), 0, 11436.478852},
        {"spread 30, x 0.2", area_of(Rectangle, 0.02f, 0.02f, 30), 0.2f, 212.593802},
        {"spread 30, x 0.4", area_of(Rectangle, 0.02f, 0.02f, 30), 0.4f, 81.110598},
        {"spread 30, x 0.5", area_of(Rectangle, 0.02f, 0.02f, 30), 0.5f, 20.513343},
        {"spread 30, x 0.6", area_of(Rectangle, 0.02f, 0.02f, 30), 0.6f, 0.0},
        {"1 x 1, spread 90", area_of(Rectangle, 1.0f, 1.0f, 90), 0, 27.809987},
        {"1 x 1, spread 90, x 0.5", area_of(Rectangle, 1.0f, 1.0f, 90), 0.5f, 22.205689},
        {"1 x 1, spread 90, x 1", area_of(Rectangle, 1.0f, 1.0f, 90), 1.0f, 11.742294},
        {"1 x 1, spread 90, x 1.5", area_of(Rectangle, 1.0f, 1.0f, 90), 1.5f, 4.166603},
    };
    // Spots, by the angle from their axis under which they are seen.
    struct SpotFigure {
        double cone_deg;
        float blend;
        float radius;
        double angle_deg;
        double irradiance;
    };
    const SpotFigure spots[] = {
        {50, 0.3f, 0.0f, 0, 1.989433},    {50, 0.3f, 0.0f, 10, 1.871267},
        {50, 0.3f, 0.0f, 20, 1.551220},   {50, 0.3f, 0.0f, 22, 1.228346},
        {50, 0.3f, 0.0f, 24, 0.228336},   {50, 0.3f, 0.0f, 26, 0.0},
        {50, 1.0f, 0.0f, 10, 1.739618},   {50, 1.0f, 0.0f, 20, 0.450504},
        {50, 1.0f, 0.0f, 24, 0.023534},   {50, 0.0f, 0.0f, 24, 1.385641},
        {160, 0.15f, 0.0f, 30, 1.119058}, {160, 0.15f, 0.0f, 60, 0.124340},
        {160, 0.15f, 0.0f, 75, 0.006854}, {50, 0.3f, 0.2f, 0, 1.964863},
        {50, 0.3f, 0.2f, 16, 1.679022},   {50, 0.3f, 0.2f, 20, 1.265132},
        {50, 0.3f, 0.2f, 24, 0.516401},   {50, 0.3f, 0.2f, 26, 0.202138},
    };
    for (const SpotFigure& s : spots) {
        figures.push_back({"spot " + std::to_string(s.cone_deg) + ", blend " +
                               std::to_string(s.blend) + ", radius " + std::to_string(s.radius) +
                               ", at " + std::to_string(s.angle_deg) + " degrees",
                           spot_of(s.cone_deg, s.blend, s.radius),
                           2.0f * std::tan(rad(s.angle_deg)), s.irradiance});
    }
    return figures;
}

}  // namespace eye_render
