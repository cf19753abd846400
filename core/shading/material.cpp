#include "shading/material.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace eye_render {

namespace {

// Remembers what was asked for.
class RecordingResources final : public NodeResources {
public:
    explicit RecordingResources(NodeResources& inner) : inner_(inner) {}

    [[nodiscard]] int uv_layer(const std::string& name) override
    {
        return *uv_layers.insert(inner_.uv_layer(name)).first;
    }
    [[nodiscard]] int attribute(const std::string& name) override
    {
        return *attributes.insert(inner_.attribute(name)).first;
    }
    void require_texture(int texture) override
    {
        inner_.require_texture(texture);
        textures.insert(texture);
    }
    [[nodiscard]] WorkingSpace working_space() override { return inner_.working_space(); }

    std::set<int> uv_layers;
    std::set<int> attributes;
    std::set<int> textures;

private:
    NodeResources& inner_;
};

// Of a material that names none, and whose colours are grey.
class NoResources final : public NodeResources {
public:
    [[nodiscard]] int uv_layer(const std::string& name) override { refuse("UV layer " + name); }
    [[nodiscard]] int attribute(const std::string& name) override { refuse("attribute " + name); }
    void require_texture(int texture) override { refuse("texture " + std::to_string(texture)); }
    [[nodiscard]] WorkingSpace working_space() override { return WorkingSpace::Rec709; }

private:
    [[noreturn]] static void refuse(const std::string& what)
    {
        throw std::invalid_argument(what + " is read by a material of constants");
    }
};

}  // namespace

const ShaderProgram* Material::aov(int number) const
{
    const auto found = std::ranges::find(aovs, number, &MaterialAov::number);
    return found != aovs.end() ? &found->program : nullptr;
}

Material make_material(std::string name,
                       const NodeGraph& graph,
                       const MaterialOutputs& outputs,
                       NodeResources& resources,
                       const std::vector<AovOutput>& aovs)
{
    RecordingResources read(resources);
    Material material;
    material.matte = matte_id(name);
    material.name = std::move(name);
    if (outputs.volume) {
        material.volume = ShaderProgram(graph, outputs.volume, std::nullopt, read);
    }
    if (outputs.volume && !outputs.surface) {
        material.is_boundary = true;
        NodeGraph boundary;
        const NodeOutput clear{.node = boundary.add("BSDF_TRANSPARENT")};
        material.surface = ShaderProgram(boundary, clear, std::nullopt, read);
    } else {
        material.surface = ShaderProgram(graph, outputs.surface, outputs.displacement, read);
    }
    for (const AovOutput& aov : aovs) {
        material.aovs.push_back(
            {.number = aov.number, .program = ShaderProgram::of_value(graph, aov.output, read)});
    }
    material.uv_layers.assign(read.uv_layers.begin(), read.uv_layers.end());
    material.attributes.assign(read.attributes.begin(), read.attributes.end());
    material.textures.assign(read.textures.begin(), read.textures.end());
    return material;
}

Material plain_material(std::string_view closure,
                        std::initializer_list<std::pair<std::string_view, NodeValue>> inputs,
                        NodeOptions options)
{
    NodeGraph graph;
    const std::size_t node = graph.add(closure, std::move(options));
    for (const auto& [identifier, value] : inputs) {
        graph.set(node, identifier, value);
    }
    NoResources resources;
    return make_material(std::string(closure), graph, {.surface = NodeOutput{.node = node}},
                         resources);
}

}  // namespace eye_render
