// A schematic eye made for a person: which length, cornea and lens give the refraction.

#pragma once

#include "eye/schematic.h"
#include "optics/chromatic.h"

namespace eye_render {

struct SchematicBody {
    LensSystem system;                 // in the frame of the cornea's principal meridians
    V2d axis_x_camera{1.0, 0.0};       // the system's x as the patient sees it
    double entrance_pupil_m = 0.0;     // behind the cornea's vertex, for its mean curvature
    PowerMatrix retinal_conjugate_d;   // camera frame, at the entrance pupil
    double max_accommodation_d = 0.0;  // what the publication's parameter can do for this eye
};

// Throws std::invalid_argument, with what is out of range, when no such eye exists.
[[nodiscard]] SchematicBody schematic_body(const SchematicSpec& spec);

// The conjugate vergence of the retina of an eye of revolution at the plane of its entrance pupil,
// by the definition that `zero` names; to first order for a pupil of 0.
[[nodiscard]] double mean_conjugate_d(const LensSystem& system,
                                      RefractionZero zero,
                                      double pupil_diameter_m,
                                      double wavelength_nm = reference_wavelength_nm);

// The place of the retina, from the cornea, that gives the eye this mean_conjugate_d. Throws
// std::invalid_argument when the vitreous body would be shorter than 1 mm or longer than 60 mm.
[[nodiscard]] double axial_length_m(LensSystem system,
                                    double conjugate_d,
                                    RefractionZero zero,
                                    double pupil_diameter_m,
                                    double wavelength_nm = reference_wavelength_nm);

// The radius of the anterior cornea for which the retina's conjugate at `plane_m` has the vergence
// `conjugate_d`, to first order. Throws std::invalid_argument when it is not within 3 to 40 mm.
[[nodiscard]] double anterior_radius_m(LensSystem system,
                                       double conjugate_d,
                                       double plane_m,
                                       double wavelength_nm = reference_wavelength_nm);

}  // namespace eye_render
