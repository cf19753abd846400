// The geometrical point spread function: a point's picture, without diffraction.

#pragma once

#include "analysis/spot.h"

namespace eye_render {

struct PsfGrid {
    double size_rad = 0.0;  // side of the square, whose centre is the chief ray
    int resolution = 128;   // pixels along a side
};

// Row by row from the bottom up, each the share of the transmitted light that falls into it: they
// sum to 1, or to less when the square does not hold the whole blur. A ray's light is spread over
// the area of one pixel around it, which keeps the centroid. All 0 when nothing is transmitted.
[[nodiscard]] std::vector<double> point_spread(const Spot& spot, const PsfGrid& grid);

}  // namespace eye_render
