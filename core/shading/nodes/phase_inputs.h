// How a volume's node says where light goes that it scatters.

#pragma once

#include "shading/node.h"
#include "shading/participating_medium.h"

namespace eye_render {

enum class PhaseKind { HenyeyGreenstein, FournierForand, Rayleigh, Draine, Mie };

// Throws std::invalid_argument for an option that is none.
[[nodiscard]] PhaseKind phase_kind(const NodeOptions& options);

// The inputs of phase functions among those of a node.
struct PhaseInputs {
    std::size_t ior;
    std::size_t backscatter;
    std::size_t anisotropy;
    std::size_t alpha;
    std::size_t diameter_um;
};

[[nodiscard]] float anisotropy_range(float g);

// `scattering` per unit length. Adds to the extinction, too.
void add_scattering(const NodeInputs& in,
                    PhaseKind kind,
                    const PhaseInputs& inputs,
                    const Color3f& scattering,
                    ParticipatingMedium& medium);

}  // namespace eye_render
