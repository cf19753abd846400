// What Cycles of Blender 4.3 made of the converter, vector and colour nodes: the cases of
// tests/data/nodes/converters.json, which tests/tools/converter_references.py writes.

#pragma once

#include "node_json.h"

#include "shading/nodes/node_tables.h"

#include <fstream>

namespace eye_render::test {

inline const Json& references()
{
    static const Json table = [] {
        std::ifstream file(std::string(EYE_TEST_DATA_DIR) + "/nodes/converters.json");
        return Json::parse(file);
    }();
    return table;
}

}  // namespace eye_render::test
