// Options of a node, written as a list: options_of({{"operation", "ADD"}, {"use_clamp", 1.0}}).

#pragma once

#include "shading/node_options.h"

namespace eye_render::test {

[[nodiscard]] inline NodeOptions options_of(std::map<std::string, NodeOptions::Value> values)
{
    return NodeOptions(std::move(values));
}

}  // namespace eye_render::test
