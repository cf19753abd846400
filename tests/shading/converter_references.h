// What Cycles of Blender 4.3 made of the converter, vector and colour nodes: the cases of
// tests/data/nodes/converters.json, which tests/tools/converter_references.py writes.

#pragma once

#include "node_trial.h"

#include "shading/nodes/node_tables.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace eye_render::test {

using Json = nlohmann::json;

inline const Json& references()
{
    static const Json table = [] {
        std::ifstream file(std::string(EYE_TEST_DATA_DIR) + "/nodes/converters.json");
        return Json::parse(file);
    }();
    return table;
}

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

inline const NodeType* converter_named(const std::string& name)
{
    for (const auto& family : {math_nodes(), color_nodes()}) {
        for (const NodeType& type : family) {
            if (type.name == name) {
                return &type;
            }
        }
    }
    return nullptr;
}

}  // namespace eye_render::test
