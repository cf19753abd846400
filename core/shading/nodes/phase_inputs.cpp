#include "shading/nodes/phase_inputs.h"

#include "shading/droplets.h"
#include "shading/input_range.h"

namespace eye_render {

PhaseKind phase_kind(const NodeOptions& options)
{
    return options.choice<PhaseKind>("phase", {{"HENYEY_GREENSTEIN", PhaseKind::HenyeyGreenstein},
                                               {"FOURNIER_FORAND", PhaseKind::FournierForand},
                                               {"RAYLEIGH", PhaseKind::Rayleigh},
                                               {"DRAINE", PhaseKind::Draine},
                                               {"MIE", PhaseKind::Mie}});
}

float anisotropy_range(float g) { return in_range(g, -largest_anisotropy, largest_anisotropy); }

void add_scattering(const NodeInputs& in,
                    PhaseKind kind,
                    const PhaseInputs& inputs,
                    const Color3f& scattering,
                    ParticipatingMedium& medium)
{
    switch (kind) {
    case PhaseKind::HenyeyGreenstein:
        medium.scatter({scattering, {.g = anisotropy_range(in.number(inputs.anisotropy))}});
        break;
    case PhaseKind::FournierForand:
        medium.scatter({scattering,
                        {.particles = fournier_forand(in.number(inputs.ior),
                                                      in.number(inputs.backscatter))}});
        break;
    case PhaseKind::Rayleigh: medium.scatter({scattering, {.alpha = 1.0f}}); break;
    case PhaseKind::Draine:
        medium.scatter({scattering,
                        {.g = anisotropy_range(in.number(inputs.anisotropy)),
                         .alpha = positive_range(in.number(inputs.alpha))}});
        break;
    case PhaseKind::Mie: {
        const DropletScattering droplets = scattering_of_droplets(in.number(inputs.diameter_um));
        medium.scatter({scattering * (1.0f - droplets.wide_share), droplets.narrow});
        medium.scatter({scattering * droplets.wide_share, droplets.wide});
        break;
    }
    }
    medium.extinction += scattering;
}

}  // namespace eye_render
