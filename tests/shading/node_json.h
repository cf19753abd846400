// Values and options of nodes as the tables of references write them.

#pragma once

#include "node_trial.h"

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace eye_render::test {

using Json = nlohmann::json;

// Infinities and what is not a number are texts.
inline float number_of(const Json& value)
{
    return value.is_string() ? std::strtof(value.get<std::string>().c_str(), nullptr)
                             : value.get<float>();
}

inline NodeValue value_of(const Json& value)
{
    return value.is_array()
               ? NodeValue(number_of(value[0]), number_of(value[1]), number_of(value[2]))
               : NodeValue(number_of(value));
}

inline Options options_of(const Json& json)
{
    Options options;
    for (const auto& [name, value] : json.items()) {
        if (value.is_string()) {
            options[name] = value.get<std::string>();
        } else if (value.is_array()) {
            options[name] = value.get<std::vector<float>>();
        } else {
            options[name] = value.is_boolean() ? double(value.get<bool>()) : value.get<double>();
        }
    }
    return options;
}

}  // namespace eye_render::test
