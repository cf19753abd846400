// The options of a node as they come from outside: Blender's properties of the node, each a text
// (also of an enumerator), a number (also a switch) or a list of numbers (a sampled curve or
// ramp).

#pragma once

#include "base/error.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace eye_render {

class NodeOptions {
public:
    using Value = std::variant<std::string, double, std::vector<float>>;

    NodeOptions() = default;
    explicit NodeOptions(std::map<std::string, Value> values) : values_(std::move(values)) {}

    [[nodiscard]] const std::map<std::string, Value>& values() const { return values_; }

    // Each gives the option's value or, where it is not said, `otherwise`, and throws
    // std::invalid_argument for one of another kind.
    [[nodiscard]] std::string text(const std::string& name, const std::string& otherwise) const
    {
        return get<std::string>(name, otherwise, "a text");
    }
    [[nodiscard]] double number(const std::string& name, double otherwise) const
    {
        return get<double>(name, otherwise, "a number");
    }
    [[nodiscard]] bool is_set(const std::string& name, bool otherwise) const
    {
        return number(name, otherwise ? 1.0 : 0.0) != 0.0;
    }
    [[nodiscard]] std::vector<float> numbers(const std::string& name) const
    {
        return get<std::vector<float>>(name, {}, "a list of numbers");
    }

    // The enumerator of that name; the first row is the default.
    template <typename Enumerator>
    [[nodiscard]] Enumerator choice(
        const std::string& name,
        std::initializer_list<std::pair<const char*, Enumerator>> choices) const
    {
        const std::string given = text(name, choices.begin()->first);
        const auto found = std::ranges::find_if(
            choices, [&](const auto& choice) { return given == choice.first; });
        if (found != choices.end()) {
            return found->second;
        }
        std::string names;
        for (const auto& choice : choices) {
            names += (names.empty() ? "" : ", ") + std::string(choice.first);
        }
        throw std::invalid_argument(name + " is " + given + "; expected one of " + names);
    }

private:
    template <typename T>
    [[nodiscard]] T get(const std::string& name, const T& otherwise, const char* kind) const
    {
        const auto found = values_.find(name);
        if (found == values_.end()) {
            return otherwise;
        }
        if (const T* value = std::get_if<T>(&found->second)) {
            return *value;
        }
        throw std::invalid_argument(name + " is of another kind; expected " + kind);
    }

    std::map<std::string, Value> values_;
};

}  // namespace eye_render
