// A fitted map of a disk by something with two planes of symmetry, as a toric cornea has in its
// own meridians: x' = x P(x^2, y^2), y' = y Q(x^2, y^2) with polynomials P and Q.

#pragma once

#include "eye/monomials.h"
#include "eye/schematic_rays.h"

#include <functional>
#include <optional>

namespace eye_render {

class SymmetricMap {
public:
    static constexpr std::size_t degree = 6;  // of P and Q

    // To a function on the disk of this radius (above 0) around 0. Nothing when a ray is lost
    // there.
    [[nodiscard]] static std::optional<SymmetricMap> fitted(
        const std::function<Sought(const V2d&)>& function,
        double radius);

    [[nodiscard]] V2d operator()(const V2d& point) const
    {
        const V2d p = point * per_radius_;
        const auto m = monomials<degree>(p.x * p.x, p.y * p.y);
        V2d sum(0.0);
        for (std::size_t i = 0; i < m.size(); ++i) sum += coefficients_[i] * m[i];
        return p * sum;
    }

private:
    double per_radius_ = 1.0;
    std::array<V2d, monomials_of_two(degree)> coefficients_{};  // of P and Q
};

}  // namespace eye_render
