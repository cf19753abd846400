// By least squares on exact rays: first at the reference wavelength, then the change at a few
// others, then a polynomial through those.

#include "eye/aim_map.h"

#include "eye/schematic_rays.h"
#include "optics/chromatic.h"
#include "optics/least_squares.h"

#include <vector>

namespace eye_render {

namespace {

constexpr double pole_nm = 130.0;
constexpr double reference_per_nm = 1.0 / (reference_wavelength_nm - pole_nm);
constexpr double blue_per_nm = 1.0 / (min_wavelength_nm - pole_nm) - reference_per_nm;

// 0 at the reference wavelength, 1 at the shortest visible one, about -1/2 at the longest.
double chromatic_variable(double wavelength_nm)
{
    return (1.0 / (wavelength_nm - pole_nm) - reference_per_nm) / blue_per_nm;
}

double wavelength_of_nm(double chromatic)
{
    return pole_nm + 1.0 / (chromatic * blue_per_nm + reference_per_nm);
}

// Chebyshev's points between the longest and the shortest visible wavelength.
double chromatic_node(std::size_t i)
{
    const double low = chromatic_variable(max_wavelength_nm);
    const double phase = pi * (static_cast<double>(i) + 0.5) / AimMap::chromatic_powers;
    return 0.5 * (1.0 + low) + 0.5 * (1.0 - low) * std::cos(phase);
}

struct AimSample {
    V2d stop_m{0.0};
    V2d chief{0.0};
    V3d retina_m{0.0};
    V2d sines{0.0};  // at the reference wavelength
};

// Reference rays in one half of one meridian and the stop on one side of it: the rest follows by
// symmetry. Nothing when a ray is lost.
std::optional<std::vector<AimSample>> aim_samples(const LensSystem& system,
                                                  double max_stop_m,
                                                  double max_chief_sine)
{
    constexpr std::size_t radii = AimMap::degree + 2;
    constexpr std::size_t angles = AimMap::degree + 2;
    const Indices indices = indices_at(system, reference_wavelength_nm);
    std::vector<AimSample> samples;
    for (std::size_t i = 0; i < radii; ++i) {
        const V2d chief(max_chief_sine * fitting_radius(i, radii), 0.0);
        const TraceResult landed =
            traced_to_retina(system, indices, stop_ray(system, V2d(0.0), chief), system.lens);
        if (landed.fate != TraceFate::Passed) return std::nullopt;
        const V3d& retina_m = landed.ray.origin_m;
        for (std::size_t j = 0; j < radii; ++j) {
            for (std::size_t k = 0; k < angles; ++k) {
                const V2d stop_m =
                    fitting_point(max_stop_m * fitting_radius(j, radii), pi, k, angles);
                const Sought sines = sines_to_retina(system, indices, stop_m, retina_m, chief);
                if (sines.fate != TraceFate::Passed) return std::nullopt;
                samples.push_back({stop_m, chief, retina_m, sines.value});
            }
        }
    }
    return samples;
}

// P and Q, term by term in turn, such that P s + Q c is closest to the values (x and y in turn).
template <std::size_t Degree>
std::vector<double> fitted_terms(const std::vector<AimSample>& samples,
                                 double per_stop,
                                 double per_chief,
                                 std::vector<double> values)
{
    constexpr std::size_t unknowns = 2 * monomials_of_three(Degree);
    std::vector<double> rows;
    rows.reserve(values.size() * unknowns);
    for (const AimSample& sample : samples) {
        const V2d s = sample.stop_m * per_stop;
        const V2d c = sample.chief * per_chief;
        const auto m = monomials<Degree>(c.length2(), s.dot(c), s.length2());
        for (const int axis : {0, 1}) {
            for (const double monomial : m) {
                rows.push_back(s[axis] * monomial);
                rows.push_back(c[axis] * monomial);
            }
        }
    }
    return least_squares(unknowns, std::move(rows), std::move(values));
}

}  // namespace

std::optional<AimMap> AimMap::fitted(const LensSystem& system,
                                     double max_stop_m,
                                     double max_chief_sine)
{
    const auto samples = aim_samples(system, max_stop_m, max_chief_sine);
    if (!samples) return std::nullopt;
    AimMap map;
    map.per_stop_ = 1.0 / max_stop_m;
    map.per_chief_ = 1.0 / max_chief_sine;

    std::vector<double> values;
    for (const AimSample& sample : *samples) {
        values.push_back(sample.sines.x - sample.chief.x);
        values.push_back(sample.sines.y - sample.chief.y);
    }
    const auto terms = fitted_terms<degree>(*samples, map.per_stop_, map.per_chief_, values);
    for (std::size_t i = 0; i < map.reference_.size(); ++i) {
        map.reference_[i] = {terms[2 * i], terms[2 * i + 1]};
    }

    // The change at each node, over the chromatic variable, because it is 0 at the reference.
    std::array<std::vector<double>, chromatic_powers> changes;
    for (std::size_t node = 0; node < chromatic_powers; ++node) {
        const double chromatic = chromatic_node(node);
        const Indices indices = indices_at(system, wavelength_of_nm(chromatic));
        values.clear();
        for (const AimSample& sample : *samples) {
            const Sought sines =
                sines_to_retina(system, indices, sample.stop_m, sample.retina_m, sample.chief);
            if (sines.fate != TraceFate::Passed) return std::nullopt;
            values.push_back((sines.value.x - sample.sines.x) / chromatic);
            values.push_back((sines.value.y - sample.sines.y) / chromatic);
        }
        changes[node] =
            fitted_terms<chromatic_degree>(*samples, map.per_stop_, map.per_chief_, values);
    }
    std::vector<double> powers;
    for (std::size_t node = 0; node < chromatic_powers; ++node) {
        for (std::size_t power = 0; power < chromatic_powers; ++power) {
            powers.push_back(std::pow(chromatic_node(node), static_cast<double>(power)));
        }
    }
    const auto through_nodes = [&](std::size_t unknown) {
        std::vector<double> at_nodes(chromatic_powers);
        for (std::size_t node = 0; node < chromatic_powers; ++node) {
            at_nodes[node] = changes[node][unknown];
        }
        return least_squares(chromatic_powers, powers, std::move(at_nodes));
    };
    for (std::size_t i = 0; i < map.chromatic_.size(); ++i) {
        const auto p = through_nodes(2 * i);
        const auto q = through_nodes(2 * i + 1);
        for (std::size_t j = 0; j < chromatic_powers; ++j) map.chromatic_[i][j] = {p[j], q[j]};
    }
    return map;
}

V2d AimMap::operator()(const V2d& stop_point_m, const V2d& chief, double wavelength_nm) const
{
    const V2d s = stop_point_m * per_stop_;
    const V2d c = chief * per_chief_;
    const auto m = monomials<degree>(c.length2(), s.dot(c), s.length2());
    double p = 0.0;
    double q = 0.0;
    for (std::size_t i = 0; i < reference_.size(); ++i) {
        p += reference_[i].p * m[i];
        q += reference_[i].q * m[i];
    }
    if (wavelength_nm != reference_wavelength_nm) {
        const double chromatic = chromatic_variable(wavelength_nm);
        std::array<double, chromatic_powers> powers{chromatic};
        for (std::size_t j = 1; j < chromatic_powers; ++j) powers[j] = powers[j - 1] * chromatic;
        for (std::size_t i = 0; i < chromatic_.size(); ++i) {
            for (std::size_t j = 0; j < chromatic_powers; ++j) {
                const double weight = powers[j] * m[i];
                p += chromatic_[i][j].p * weight;
                q += chromatic_[i][j].q * weight;
            }
        }
    }
    return chief + s * p + c * q;
}

}  // namespace eye_render
