// What Eye and Observer are both told of an eye.

#pragma once

#include "api/eye.h"
#include "options.h"

namespace eye_render {

// `eye_of` gives the description that is part of const and of other options.
template <typename Options, typename EyeOf>
void define_eye_options(py::class_<Options>& target, const EyeOf& eye_of)
{
    define_named_option(
        target, "model", [eye_of](auto& options) -> auto& { return eye_of(options).model; },
        eye_model_kinds, "One of EYE_MODELS.");
    target.def_property(
        "rx", [eye_of](const Options& options) { return eye_of(options).rx; },
        [eye_of](Options& options, const py::object& rx) {
            eye_of(options).rx = prescription_from_python(rx);
        },
        "The eye's own prescription, or a text such as '-2.00DS -0.75DC 160A'.");
    define_named_option(
        target, "rx_plane", [eye_of](auto& options) -> auto& { return eye_of(options).rx_plane; },
        rx_planes, "Where the prescription holds: 'spectacle', 'cornea' or 'entrance_pupil'.");
    define_option(
        target,
        "vertex_mm", [eye_of](auto& options) -> auto& { return eye_of(options).vertex_mm; },
        "From glasses, and from the prescription's plane, to the cornea.");
    define_named_option(
        target,
        "correction", [eye_of](auto& options) -> auto& { return eye_of(options).correction; },
        corrections, "What is worn: 'none', 'glasses' or 'contacts'.");
    target.def_property(
        "worn", [eye_of](const Options& options) { return eye_of(options).worn; },
        [eye_of](Options& options, const py::object& worn) {
            eye_of(options).worn.reset();
            if (!worn.is_none()) {
                eye_of(options).worn = prescription_from_python(worn);
            }
        },
        "What the correction is made to; None: the eye's own prescription.");
    define_option(
        target,
        "near_part", [eye_of](auto& options) -> auto& { return eye_of(options).near_part; },
        "Looks through the part of the glasses with the reading addition.");
    define_option(
        target,
        "wavefront", [eye_of](auto& options) -> auto& { return eye_of(options).wavefront; },
        "A Wavefront, for the model of that name.");
    define_named_option(
        target, "refraction_zero",
        [eye_of](auto& options) -> auto& { return eye_of(options).refraction_zero; },
        refraction_zeros, "One of REFRACTION_ZEROS: what 0 D means for a schematic eye.");
    define_option(
        target,
        "exact_trace", [eye_of](auto& options) -> auto& { return eye_of(options).exact_trace; },
        "Schematic eyes: every ray through the surfaces, not by the fit.");
}

}  // namespace eye_render
