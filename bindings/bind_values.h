// Names and prescriptions as Python says them.

#pragma once

#include "api/eye.h"
#include "module.h"

#include <string>
#include <tuple>

namespace eye_render {

// The names of a table of enumerators that have to_string.
template <typename Table>
[[nodiscard]] py::list names_of(const Table& table)
{
    py::list names;
    for (const auto entry : table) {
        names.append(std::string(to_string(entry)));
    }
    return names;
}

// The enumerator with that name, or an error that lists the names.
template <typename Table>
[[nodiscard]] typename Table::value_type named_of(const std::string& what,
                                                  const std::string& name,
                                                  const Table& table)
{
    std::string names;
    for (const auto entry : table) {
        if (to_string(entry) == name) {
            return entry;
        }
        names += (names.empty() ? "" : ", ") + std::string(to_string(entry));
    }
    throw std::invalid_argument(what + " is '" + name + "'; expected one of " + names);
}

// A Prescription, or a text to be parsed.
[[nodiscard]] inline Prescription prescription_from_python(const py::object& rx)
{
    if (py::isinstance<Prescription>(rx)) {
        return rx.cast<Prescription>();
    }
    if (!py::isinstance<py::str>(rx)) {
        throw std::invalid_argument("rx is " + text_of(rx) +
                                    "; expected a Prescription or a text such as '-2.00DS'");
    }
    return parse_prescription(rx.cast<std::string>());
}

// The keywords of what Eye and Observer are both told of an eye, in the order of eye_from_python:
// the refraction, and after what only one of them is told, the rest.
[[nodiscard]] inline auto refraction_keywords()
{
    using namespace py::literals;
    return std::make_tuple("model"_a = "paraxial", "rx"_a = "plano", "rx_plane"_a = "spectacle",
                           "vertex_mm"_a = EyeDescription{}.vertex_mm);
}

[[nodiscard]] inline auto eye_keywords()
{
    using namespace py::literals;
    return std::make_tuple("correction"_a = "none", "worn"_a = py::none(), "near_part"_a = false,
                           "wavefront"_a = py::none(), "refraction_zero"_a = "paraxial",
                           "exact_trace"_a = false);
}

// Defines the constructor `make` with keywords and text from a tuple.
template <typename Class, typename Make, typename Keywords>
void define_init(Class& target, const Make& make, const Keywords& keywords)
{
    std::apply([&](const auto&... keyword) { target.def(py::init(make), keyword...); }, keywords);
}

[[nodiscard]] inline EyeDescription eye_from_python(const std::string& model,
                                                    const py::object& rx,
                                                    const std::string& rx_plane,
                                                    double vertex_mm,
                                                    const std::string& correction,
                                                    const py::object& worn,
                                                    bool near_part,
                                                    const std::optional<Wavefront>& wavefront,
                                                    const std::string& refraction_zero,
                                                    bool exact_trace)
{
    EyeDescription eye{.model = named_of("model", model, eye_model_kinds),
                       .rx = prescription_from_python(rx),
                       .rx_plane = named_of("rx_plane", rx_plane, rx_planes),
                       .vertex_mm = vertex_mm,
                       .correction = named_of("correction", correction, corrections),
                       .near_part = near_part,
                       .refraction_zero =
                           named_of("refraction_zero", refraction_zero, refraction_zeros),
                       .exact_trace = exact_trace,
                       .wavefront = wavefront};
    if (!worn.is_none()) {
        eye.worn = prescription_from_python(worn);
    }
    return eye;
}

}  // namespace eye_render
