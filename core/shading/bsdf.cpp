#include "shading/bsdf.h"

namespace eye_render {

BsdfValue Bsdf::evaluate(const V3f&) const
{
    return {};
}

std::optional<BsdfSample> Bsdf::sample(float, const V2f&) const
{
    return std::nullopt;
}

Color3f Bsdf::albedo() const
{
    return Color3f(0.0f);
}

bool Bsdf::is_delta_only() const
{
    return true;
}

}  // namespace eye_render
