// A spectacle prescription and its algebra.
//
// A prescription is the power of the *correcting* lens, in dioptres: sphere S along the axis
// meridian, S + C across it. An eye prescribed -3 D is 3 D too strong; its error is minus the
// prescription. Axes are TABO (ISO 8429): 0 to 180 degrees counter-clockwise from the right-hand
// horizontal as seen by the *examiner facing the patient*, the same for both eyes.
//
// Two frames meet here and the variable says which: `tabo` (the examiner's) and `camera` (as the
// patient sees). They are mirror images, so a camera angle is 180 - axis and J45 changes sign.
//
// Sources: Long 1976 (power matrix), Thibos, Wheeler & Horner 1997 (power vector).

#pragma once

#include "optics/power_matrix.h"

namespace eye_render {

// The strongest lenses there are. Beyond these a number is a slip of the keyboard.
inline constexpr double max_sphere_d = 30.0;
inline constexpr double max_cylinder_d = 15.0;
inline constexpr double max_add_d = 4.0;
inline constexpr double max_prism_pd = 30.0;

enum class EyeSide { Unspecified, Right, Left, Both };

struct Prescription {
    double sphere_d = 0.0;
    double cylinder_d = 0.0;  // minus or plus form, as written
    double axis_deg = 180.0;  // TABO; without meaning when the cylinder is 0
    double add_d = 0.0;       // near addition, 0 for none
    // Prism, in prism dioptres (1 cm at 1 m): how far the line of sight is bent towards the nose
    // and upwards, where the prism's base is. Negative: base out, base down.
    double base_in_pd = 0.0;
    double base_up_pd = 0.0;
    EyeSide eye = EyeSide::Unspecified;

    [[nodiscard]] bool operator==(const Prescription&) const = default;
};

// Throws std::invalid_argument unless every number is finite and in its range.
void require_valid(const Prescription& rx);

// Throws std::invalid_argument for a power that no valid prescription has in either form; the
// messages call the power `name`. Rounding may have made the strongest stronger.
void require_prescribable(const PowerMatrix& power, std::string_view name);

// By how much the prism bends the line of sight, as a slope in the camera frame: what is seen
// moves the other way. The nose is to the left as the right eye sees it, to the right for the left
// eye. Throws std::invalid_argument for a prism base in or out of an eye that is neither.
[[nodiscard]] V2d prism_slope(const Prescription& rx);

// An axis as it is written: above 0, up to 180.
[[nodiscard]] double normalized_axis_deg(double axis_deg);

// The same lens with the cylinder of the other sign: S + C, -C, axis turned by 90 degrees.
[[nodiscard]] Prescription transposed(const Prescription& rx);

// M, J0 and J45 (TABO frame), the coordinates in which lenses simply add.
struct PowerVector {
    double m_d = 0.0;
    double j0_d = 0.0;
    double j45_d = 0.0;
};

[[nodiscard]] PowerVector power_vector(const Prescription& rx);

enum class CylinderForm { Minus, Plus };

// Sphere and cylinder of a power vector. An astigmatism below 1e-12 D has no axis and is dropped.
[[nodiscard]] Prescription prescription_from(const PowerVector& power,
                                             CylinderForm form = CylinderForm::Minus);
[[nodiscard]] Prescription prescription_from(const PowerMatrix& power_tabo,
                                             CylinderForm form = CylinderForm::Minus);

[[nodiscard]] PowerMatrix power_matrix_tabo(const Prescription& rx);
[[nodiscard]] PowerMatrix power_matrix_camera(const Prescription& rx);

// The mirror between the examiner's and the patient's view; its own inverse.
[[nodiscard]] constexpr PowerMatrix mirrored(const PowerMatrix& power)
{
    return {power.xx_d, -power.xy_d, power.yy_d};
}

// The direction of a TABO axis, degrees counter-clockwise from +X as the patient sees it,
// 0 to below 180.
[[nodiscard]] double camera_angle_deg(double axis_deg);

// The lens that two lenses in contact make, prisms included. Their axes may cross at any angle.
// Near
// additions add up, and the eye's side is the first lens's.
[[nodiscard]] Prescription crossed(const Prescription& a, const Prescription& b);

// Power along a meridian (curvital) and across it (torsional): how much a ray that enters on the
// meridian is bent towards the centre, and how much it is bent sideways, out of the meridian.
struct MeridionalPower {
    double curvital_d = 0.0;
    double torsional_d = 0.0;
};

[[nodiscard]] MeridionalPower meridional_power(const PowerMatrix& power, double meridian_deg);

// Effectivity, F' = F (I - d F)^-1: the lens that has the same far points when its plane is moved
// by `distance_m` towards the eye (away from it when negative). In any frame. Throws
// std::invalid_argument when the plane would come within a tenth of a focal length of the lens's
// own focus, where no lens has that effect.
[[nodiscard]] PowerMatrix moved_toward_eye(const PowerMatrix& power, double distance_m);

}  // namespace eye_render
