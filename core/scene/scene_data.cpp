#include "scene/scene_data.h"

#include <set>

namespace eye_render {

namespace {

template <typename Visit>
void for_each_input(const Material& m, Visit visit)
{
    for (const MaterialInput* input :
         {&m.base_color, &m.metallic, &m.roughness, &m.specular, &m.ior, &m.transmission, &m.alpha,
          &m.emission_color, &m.emission_strength, &m.normal_map, &m.normal_strength}) {
        visit(*input);
    }
}

}  // namespace

std::vector<int> uv_layers_read(const std::vector<const Material*>& materials)
{
    std::set<int> layers;
    for (const Material* material : materials) {
        for_each_input(*material, [&layers](const MaterialInput& input) {
            if (input.texture != MaterialInput::none) {
                layers.insert(input.uv_layer);
            }
        });
    }
    return {layers.begin(), layers.end()};
}

std::vector<int> color_attributes_read(const std::vector<const Material*>& materials)
{
    std::set<int> layers;
    for (const Material* material : materials) {
        for_each_input(*material, [&layers](const MaterialInput& input) {
            if (input.color_attribute != MaterialInput::none) {
                layers.insert(input.color_attribute);
            }
        });
    }
    return {layers.begin(), layers.end()};
}

}  // namespace eye_render
