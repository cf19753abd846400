// Checks what is said of an eye, refers its prescription and picks the model.

#include "eye/eye_factory.h"

#include "base/error.h"
#include "base/units.h"
#include "eye/models.h"

namespace eye_render {

namespace {

// The prescription where it was written, camera frame.
PowerMatrix rx_as_written(const EyeSpec& spec)
{
    if (const auto* rx = std::get_if<Prescription>(&spec.rx)) {
        require_valid(*rx);
        return power_matrix_camera(*rx);
    }
    const auto& power = std::get<PowerMatrix>(spec.rx);
    require_prescribable(power, "rx");
    return power;
}

std::unique_ptr<EyeModel> make_eye_of_kind(const EyeSpec& spec, SchematicEyeKind kind)
{
    return make_schematic_eye(SchematicSpec{.kind = kind,
                                            .rx_entrance_pupil_d = rx_at_entrance_pupil(spec),
                                            .accommodation_d = spec.accommodation_d,
                                            .pupil_diameter_m = spec.pupil_diameter_m,
                                            .zero = spec.zero,
                                            .exact_trace = spec.exact_trace});
}

const Wavefront& measured_wavefront(const EyeSpec& spec)
{
    if (!spec.wavefront) {
        throw std::invalid_argument(
            "wavefront is missing; expected one for the model 'wavefront'");
    }
    require_covers(*spec.wavefront, spec.pupil_diameter_m);
    return *spec.wavefront;
}

std::unique_ptr<EyeModel> make_bare_eye(const EyeSpec& spec)
{
    const PowerMatrix rx_entrance_pupil = rx_at_entrance_pupil(spec);
    if (spec.model == EyeModelKind::Paper) {
        // A worn lens has a place, so behind it the eye's prescription must have one, too.
        return make_paper_eye(spec.worn ? rx_entrance_pupil : rx_as_written(spec),
                              spec.accommodation_d, spec.pupil_diameter_m, spec.eye_length_m);
    }
    if (spec.model == EyeModelKind::Navarro) {
        return make_eye_of_kind(spec, SchematicEyeKind::Navarro);
    }
    if (spec.model == EyeModelKind::Arizona) {
        return make_eye_of_kind(spec, SchematicEyeKind::Arizona);
    }
    if (spec.model == EyeModelKind::LeGrand) {
        return make_eye_of_kind(spec, SchematicEyeKind::LeGrand);
    }
    const PowerMatrix conjugate_d = PowerMatrix::sphere(spec.accommodation_d) - rx_entrance_pupil;
    if (spec.model == EyeModelKind::Wavefront) {
        return make_wavefront_eye(conjugate_d, spec.pupil_diameter_m, measured_wavefront(spec));
    }
    return make_paraxial_eye(conjugate_d, spec.pupil_diameter_m);
}

}  // namespace

std::string_view to_string(RxPlane plane)
{
    switch (plane) {
    case RxPlane::Spectacle: return "spectacle";
    case RxPlane::Cornea: return "cornea";
    case RxPlane::EntrancePupil: return "entrance_pupil";
    }
    return "";
}

std::string_view to_string(EyeModelKind kind)
{
    switch (kind) {
    case EyeModelKind::Pinhole: return "pinhole";
    case EyeModelKind::Paper: return "paper";
    case EyeModelKind::Paraxial: return "paraxial";
    case EyeModelKind::Wavefront: return "wavefront";
    case EyeModelKind::Navarro: return "navarro";
    case EyeModelKind::Arizona: return "arizona";
    case EyeModelKind::LeGrand: return "le_grand";
    }
    return "";
}

PowerMatrix rx_at_entrance_pupil(const EyeSpec& spec)
{
    const PowerMatrix rx = rx_as_written(spec);
    if (spec.rx_plane == RxPlane::EntrancePupil) return rx;
    if (spec.rx_plane == RxPlane::Cornea) return moved_toward_eye(rx, cornea_to_entrance_pupil_m);
    require_range("vertex_mm", mm_from_m(spec.vertex_m), 0.0, mm_from_m(max_vertex_m), "mm");
    return moved_toward_eye(rx, spec.vertex_m + cornea_to_entrance_pupil_m);
}

std::unique_ptr<EyeModel> make_eye(const EyeSpec& spec)
{
    require_range("pupil_mm", mm_from_m(spec.pupil_diameter_m), 0.0,
                  mm_from_m(max_pupil_diameter_m), "mm");
    require_range("accommodation_d", spec.accommodation_d, 0.0, max_accommodation_d, "D");
    require_range("vertex_mm", mm_from_m(spec.vertex_m), 0.0, mm_from_m(max_vertex_m), "mm");
    require_range("eye_length_mm", mm_from_m(spec.eye_length_m), 10.0, 40.0, "mm");
    if (spec.wavefront) require_valid(*spec.wavefront);
    std::unique_ptr<EyeModel> eye = make_bare_eye(spec);
    if (spec.model == EyeModelKind::Pinhole) return make_pinhole_eye();
    return spec.worn ? make_corrected_eye(std::move(eye), *spec.worn) : std::move(eye);
}

}  // namespace eye_render
