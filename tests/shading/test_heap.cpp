// What is evaluated at every hit asks the heap for nothing.

#include "made_up_hit.h"
#include "scattering.h"
#include "shading/program.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<int> allocations = 0;

}  // namespace

void* operator new(std::size_t size)
{
    ++allocations;
    if (void* const memory = std::malloc(size)) {
        return memory;
    }
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace eye_render {
namespace {

using test::GraphTrial;
using test::up;

// While the shader of the program is evaluated at a hit.
int allocations_of(const ShaderProgram& program)
{
    const ShadingPoint seen{.wo = up, .ng = up, .ns = up, .footprint = 0.01f};
    const test::MadeUpHit at;
    const PathState path;
    const int before = allocations;
    static_cast<void>(program.shade({.point = seen, .attributes = at, .path = path}));
    return allocations - before;
}

TEST(Heap, is_not_asked_by_bump_or_displacement)
{
    GraphTrial trial;
    const std::size_t place = trial.add("TEX_COORD");
    const std::size_t bump = trial.add("BUMP");
    trial.link(bump, "Height", place, "Generated");
    const std::size_t diffuse = trial.add("BSDF_DIFFUSE");
    trial.link(diffuse, "Normal", bump, "Normal");
    const std::size_t displacement = trial.add("DISPLACEMENT");
    trial.link(displacement, "Height", place, "Object");
    const ShaderProgram program(trial.graph, trial.graph.output(diffuse, "BSDF"),
                                trial.graph.output(displacement, "Displacement"), trial.resources);
    EXPECT_EQ(allocations_of(program), 0);
}

// A hundred nodes of which most outputs are not wanted, as groups bring them.
TEST(Heap, is_not_asked_by_a_large_group_of_nodes)
{
    GraphTrial trial;
    std::size_t sum = trial.add("TEX_COORD");
    std::string_view output = "Generated";
    for (int i = 0; i < 50; ++i) {
        const std::size_t more = trial.add("LIGHT_PATH");
        const std::size_t next = trial.add("MATH", {{"operation", "ADD"}});
        trial.link(next, "Value", sum, output);
        trial.link(next, "Value_001", more, "Ray Length");
        sum = next;
        output = "Value";
    }
    const std::size_t light = trial.add("EMISSION");
    trial.link(light, "Strength", sum, output);
    EXPECT_EQ(allocations_of(trial.surface(light, "Emission")), 0);
}

}  // namespace
}  // namespace eye_render
