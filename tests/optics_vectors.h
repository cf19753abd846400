// The published and derived numbers of tests/data/optics_vectors.json, by kind of case. Each was
// computed by two independent routes; the file's head states the conventions.

#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace eye_render::test {

using Json = nlohmann::json;

inline const Json& optics_vectors()
{
    static const Json vectors = [] {
        std::ifstream file(std::string(EYE_TEST_DATA_DIR) + "/optics_vectors.json");
        return Json::parse(file);
    }();
    return vectors;
}

// Never empty: a renamed kind must not pass by testing nothing.
inline std::vector<Json> vectors_of_kind(const std::string& kind)
{
    std::vector<Json> result;
    for (const Json& vector : optics_vectors()["cases"]) {
        if (vector["kind"] == kind) {
            result.push_back(vector);
        }
    }
    EXPECT_FALSE(result.empty()) << "no vectors of kind " << kind;
    return result;
}

// What the file promises, relative for large values, absolute below 1 (dioptres, arcmin, mm).
inline void expect_vector_value(double actual, const Json& expected)
{
    const double tolerance = optics_vectors()["tolerance_rel"].get<double>();
    const double value = expected.get<double>();
    EXPECT_NEAR(actual, value, tolerance * std::max(1.0, std::abs(value)));
}

// Axes and orientations repeat after 180 degrees.
inline void expect_same_axis(double actual_deg, double expected_deg)
{
    EXPECT_NEAR(std::remainder(actual_deg - expected_deg, 180.0), 0.0, 1e-9)
        << "axes " << actual_deg << " and " << expected_deg;
}

}  // namespace eye_render::test

#define EYE_TRACE_VECTOR(vector)                                                                  \
    SCOPED_TRACE((vector)["id"].get<std::string>() + " " + (vector)["input"].dump())
