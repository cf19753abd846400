// Look-ups of material inputs. A colour that feeds a scalar counts by its luminance, as in
// Blender; `Channel::Luminance` and `Channel::Alpha` feed a colour as grey.

#include "shading/material_input.h"

namespace eye_render {

Color4f look_up(const MaterialInput& input, const HitAttributes& attributes)
{
    return input.texture != MaterialInput::none
               ? attributes.texture(input.texture, attributes.uv(input.uv_layer))
               : attributes.color(input.color_attribute);
}

Color3f color_from_lookup(const MaterialInput& input, const Color4f& c)
{
    return input.channel == Channel::Color ? Color3f(c.r, c.g, c.b)
                                           : Color3f(scalar_from_lookup(input, c));
}

float scalar_from_lookup(const MaterialInput& input, const Color4f& c)
{
    switch (input.channel) {
    case Channel::Alpha: return c.a;
    case Channel::Luminance: return luminance(Color3f(c.r, c.g, c.b));
    default: return luminance({c.r, c.g, c.b});
    }
}

}  // namespace eye_render
