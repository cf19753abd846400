#include "scene/scene_data.h"

#include <set>

namespace eye_render {

namespace {

std::vector<int> layers_read(const std::vector<const Material*>& materials,
                             std::vector<int> Material::*layers_of)
{
    std::set<int> layers;
    for (const Material* material : materials) {
        const std::vector<int>& read = material->*layers_of;
        layers.insert(read.begin(), read.end());
    }
    return {layers.begin(), layers.end()};
}

}  // namespace

std::vector<int> uv_layers_read(const std::vector<const Material*>& materials)
{
    return layers_read(materials, &Material::uv_layers);
}

std::vector<int> attributes_read(const std::vector<const Material*>& materials)
{
    return layers_read(materials, &Material::attributes);
}

}  // namespace eye_render
