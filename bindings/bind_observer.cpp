// eyecore.Observer.

#include "api/observer.h"
#include "bind_values.h"
#include "module.h"

namespace eye_render {

namespace {

Observer make_observer(const std::string& model,
                       const py::object& rx,
                       const std::string& rx_plane,
                       double vertex_mm,
                       double age_years,
                       const py::object& pupil,
                       const std::string& pupil_formula,
                       double cd_m2_per_unit,
                       double luminance_sigma,
                       const std::optional<double>& field_area_deg2,
                       int eyes,
                       const py::object& focus,
                       const std::string& correction,
                       const py::object& worn,
                       bool near_part,
                       const std::optional<Wavefront>& wavefront,
                       const std::string& refraction_zero,
                       bool exact_trace,
                       const std::string& amplitude_formula)
{
    Observer observer;
    observer.amplitude_formula =
        named_of("amplitude_formula", amplitude_formula, amplitude_formulas);
    observer.eye = eye_from_python(model, rx, rx_plane, vertex_mm, correction, worn, near_part,
                                   wavefront, refraction_zero, exact_trace);
    observer.age_years = age_years;
    if (const auto diameter_mm = number_from(pupil)) {
        observer.pupil_mm = *diameter_mm;
    } else if (!py::isinstance<py::str>(pupil) || pupil.cast<std::string>() != "auto") {
        throw std::invalid_argument("pupil is " + text_of(pupil) +
                                    "; expected 'auto' or a number of mm");
    }
    observer.pupil_formula = named_of("pupil_formula", pupil_formula, pupil_formulas);
    observer.cd_m2_per_unit = cd_m2_per_unit;
    observer.luminance_sigma = luminance_sigma;
    observer.field_area_deg2 = field_area_deg2;
    observer.eyes = eyes;
    if (const auto distance_m = number_from(focus)) {
        observer.focus = FocusMode::Distance;
        observer.focus_distance_m = *distance_m;
    } else if (py::isinstance<py::str>(focus)) {
        observer.focus =
            named<FocusMode>("focus", focus.cast<std::string>(),
                             {{"relaxed", FocusMode::Relaxed}, {"center", FocusMode::Center}});
    } else {
        throw std::invalid_argument("focus is " + text_of(focus) +
                                    "; expected 'relaxed', 'center' or a number of metres");
    }
    return observer;
}

std::string observer_text(const Observer& observer)
{
    std::string text =
        "Observer(model='" + std::string(to_string(observer.eye.model)) + "', rx='" +
        format_prescription(observer.eye.rx) + "', age_years=" + number_text(observer.age_years) +
        ", pupil=" + (observer.pupil_mm ? number_text(*observer.pupil_mm) : "'auto'") + ", focus=";
    text += observer.focus == FocusMode::Distance
                ? number_text(observer.focus_distance_m)
                : "'" + std::string(to_string(observer.focus)) + "'";
    if (observer.eye.correction != Correction::None) {
        text += ", correction='" + std::string(to_string(observer.eye.correction)) + "'";
    }
    if (observer.eye.worn) {
        text += ", worn='" + format_prescription(*observer.eye.worn) + "'";
    }
    if (observer.eye.wavefront) {
        text += ", wavefront=" + py::repr(py::cast(*observer.eye.wavefront)).cast<std::string>();
    }
    return text + ")";
}

}  // namespace

void bind_observer(py::module_& m)
{
    using namespace py::literals;

    const Observer usual;
    py::class_<Observer> observer(m, "Observer", "Who looks: prescription, pupil, focus, age.");
    define_init(
        observer, &make_observer,
        std::tuple_cat(
            std::make_tuple(py::kw_only()), refraction_keywords(),
            std::make_tuple("age_years"_a = usual.age_years, "pupil"_a = "auto",
                            "pupil_formula"_a = std::string(to_string(usual.pupil_formula)),
                            "cd_m2_per_unit"_a = usual.cd_m2_per_unit,
                            "luminance_sigma"_a = usual.luminance_sigma,
                            "field_area_deg2"_a = py::none(), "eyes"_a = usual.eyes,
                            "focus"_a = "relaxed"),
            eye_keywords(),
            std::make_tuple(
                "amplitude_formula"_a = std::string(to_string(usual.amplitude_formula)),
                "pupil: 'auto' or mm. field_area_deg2: what an automatic pupil adapts to, None "
                "for\n"
                "the picture's; eyes: how many see it. focus: 'relaxed', 'center' or metres.\n"
                "correction: 'none', 'glasses' or 'contacts', made to `worn`, by default the "
                "eye's "
                "own\n"
                "prescription. wavefront: what the model of that name needs. refraction_zero,\n"
                "exact_trace: for the schematic eyes.")));
    observer.def("__repr__", &observer_text);
}

}  // namespace eye_render
