// The media that a path is in: the world's, and those of the closed meshes around it. It enters a
// mesh's by the front of its surface and leaves by the back, as the mesh's winding says; media
// that overlap add up.

#pragma once

#include "scene/surface_hit.h"
#include "shading/participating_medium.h"

#include <array>

namespace eye_render {

class MediumStack {
public:
    // In no mesh. `world` fills everything, may be null, and must outlive the stack.
    explicit MediumStack(const ParticipatingMedium* world)
        : world_(world), in_medium_(world != nullptr)
    {
        if (world != nullptr) {
            mixture_ = *world;
        }
    }

    // Something is around, described by `mixture`.
    [[nodiscard]] bool in_medium() const { return in_medium_; }
    [[nodiscard]] const ParticipatingMedium& mixture() const { return mixture_; }

    // The path passes through the surface that it hit.
    void cross(const SurfaceHit& hit);
    // A mesh that was never left has a hole: a path that meets nothing more is out of it.
    void leave_meshes();

private:
    struct Inside {
        const Placement* placement = nullptr;
        const ParticipatingMedium* medium = nullptr;

        bool operator==(const Inside&) const = default;
    };
    // More that overlap are left out.
    static constexpr std::size_t capacity = 16;

    void mix();

    const ParticipatingMedium* world_;
    bool in_medium_;
    std::size_t count_ = 0;
    std::array<Inside, capacity> inside_;  // the first `count_`
    ParticipatingMedium mixture_;
};

}  // namespace eye_render
