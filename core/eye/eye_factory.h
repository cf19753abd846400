// What is said of an eye, and the model made of it.

#pragma once

#include "eye/eye_model.h"
#include "eye/schematic.h"
#include "eye/worn_lens.h"
#include "optics/prescription.h"
#include "optics/wavefront.h"

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>

namespace eye_render {

// Cheapest first.
enum class EyeModelKind { Pinhole, Paper, Paraxial, Wavefront, Navarro, Arizona, LeGrand };

inline constexpr std::array eye_model_kinds{
    EyeModelKind::Pinhole, EyeModelKind::Paper,   EyeModelKind::Paraxial, EyeModelKind::Wavefront,
    EyeModelKind::Navarro, EyeModelKind::Arizona, EyeModelKind::LeGrand};

// Whether it is made of real surfaces.
[[nodiscard]] constexpr bool is_schematic(EyeModelKind kind)
{
    return kind == EyeModelKind::Navarro || kind == EyeModelKind::Arizona ||
           kind == EyeModelKind::LeGrand;
}

// "pinhole", "paper", "paraxial", "wavefront", "navarro", "arizona", "le_grand".
[[nodiscard]] std::string_view to_string(EyeModelKind kind);

// Where the prescription was written for: the lens before the eye, a contact lens, or the
// entrance pupil, where the models work.
enum class RxPlane { Spectacle, Cornea, EntrancePupil };

inline constexpr std::array rx_planes{RxPlane::Spectacle, RxPlane::Cornea, RxPlane::EntrancePupil};

// "spectacle", "cornea", "entrance_pupil".
[[nodiscard]] std::string_view to_string(RxPlane plane);

// A schematic eye's iris, or the edge of its cornea, may let less through.
inline constexpr double max_pupil_diameter_m = 9e-3;

struct EyeSpec {
    EyeModelKind model = EyeModelKind::Paraxial;
    // A matrix is in the camera frame; use one for what is left of an eye's prescription behind
    // the lenses it wears.
    std::variant<Prescription, PowerMatrix> rx = Prescription{};
    RxPlane rx_plane = RxPlane::Spectacle;
    double vertex_m = 12e-3;         // spectacle plane to cornea; used with RxPlane::Spectacle
    double pupil_diameter_m = 4e-3;  // of the entrance pupil, 0 for none
    double accommodation_d = 0.0;    // referred to the entrance pupil
    double eye_length_m = 17e-3;     // the paper's d_eye; used with EyeModelKind::Paper
    // Of the schematic eyes: what a refraction of 0 is, and whether every ray is traced through
    // the surfaces rather than fitted to such rays.
    RefractionZero zero = RefractionZero::Paraxial;
    bool exact_trace = false;
    // In the clinician's frame; needed with EyeModelKind::Wavefront and then at least as wide as
    // the pupil. The prescription stands for its tilt and second order: see wavefront.cpp.
    std::optional<Wavefront> wavefront{};
    std::optional<WornLens> worn{};  // what the eye looks through; the pinhole ignores it
};

// The prescription referred to the entrance pupil, camera frame. Throws std::invalid_argument for
// a prescription or vertex distance out of range (NaN included).
[[nodiscard]] PowerMatrix rx_at_entrance_pupil(const EyeSpec& spec);

// Throws std::invalid_argument for anything out of range, whether the model uses it or not. The
// paper's model knows no vertex distance and takes the prescription as it is written, unless the
// eye wears a lens; the pinhole has neither prescription nor pupil.
[[nodiscard]] std::unique_ptr<EyeModel> make_eye(const EyeSpec& spec);

}  // namespace eye_render
