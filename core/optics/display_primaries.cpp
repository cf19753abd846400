// Tables a nanometre apart with straight lines between them, so that density, cumulative density
// and its inverse belong together exactly.

#include "optics/display_primaries.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eye_render {

namespace {

constexpr std::size_t node_count = 301;

double lobe(double nm, double centre_nm, double left_nm, double right_nm)
{
    const double t = (nm - centre_nm) / (nm < centre_nm ? left_nm : right_nm);
    return std::exp(-0.5 * t * t);
}

V3d cie_xyz(double nm)
{
    return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
                0.065 * lobe(nm, 501.1, 20.4, 26.2),
            0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
            1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

double mean(const V3d& v) { return (v.x + v.y + v.z) / 3.0; }

struct Tables {
    std::array<V3d, node_count> primaries;
    std::array<double, node_count> cumulative;  // of their mean
};

Tables make_tables(WorkingSpace space)
{
    Tables tables;
    for (std::size_t i = 0; i < node_count; ++i) {
        const V3d xyz = cie_xyz(min_display_nm + static_cast<double>(i));
        const Color3f rgb = rgb_from_xyz(V3f(xyz), space);
        tables.primaries[i] = {std::max(0.0f, rgb.x), std::max(0.0f, rgb.y),
                               std::max(0.0f, rgb.z)};
    }
    // Trapezoids are what lies under straight lines.
    V3d total(0.0);
    for (std::size_t i = 1; i < node_count; ++i) {
        total += (tables.primaries[i - 1] + tables.primaries[i]) * 0.5;
    }
    for (V3d& primaries : tables.primaries) {
        primaries = primaries / total;
    }
    tables.cumulative[0] = 0.0;
    for (std::size_t i = 1; i < node_count; ++i) {
        tables.cumulative[i] = tables.cumulative[i - 1] +
                               0.5 * (mean(tables.primaries[i - 1]) + mean(tables.primaries[i]));
    }
    return tables;
}

const Tables& tables(WorkingSpace space)
{
    static const std::array made{make_tables(WorkingSpace::Rec709),
                                 make_tables(WorkingSpace::Rec2020),
                                 make_tables(WorkingSpace::AcesCg)};
    return made[static_cast<std::size_t>(space)];
}

struct Cell {
    std::size_t index;
    double offset;  // 0 to 1
};

// The last node belongs to the last cell.
Cell cell_of(double wavelength_nm)
{
    const double position = wavelength_nm - min_display_nm;
    const auto index = std::min(static_cast<std::size_t>(position), node_count - 2);
    return {index, position - static_cast<double>(index)};
}

bool is_displayed(double wavelength_nm)
{
    return wavelength_nm >= min_display_nm && wavelength_nm <= max_display_nm;
}

}  // namespace

V3d display_primaries(double wavelength_nm, WorkingSpace space)
{
    if (!is_displayed(wavelength_nm)) return V3d(0.0);
    const auto [index, offset] = cell_of(wavelength_nm);
    const auto& nodes = tables(space).primaries;
    return nodes[index] * (1.0 - offset) + nodes[index + 1] * offset;
}

double sample_wavelength_nm(double u, WorkingSpace space)
{
    const auto& cumulative = tables(space).cumulative;
    const auto below =
        std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, u) - cumulative.begin() - 1;
    const auto index = static_cast<std::size_t>(below);
    const double low = mean(tables(space).primaries[index]);
    const double high = mean(tables(space).primaries[index + 1]);
    // Solves low t + (high - low) t^2 / 2 = rest in the form that also holds when low = high.
    const double rest = u - cumulative[index];
    const double root = std::sqrt(std::max(0.0, low * low + 2.0 * (high - low) * rest));
    const double offset = std::clamp(2.0 * rest / (low + root), 0.0, 1.0);
    return min_display_nm + static_cast<double>(index) + offset;
}

double wavelength_pdf(double wavelength_nm, WorkingSpace space)
{
    return mean(display_primaries(wavelength_nm, space));
}

double invert_wavelength(double wavelength_nm, WorkingSpace space)
{
    const auto [index, offset] =
        cell_of(std::clamp(wavelength_nm, min_display_nm, max_display_nm));
    const double low = mean(tables(space).primaries[index]);
    const double high = mean(tables(space).primaries[index + 1]);
    return tables(space).cumulative[index] + offset * (low + 0.5 * (high - low) * offset);
}

}  // namespace eye_render
