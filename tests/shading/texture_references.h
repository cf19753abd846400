// The tables of tests/tools/texture_references.py: what Blender's own nodes answer.

#pragma once

#include "shading/node.h"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace eye_render::test {

// By Blender's identifiers. A number fills all three components, as a node's number may.
struct ReferenceRow {
    int line = 0;  // of the file, from 1
    std::map<std::string, NodeOptions::Value> options;
    std::map<std::string, NodeValue> inputs;
    std::map<std::string, NodeValue> outputs;  // those that the node has with these options
};

[[nodiscard]] inline std::vector<std::string> split(const std::string& text, char separator)
{
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) {
        parts.push_back(part);
    }
    if (!text.empty() && text.back() == separator) {
        parts.emplace_back();
    }
    return parts;
}

[[nodiscard]] inline NodeValue node_value(const std::string& cell)
{
    const std::vector<std::string> numbers = split(cell, ' ');
    if (numbers.size() == 1) {
        return NodeValue(std::stof(numbers[0]));
    }
    return {std::stof(numbers.at(0)), std::stof(numbers.at(1)), std::stof(numbers.at(2))};
}

[[nodiscard]] inline NodeOptions::Value option_value(const std::string& cell)
{
    std::size_t used = 0;
    try {
        const double number = std::stod(cell, &used);
        if (used == cell.size()) {
            return number;
        }
    } catch (const std::invalid_argument&) {
    }
    return cell;
}

// Of tests/data/nodes/NAME.csv.
[[nodiscard]] inline std::vector<ReferenceRow> reference_table(const std::string& name)
{
    const std::string path = std::string(EYE_TEST_DATA_DIR) + "/nodes/" + name + ".csv";
    std::ifstream file(path);
    std::string text;
    if (!std::getline(file, text)) {
        throw std::runtime_error(path + " cannot be read");
    }
    const std::vector<std::string> columns = split(text, ',');
    std::vector<ReferenceRow> rows;
    for (int line = 2; std::getline(file, text); ++line) {
        const std::vector<std::string> cells = split(text, ',');
        ReferenceRow row;
        row.line = line;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::string& cell = cells.at(i);
            const std::size_t space = columns[i].find(' ');
            const std::string kind = columns[i].substr(0, space);
            const std::string identifier = columns[i].substr(space + 1);
            if (kind == "option") {
                row.options[identifier] = option_value(cell);
            } else if (kind == "in") {
                row.inputs[identifier] = node_value(cell);
            } else if (!cell.empty()) {
                row.outputs[identifier] = node_value(cell);
            }
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace eye_render::test
