// The attributes of any place of a scene, for the files that Scene is made of.

#pragma once

#include "scene/curve_attributes.h"
#include "scene/mesh_attributes.h"
#include "scene/point_attributes.h"
#include "scene/scene.h"

namespace eye_render {

template <typename Look>
auto Scene::look_at(const SurfaceHit& hit, const Look& look) const
{
    Room<Pose> moved;
    const Pose& pose = pose_at(*hit.placement, hit.time, moved);
    if (hit.placement->mesh() != nullptr) {
        return look(
            MeshAttributes(*hit.placement, pose, hit.primitive, hit.u, hit.v, hit.time, frame_));
    }
    if (std::holds_alternative<Curves>(*hit.placement->geometry)) {
        return look(CurveAttributes(hit, hit.p_world, pose, frame_));
    }
    return look(PointAttributes(hit, hit.p_world, pose, frame_));
}

}  // namespace eye_render
