// The layers, attributes and textures that materials name, as a scene has them.

#pragma once

#include "scene/scene_data.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace eye_render {

inline void require_index(const std::string& what, std::size_t index, std::size_t count)
{
    if (index >= count) {
        throw std::invalid_argument(what + " " + std::to_string(index) +
                                    " does not exist; there " +
                                    (count == 1 ? "is 1" : "are " + std::to_string(count)));
    }
}

[[nodiscard]] inline int intern(std::vector<std::string>& names, const std::string& name)
{
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) {
        return static_cast<int>(found - names.begin());
    }
    names.push_back(name);
    return static_cast<int>(names.size() - 1);
}

// Gives the layers of a scene their numbers, as materials name them.
class SceneResources final : public NodeResources {
public:
    explicit SceneResources(SceneData& data) : data_(data) {}

    [[nodiscard]] int uv_layer(const std::string& name) override
    {
        return intern(data_.uv_layer_names, name);
    }
    [[nodiscard]] int attribute(const std::string& name) override
    {
        return intern(data_.attribute_names, name);
    }
    void require_texture(int texture) override
    {
        require_index("texture", static_cast<std::size_t>(texture),
                      static_cast<std::size_t>(data_.textures.size()));
    }
    [[nodiscard]] WorkingSpace working_space() override { return data_.working_space; }

private:
    SceneData& data_;
};

}  // namespace eye_render
