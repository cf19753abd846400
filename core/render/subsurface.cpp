#include "render/subsurface.h"

#include "render/subsurface_disk.h"
#include "render/subsurface_walk.h"

namespace eye_render {

std::optional<SubsurfaceExit> sample_exit(const Scene& scene,
                                          const SurfaceHit& entry,
                                          const Lobe& lobe,
                                          const Color3f& throughput,
                                          SampleSequence& sequence)
{
    // Walks are of meshes alone: a ray that leaves a strand or a ball does not meet it again.
    if (entry.placement->mesh() == nullptr) {
        return SubsurfaceExit{entry, throughput};
    }
    auto exit = lobe.kind == LobeKind::Burley
                    ? sample_disk_exit(scene, entry, lobe, throughput, sequence)
                    : walk_below(scene, entry, lobe, throughput, sequence);
    if (exit) {
        // Which was the way from the viewer, and how wide a pixel is.
        exit->hit.t = entry.t;
        exit->hit.point.footprint = entry.point.footprint;
    }
    return exit;
}

Bsdf exit_bsdf(const Scene& scene, const SurfaceHit& exit, const PathState& path)
{
    Lobe lobe = diffuse_lobe(Color3f(1.0f), exit.point.ns, exit.point.ns);
    if (exit.material().surface.bends_subsurface()) {
        PathState inside = path;
        inside.is_camera = false;
        lobe = scene.shade(exit, inside).bsdf.exit_lobe().value_or(lobe);
    }
    Bsdf bsdf(exit.point.wo, exit.point.ng);
    bsdf.add(lobe, lobe.weight);
    return bsdf;
}

}  // namespace eye_render
