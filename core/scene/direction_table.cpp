#include "scene/direction_table.h"

#include "base/warp.h"
#include "shading/picture_coordinates.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr float pi_f = std::numbers::pi_v<float>;

// Share of the samples that go uniformly over the sphere: what the table rounds to nothing (a
// dim sky beside a sun 10^8 times brighter) keeps a density, and weights stay bounded.
constexpr float uniform_share = 0.05f;

// Sine of the latitude at the lower edge of a row of the table.
float row_edge_z(int row, int rows)
{
    return std::sin(pi_f * (static_cast<float>(row) / static_cast<float>(rows) - 0.5f));
}

// Turns weights into probabilities that add up: cdf[0] = 0, cdf[n] = 1. Returns the sum.
double accumulate(const float* weights, int n, float* cdf)
{
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        sum += static_cast<double>(weights[i]);
    }
    double running = 0.0;
    for (int i = 0; i < n; ++i) {
        cdf[i] = sum > 0.0 ? static_cast<float>(running / sum)
                           : static_cast<float>(i) / static_cast<float>(n);
        running += static_cast<double>(weights[i]);
    }
    cdf[n] = 1.0f;
    return sum;
}

struct Cell {
    int index = 0;
    float probability = 0.0f;
    float offset = 0.0f;  // of u within the cell, 0 to 1
};

Cell find_cell(const float* cdf, int n, float u)
{
    const float* above = std::upper_bound(cdf + 1, cdf + n, u);
    const int index = static_cast<int>(above - cdf) - 1;
    const float probability = cdf[index + 1] - cdf[index];
    const float offset = probability > 0.0f ? (u - cdf[index]) / probability : 0.5f;
    return {index, probability, std::clamp(offset, 0.0f, 1.0f)};
}

}  // namespace

DirectionTable::DirectionTable(int width,
                               int looks,
                               const std::function<float(const V3f&)>& luminance)
{
    const int height = width / 2;
    const auto at = [width](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    };
    std::vector<float> luminances(at(0, height));
    const auto for_rows = [height](const auto& work) {
        tbb::parallel_for(tbb::blocked_range<int>(0, height, 16), [&](const auto& rows) {
            for (int y = rows.begin(); y != rows.end(); ++y) {
                work(y);
            }
        });
    };
    for_rows([&](int y) {
        for (int x = 0; x < width; ++x) {
            float sum = 0.0f;
            for (int look = 0; look < looks * looks; ++look) {
                const auto part = [looks](int cell, int step) {
                    return static_cast<float>(cell) +
                           (static_cast<float>(step) + 0.5f) / static_cast<float>(looks);
                };
                const float turn = part(x, look % looks) / static_cast<float>(width);
                const float tilt = part(y, look / looks) / static_cast<float>(height);
                const float latitude = pi_f * (tilt - 0.5f);
                const float longitude = pi_f * (1.0f - 2.0f * turn);
                sum += luminance({std::cos(latitude) * std::cos(longitude),
                                  std::cos(latitude) * std::sin(longitude), std::sin(latitude)});
            }
            luminances[at(x, y)] = sum / static_cast<float>(looks * looks);
        }
    });
    // Pictures are interpolated: what is dark at its middle may shine at its edge, so a cell gets
    // a part of its neighbours. It costs a little noise, but leaves no cell dark where a lookup
    // finds light.
    const auto spread_luminance = [&](int x, int y) {
        const auto weight = [](int offset) { return offset == 0 ? 0.75f : 0.125f; };
        float sum = 0.0f;
        for (int j = -1; j <= 1; ++j) {
            const int row = std::clamp(y + j, 0, height - 1);
            for (int i = -1; i <= 1; ++i) {
                sum += weight(i) * weight(j) * luminances[at((x + i + width) % width, row)];
            }
        }
        return sum;
    };

    const auto stride = static_cast<std::size_t>(width) + 1;
    cell_cdf_.resize(stride * static_cast<std::size_t>(height));
    row_cdf_.resize(static_cast<std::size_t>(height) + 1);
    std::vector<float> row_weights(static_cast<std::size_t>(height));
    for_rows([&](int y) {
        std::vector<float> weights(static_cast<std::size_t>(width));
        for (int x = 0; x < width; ++x) {
            weights[static_cast<std::size_t>(x)] = spread_luminance(x, y);
        }
        const double sum =
            accumulate(weights.data(), width, &cell_cdf_[stride * static_cast<std::size_t>(y)]);
        const float solid_angle = 2.0f * pi_f / static_cast<float>(width) *
                                  (row_edge_z(y + 1, height) - row_edge_z(y, height));
        row_weights[static_cast<std::size_t>(y)] = static_cast<float>(sum) * solid_angle;
    });
    const double total = accumulate(row_weights.data(), height, row_cdf_.data());
    mean_luminance_ = static_cast<float>(total) / (4.0f * pi_f);
    width_ = width;
    height_ = height;
}

DirectionTable::Sample DirectionTable::sample(const V2f& u) const
{
    if (u.x < uniform_share) {
        const V3f wi = sample_uniform_sphere({u.x / uniform_share, u.y});
        return {wi, pdf(wi)};
    }
    const float ux = (u.x - uniform_share) / (1.0f - uniform_share);
    const auto stride = static_cast<std::size_t>(width_) + 1;
    const Cell row = find_cell(row_cdf_.data(), height_, u.y);
    const float* cells = &cell_cdf_[stride * static_cast<std::size_t>(row.index)];
    const Cell cell = find_cell(cells, width_, ux);
    // Uniform within the cell by solid angle: in longitude and in the sine of latitude.
    const float z0 = row_edge_z(row.index, height_);
    const float z1 = row_edge_z(row.index + 1, height_);
    const float z = z0 + row.offset * (z1 - z0);
    const float across = std::sqrt(std::max(0.0f, 1.0f - z * z));
    const float turn = (static_cast<float>(cell.index) + cell.offset) / static_cast<float>(width_);
    const float phi = pi_f * (1.0f - 2.0f * turn);
    const V3f wi(across * std::cos(phi), across * std::sin(phi), z);
    // The density of the chosen cell, not of the one that wi may be rounded into: beside the sun
    // the next cell's can be 10^5 times smaller.
    return {wi, density(row.probability * cell.probability, z1 - z0)};
}

// Density per unit solid angle in a cell between two latitudes.
float DirectionTable::density(float cell_probability, float z_extent) const
{
    const float solid_angle = 2.0f * pi_f / static_cast<float>(width_) * z_extent;
    return uniform_share * uniform_sphere_pdf() +
           (1.0f - uniform_share) * cell_probability / solid_angle;
}

float DirectionTable::pdf(const V3f& direction) const
{
    const V2f uv = uv_equirectangular(direction);
    const auto cell_index = [](float x, int n) {
        return std::clamp(static_cast<int>(x * static_cast<float>(n)), 0, n - 1);
    };
    const int x = cell_index(uv.x, width_);
    const int y = cell_index(uv.y, height_);
    const auto row = static_cast<std::size_t>(y);
    const float* cells = &cell_cdf_[(static_cast<std::size_t>(width_) + 1) * row];
    const float probability = (row_cdf_[row + 1] - row_cdf_[row]) * (cells[x + 1] - cells[x]);
    return density(probability, row_edge_z(y + 1, height_) - row_edge_z(y, height_));
}

}  // namespace eye_render
