// Where the sun stands in a sky texture: so small and bright that it has to be aimed at.

#pragma once

#include "base/working_space.h"
#include "shading/node_graph.h"

#include <optional>

namespace eye_render {

struct SunDisc {
    V3f direction{0.0f, 0.0f, 1.0f};  // unit, towards the middle, in what the node's Vector means
    float radius_rad = 0.0f;          // seen from the middle to the rim
    Color3f radiance{0.0f};           // of the middle; the rim has 0.4 of it
};

// Of the node TEX_SKY with these options. Nothing if its sky has no disc, or if the disc is below
// the horizon. Throws std::invalid_argument as the node does.
[[nodiscard]] std::optional<SunDisc> sun_disc(const NodeOptions& options, WorkingSpace space);

// Of the first such node that the output depends on and that is laid out as the world is; a sun
// that is turned by other nodes is found by sampling alone.
[[nodiscard]] std::optional<SunDisc> sun_shown(const NodeGraph& graph,
                                               const NodeOutput& output,
                                               WorkingSpace space);

}  // namespace eye_render
