#include "scene/curve_attributes.h"

#include "shading/procedural/hash.h"

#include <limits>

namespace eye_render {

V3f CurveAttributes::position_world() const { return {V3d(p_world_) + frame_.eye_position_world}; }

V3f CurveAttributes::position_object() const
{
    return p_world_ * pose_.world_from_object.inverse();
}

V3f CurveAttributes::generated() const
{
    return in_texture_space(curves_.keys[curves_.first_keys[place_.strand]].center);
}

V2f CurveAttributes::uv(int uv_layer) const
{
    const int layer = placement_.layers->uv[static_cast<std::size_t>(uv_layer)];
    return layer == LayerLookup::none
               ? V2f(0.0f)
               : curves_.uv_layers[static_cast<std::size_t>(layer)].per_strand[place_.strand];
}

TangentFrame CurveAttributes::tangent(int /*uv_layer*/) const
{
    V3f along;
    pose_.world_from_object.multDirMatrix(strand_point(curves_, place_, hit_.time).derivative,
                                          along);
    return {.tangent = unit_or(hit_.point.backfacing ? -along : along, V3f(0.0f))};
}

AttributeValue CurveAttributes::attribute(int attribute) const
{
    const int layer = placement_.layers->attributes[static_cast<std::size_t>(attribute)];
    if (layer == LayerLookup::none) {
        return object_property(attribute);
    }
    const auto& per_key = curves_.attributes[static_cast<std::size_t>(layer)].per_key;
    return {.value = per_key[place_.key] * (1.0f - place_.u) + per_key[place_.key + 1] * place_.u,
            .exists = true};
}

float CurveAttributes::edge_distance() const { return std::numeric_limits<float>::max(); }

std::optional<StrandFacts> CurveAttributes::strand() const
{
    const StrandPoint point = strand_point(curves_, place_, hit_.time);
    const StrandLength length = strand_length(curves_, place_);
    const auto strand_number = static_cast<std::uint32_t>(place_.strand);
    return StrandFacts{.intercept = length.total > 0.0f ? length.to_place / length.total : 0.0f,
                       .length = length.total,
                       .thickness = 2.0f * point.at.radius,
                       .random = 0x1p-32f * static_cast<float>(hash(strand_number, 0u)),
                       .tangent = tangent(HitAttributes::active_uv_layer).tangent};
}

}  // namespace eye_render
