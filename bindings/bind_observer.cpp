// eyecore.Observer.

#include "api/observer.h"
#include "eye_options.h"

namespace eye_render {

namespace {

py::object pupil(const Observer& observer)
{
    return observer.pupil_mm ? py::object(py::float_(*observer.pupil_mm)) : py::str("auto");
}

void set_pupil(Observer& observer, const py::object& pupil)
{
    observer.pupil_mm = number_from(pupil);
    if (!observer.pupil_mm && !(py::isinstance<py::str>(pupil) && pupil.equal(py::str("auto")))) {
        throw std::invalid_argument("pupil is " + text_of(pupil) +
                                    "; expected 'auto' or a number of mm");
    }
}

py::object focus(const Observer& observer)
{
    if (observer.focus == FocusMode::Distance) {
        return py::float_(observer.focus_distance_m);
    }
    return py::str(std::string(to_string(observer.focus)));
}

void set_focus(Observer& observer, const py::object& focus)
{
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
    py::class_<Observer> observer(m, "Observer", "Who looks: prescription, pupil, focus, age.");
    observer
        .def(py::init(&options_from<Observer>),
             "Attributes by keyword. What they allow is checked by the Session.")
        .def_readwrite("age_years", &Observer::age_years, "0 to 120.")
        .def_property("pupil", &pupil, &set_pupil, "'auto', or a diameter of 0 to 9 mm.")
        .def_readwrite("cd_m2_per_unit", &Observer::cd_m2_per_unit,
                       "Luminance of radiance 1 in all channels, for an automatic pupil.")
        .def_readwrite("luminance_sigma", &Observer::luminance_sigma,
                       "Of the Gaussian weight of the picture's luminance, in half heights and\n"
                       "widths.")
        .def_readwrite("field_area_deg2", &Observer::field_area_deg2,
                       "What an automatic pupil adapts to; None for the picture's.")
        .def_readwrite("eyes", &Observer::eyes, "That see the light: 1 or 2.")
        .def_property("focus", &focus, &set_focus,
                      "'relaxed', 'center' or metres from the entrance pupil.")
        .def("__repr__", &observer_text);
    define_named_option(
        observer, "amplitude_formula", [](auto& o) -> auto& { return o.amplitude_formula; },
        amplitude_formulas, "Of accommodation: one of AMPLITUDE_FORMULAS.");
    define_named_option(
        observer, "pupil_formula", [](auto& o) -> auto& { return o.pupil_formula; },
        pupil_formulas, "One of PUPIL_FORMULAS.");
    define_eye_options(
        observer, [](auto& o) -> auto& { return o.eye; });
}

}  // namespace eye_render
