// Programs of made-up graphs, and what shines of them where they are hit.

#pragma once

#include "made_up_hit.h"
#include "scattering.h"

namespace eye_render::test {

inline const ShadingPoint point{.wo = direction_at(30.0), .ng = up, .ns = up};
inline const PathState path;

inline Color3f emission(const ShaderProgram& program, const MadeUpHit& hit = {})
{
    return program.shade({.point = point, .attributes = hit, .path = path}).emission;
}

// A shining node of this strength.
inline std::size_t add_emission(GraphTrial& trial, float strength)
{
    const std::size_t node = trial.add("EMISSION");
    trial.graph.set(node, "Color", V3f(1.0f));
    trial.graph.set(node, "Strength", V3f(strength));
    return node;
}

inline std::size_t add_mix(GraphTrial& trial, float factor, std::size_t first, std::size_t second)
{
    const std::size_t mix = trial.add("MIX_SHADER");
    trial.graph.set(mix, "Fac", V3f(factor));
    const auto link = [&](const char* input, std::size_t node) {
        trial.graph.link(mix, input, {.node = node});
    };
    link("Shader", first);
    link("Shader_001", second);
    return mix;
}

}  // namespace eye_render::test
