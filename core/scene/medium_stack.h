// The media that a path is in: the world's, and those of the closed meshes around it. It enters a
// mesh's by the front of its surface and leaves by the back, as the mesh's winding says; media
// that overlap add up.

#pragma once

#include "scene/surface_hit.h"
#include "shading/participating_medium.h"

#include <array>
#include <optional>

namespace eye_render {

class MediumStack {
public:
    // In no mesh. `world` fills everything, may be null, and must outlive the stack.
    explicit MediumStack(const ParticipatingMedium* world) : world_(world)
    {
        if (world != nullptr) {
            mixture_ = *world;
        }
    }

    // Something is around, described by `mixture`.
    [[nodiscard]] bool in_medium() const { return mixture_.has_value(); }
    [[nodiscard]] const ParticipatingMedium& mixture() const { return *mixture_; }

    // Calls visit(emission, placement) for each of the media that shine; null: the world's.
    template <typename Visit>
    void visit_emission(Visit visit) const
    {
        if (!in_medium() || max_component(mixture().emission) <= 0.0f) {
            return;
        }
        if (world_ != nullptr) {
            visit(world_->emission, nullptr);
        }
        for (std::size_t i = 0; i < count_; ++i) {
            visit(inside_[i].medium->emission, inside_[i].placement);
        }
    }

    // The path passes through the surface that it hit.
    void cross(const SurfaceHit& hit);
    // A mesh that was never left has a hole: a path that meets nothing more is out of it.
    void leave_meshes();

private:
    // Without initialisers, and the mixture only where there is one: to clear room that few
    // paths use took 150 of a plain scene's 11,400 instructions a path.
    struct Inside {
        const Placement* placement;
        const ParticipatingMedium* medium;

        bool operator==(const Inside&) const = default;
    };
    // More that overlap are left out.
    static constexpr std::size_t capacity = 16;

    void mix();

    const ParticipatingMedium* world_;
    std::size_t count_ = 0;
    std::array<Inside, capacity> inside_;  // the first `count_`
    std::optional<ParticipatingMedium> mixture_;
};

}  // namespace eye_render
