#include "scene/placed_attributes.h"

namespace eye_render {

AttributeValue PlacedAttributes::object_property(int attribute) const
{
    for (const ObjectProperty& property : placement_.look.properties) {
        if (property.attribute == attribute) {
            return {.value = property.value, .exists = true};
        }
    }
    return {};
}

V3f PlacedAttributes::in_texture_space(const V3f& p_object) const
{
    const TextureSpace& space = *placement_.texture_space;
    return (p_object - space.origin) / space.size;
}

const ObjectFacts& PlacedAttributes::object() const
{
    if (!object_) {
        M44d world_from_object(pose_.world_from_object);
        for (int axis = 0; axis < 3; ++axis) {
            world_from_object[3][axis] += frame_.eye_position_world[axis];
        }
        object_.fill(
            {.world_from_object = M44f(world_from_object),
             .object_from_world = M44f(world_from_object.inverse()),
             .color = placement_.look.color,
             .pass_index = placement_.look.pass_index,
             .material_index = static_cast<float>(placement_.material(primitive_).pass_index),
             .random = placement_.look.random});
    }
    return *object_;
}

}  // namespace eye_render
