// Names and prescriptions as Python says them.

#pragma once

#include "api/eye.h"
#include "module.h"

#include <string>

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

}  // namespace eye_render
