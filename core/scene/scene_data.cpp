#include "scene/scene_data.h"

#include <set>

namespace eye_render {

std::array<const MaterialInput*, 11> inputs_of(const Material& m)
{
    return {&m.base_color,     &m.metallic, &m.roughness,      &m.specular,          &m.ior,
            &m.transmission,   &m.alpha,    &m.emission_color, &m.emission_strength, &m.normal_map,
            &m.normal_strength};
}

std::vector<int> uv_layers_read(const std::vector<const Material*>& materials)
{
    std::set<int> layers;
    for (const Material* material : materials) {
        for (const MaterialInput* input : inputs_of(*material)) {
            if (input->texture != MaterialInput::none) {
                layers.insert(input->uv_layer);
            }
        }
    }
    return {layers.begin(), layers.end()};
}

std::vector<int> color_attributes_read(const std::vector<const Material*>& materials)
{
    std::set<int> layers;
    for (const Material* material : materials) {
        for (const MaterialInput* input : inputs_of(*material)) {
            if (input->color_attribute != MaterialInput::none) {
                layers.insert(input->color_attribute);
            }
        }
    }
    return {layers.begin(), layers.end()};
}

}  // namespace eye_render
