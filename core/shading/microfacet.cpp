// Sampling of the visible GGX normals; the model is described in the header.

#include "shading/microfacet.h"

#include "base/warp.h"

namespace eye_render {

V3f sample_visible_normal(const V3f& wo_local, float alpha, const V2f& u)
{
    // In the space where the surface is a hemisphere, mirror directions of a visible hemisphere
    // fill a cap around the pole uniformly.
    const V3f wo_stretched = V3f(alpha * wo_local.x, alpha * wo_local.y, wo_local.z).normalized();
    const V3f mirrored = sample_uniform_cone(u, 1.0f + wo_stretched.z);
    const V3f h = mirrored + wo_stretched;
    const V3f m = V3f(alpha * h.x, alpha * h.y, std::max(0.0f, h.z));

    // Zero only if the cap's very rim was drawn; any normal does.
    const float length2 = m.length2();
    return length2 > 0.0f ? m / std::sqrt(length2) : V3f(0.0f, 0.0f, 1.0f);
}

}  // namespace eye_render
