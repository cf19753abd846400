// What the files of the module share: one binding function a concept, and conversions of arrays.

#pragma once

#include "api/scene_builder.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace eye_render {

namespace py = pybind11;

void bind_prescription(py::module_& m);
void bind_wavefront(py::module_& m);
void bind_eye(py::module_& m);
void bind_nodes(py::module_& m);
void bind_scene(py::module_& m);  // after bind_nodes
void bind_observer(py::module_& m);
void bind_settings(py::module_& m);
void bind_render(py::module_& m);    // after those of what a session is made of
void bind_analysis(py::module_& m);  // after bind_eye and bind_observer, whose classes it uses

// Arrays of any layout and number type are taken; C order of the wanted type costs no copy.
template <typename T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

[[nodiscard]] inline std::string shape_text(const py::array& array)
{
    std::string text = "(";
    for (py::ssize_t i = 0; i < array.ndim(); ++i) {
        text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
    }
    return text + ")";
}

// The rows of an (n, columns) array as a vector of T, T being `columns` numbers in a row.
template <typename T, typename Number>
[[nodiscard]] std::vector<T> rows(const Array<Number>& array, const std::string& name)
{
    constexpr std::size_t columns = sizeof(T) / sizeof(Number);
    static_assert(columns * sizeof(Number) == sizeof(T));
    // An empty array may have lost its second dimension.
    if (array.size() == 0) {
        return {};
    }
    if (array.ndim() != 2 || array.shape(1) != static_cast<py::ssize_t>(columns)) {
        throw std::invalid_argument(name + " has shape " + shape_text(array) + "; expected (n, " +
                                    std::to_string(columns) + ")");
    }
    std::vector<T> result(static_cast<std::size_t>(array.shape(0)));
    std::memcpy(static_cast<void*>(result.data()), array.data(), result.size() * sizeof(T));
    return result;
}

// A (4, 4) matrix for column vectors, as Blender and NumPy write it, for Imath's row vectors.
[[nodiscard]] inline M44d matrix_from(const double* numbers)
{
    M44d matrix;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            matrix[j][i] = numbers[4 * i + j];
        }
    }
    return matrix;
}

[[nodiscard]] inline M44d matrix_from(const Array<double>& array, const std::string& name)
{
    if (array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4) {
        throw std::invalid_argument(name + " has shape " + shape_text(array) +
                                    "; expected (4, 4)");
    }
    return matrix_from(array.data());
}

[[nodiscard]] inline std::string text_of(const py::handle& value)
{
    return py::repr(value).cast<std::string>();
}

// A Python or NumPy number; nothing for anything else, texts and arrays included.
[[nodiscard]] inline std::optional<double> number_from(const py::handle& value)
{
    if (PySequence_Check(value.ptr()) != 0 || !py::hasattr(value, "__float__")) {
        return std::nullopt;
    }
    return py::float_(py::reinterpret_borrow<py::object>(value)).cast<double>();
}

// The value that belongs to a name, or an error that lists the names.
template <typename T>
[[nodiscard]] T named(const std::string& what,
                      const std::string& name,
                      std::initializer_list<std::pair<const char*, T>> values)
{
    std::string names;
    for (const auto& [candidate, value] : values) {
        if (name == candidate) {
            return value;
        }
        names += (names.empty() ? "" : ", ") + std::string(candidate);
    }
    throw std::invalid_argument(what + " is '" + name + "'; expected one of " + names);
}

}  // namespace eye_render
