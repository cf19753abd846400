// Structs of options in Python: each option is an attribute, documented where it is defined, and a
// keyword of the constructor.

#pragma once

#include "bind_values.h"

#include <string>
#include <type_traits>
#include <utility>

namespace eye_render {

// The usual options but for those that the keywords say. Throws TypeError for a keyword that names
// none, and what setting an option throws.
template <typename Options>
[[nodiscard]] Options options_from(const py::kwargs& given)
{
    const py::object options = py::cast(Options{});
    const py::type kind = py::type::of(options);
    for (const auto& [name, value] : given) {
        if (!py::hasattr(kind, name)) {
            throw py::type_error(std::string(py::str(kind.attr("__name__"))) + " has no option '" +
                                 std::string(py::str(name)) + "'");
        }
        py::setattr(options, name, value);
    }
    return options.cast<Options>();
}

// `access` gives a reference to the option of const and of other options.
template <typename Options, typename Access>
void define_option(py::class_<Options>& target,
                   const char* name,
                   const Access& access,
                   const char* text)
{
    using Value = std::remove_cvref_t<decltype(access(std::declval<Options&>()))>;
    target.def_property(
        name, [access](const Options& options) -> Value { return access(options); },
        [access](Options& options, const Value& value) { access(options) = value; }, text);
}

// One of the names in a table of enumerators that have to_string.
template <typename Options, typename Access, typename Table>
void define_named_option(py::class_<Options>& target,
                         const char* name,
                         const Access& access,
                         const Table& table,
                         const char* text)
{
    target.def_property(
        name, [access](const Options& options) { return std::string(to_string(access(options))); },
        [access, name, table](Options& options, const std::string& value) {
            access(options) = named_of(name, value, table);
        },
        text);
}

}  // namespace eye_render
