// The data that Hosek and Wilkie fitted to simulated skies, as of their release 1.4a (2013), in
// CIE XYZ.
//
// Copyright (c) 2012-2013, Lukas Hosek and Alexander Wilkie. All rights reserved.
// SPDX-License-Identifier: BSD-3-Clause (the text is in LICENSE.hosek_wilkie)

#pragma once

#include <array>
#include <cstddef>

namespace eye_render {

// For albedos of the ground of 0 and 1, ten turbidities from 1 on, and six control points of a
// Bezier curve over the sun's elevation: all of one before the next.
struct HosekWilkieData {
    static constexpr std::size_t turbidities = 10;
    static constexpr std::size_t control_points = 6;
    static constexpr std::size_t shape_parameters = 9;

    std::array<float, 2 * turbidities * control_points * shape_parameters> shape;
    std::array<float, 2 * turbidities * control_points> radiance;  // the mean of the dome
};

extern const HosekWilkieData hosek_wilkie_x;
extern const HosekWilkieData hosek_wilkie_y;
extern const HosekWilkieData hosek_wilkie_z;

}  // namespace eye_render
