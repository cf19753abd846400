// The seam that everything hangs on: what one eye does with a point of its pupil.
//
// Camera frame (Blender's): origin at the centre of the entrance pupil, looking along -Z, +X
// right, +Y up *as the patient sees*. A slope is (dx, dy) per unit of forward travel, so it has
// no unit and a pixel has a chief slope whatever the scene's scale. The same function serves the
// picture and the analysis, so a PSF plot cannot disagree with a render.

#pragma once

#include "base/vector.h"
#include "optics/power_matrix.h"

#include <array>
#include <memory>
#include <optional>
#include <string_view>

namespace eye_render {

// What became of a ray; a value, never an exception, because it is asked for once per sample.
enum class RayFate { Transmitted, Vignetted, Missed, TotalReflection };

inline constexpr std::array ray_fates{RayFate::Transmitted, RayFate::Vignetted, RayFate::Missed,
                                      RayFate::TotalReflection};

[[nodiscard]] constexpr std::string_view to_string(RayFate fate)
{
    switch (fate) {
    case RayFate::Transmitted: return "transmitted";
    case RayFate::Vignetted: return "vignetted";
    case RayFate::Missed: return "missed";
    case RayFate::TotalReflection: return "total_reflection";
    }
    return "";
}

struct EyeRay {
    RayFate fate = RayFate::Transmitted;
    V3d origin_eye_m{0.0};  // where the ray leaves the eye, metres, camera frame
    V2d slope{0.0};         // object-space slope
    double weight = 1.0;    // 0 unless Transmitted
};

// Of a model without limits of its own: beyond it a number is a slip of the keyboard.
inline constexpr double max_accommodation_d = 20.0;

// Its functions may be called from several threads at once.
class EyeModel {
public:
    virtual ~EyeModel() = default;

    // The object-space ray of the pixel with chief slope `chief_slope` through the entrance-pupil
    // point `pupil_point_m` (metres). Finite for all finite arguments; wavelengths outside 380 to
    // 780 nm may count as the nearest end.
    [[nodiscard]] virtual EyeRay ray(const V2d& chief_slope,
                                     const V2d& pupil_point_m,
                                     double wavelength_nm) const = 0;

    // K, the conjugate vergence of the retina in dioptres near the axis at 555 nm, camera frame.
    // Zero for a pinhole, which has no blur at all. Behind a lens it is the error for an object at
    // infinity, which without one is the same.
    [[nodiscard]] virtual PowerMatrix retinal_conjugate_d() const = 0;

    // E, the error by which the eye blurs an object at vergence X = 1/distance from the entrance
    // pupil: K - X I, unless the eye looks through a lens.
    [[nodiscard]] virtual PowerMatrix error_d(double object_vergence_d) const
    {
        return retinal_conjugate_d() - PowerMatrix::sphere(object_vergence_d);
    }

    [[nodiscard]] virtual double pupil_diameter_m() const = 0;

    // Whether its rays depend on the wavelength.
    [[nodiscard]] virtual bool is_chromatic() const { return true; }

    // Whether at 555 nm its rays do over the whole pupil what retinal_conjugate_d() says of those
    // next to the axis, so that the mean error is what the blur is least without.
    [[nodiscard]] virtual bool is_first_order() const { return true; }

    // The most accommodation that the model has, whatever the person's age allows.
    [[nodiscard]] virtual double max_accommodation_d() const
    {
        return eye_render::max_accommodation_d;
    }

    // The largest angle by which its rays may differ from those of the eye it stands for, within
    // 20 degrees of the axis: 0 for a model that evaluates its own definition.
    [[nodiscard]] virtual double approximation_arcmin() const { return 0.0; }

    // How far from the axis that approximation is used; nothing for a model that makes none.
    [[nodiscard]] virtual std::optional<double> fitted_field_deg() const { return std::nullopt; }
};

}  // namespace eye_render
