#include "render/surface_passes.h"

#include <algorithm>

namespace eye_render {

namespace {

[[nodiscard]] float mean(const Color3f& c) { return (c.x + c.y + c.z) / 3.0f; }

}  // namespace

void note_surface(PassValues& values,
                  const SurfaceHit& hit,
                  const ShadedPoint& shaded,
                  const Color3f& throughput)
{
    if (!values.layout().has_surface()) {
        return;
    }
    const Bsdf& bsdf = shaded.bsdf;
    const BsdfParts albedos = bsdf.albedos();
    const float seen = std::max(0.0f, mean(throughput * (Color3f(1.0f) - bsdf.straight())));
    values.add(Pass::Normal, hit.point.ns * seen);
    values.add(Pass::DiffuseColor, throughput * albedos.diffuse);
    values.add(Pass::GlossyColor, throughput * albedos.glossy);
    values.add(Pass::TransmissionColor, throughput * albedos.transmission);
    values.add(Pass::DenoisingAlbedo, throughput * bsdf.albedo());
}

}  // namespace eye_render
