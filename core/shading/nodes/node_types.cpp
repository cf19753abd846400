// All node kinds. Mix and Add Shader are no nodes of a program: the compiler turns them into
// weights of what they mix.

#include "shading/nodes/node_tables.h"
#include "shading/nodes/sockets.h"

#include <array>
#include <vector>

namespace eye_render {

namespace {

using enum SocketType;

constexpr std::array mix_in{number_input("Fac", 0.5f), InputSocket{"Shader", Shader},
                            InputSocket{"Shader_001", Shader}};
constexpr std::array add_in{InputSocket{"Shader", Shader}, InputSocket{"Shader_001", Shader}};
constexpr std::array shader_out{OutputSocket{"Shader", Shader}};

constexpr NodeType mix_shader{.name = "MIX_SHADER",
                              .inputs = mix_in,
                              .outputs = shader_out,
                              .options = {},
                              .role = NodeRole::MixShader};
constexpr NodeType add_shader{.name = "ADD_SHADER",
                              .inputs = add_in,
                              .outputs = shader_out,
                              .options = {},
                              .role = NodeRole::AddShader};

[[nodiscard]] std::vector<const NodeType*> joined()
{
    std::vector<const NodeType*> all{&mix_shader, &add_shader};
    for (const auto& family :
         {closure_nodes(), procedural_texture_nodes(), image_texture_nodes(), math_nodes(),
          color_nodes(), sky_nodes(), coordinate_nodes(), layer_nodes(), input_nodes(),
          strand_nodes(), normal_nodes(), displacement_nodes(), probe_nodes(), lamp_nodes()}) {
        for (const NodeType& type : family) {
            all.push_back(&type);
        }
    }
    return all;
}

}  // namespace

std::span<const NodeType* const> node_types()
{
    static const std::vector<const NodeType*> all = joined();
    return all;
}

}  // namespace eye_render
