#include "shading/material.h"

namespace eye_render {

bool Material::may_be_transparent() const
{
    return false;
}

bool Material::may_emit() const
{
    return false;
}

ShadedPoint shade(const Material&, const ShadingPoint&, const HitAttributes&)
{
    return {};
}

Color3f straight_transmittance(const Material&, const HitAttributes&)
{
    return Color3f(0.0f);
}

Color3f emitted_radiance(const Material&, const HitAttributes&)
{
    return Color3f(0.0f);
}

}  // namespace eye_render
