// Sampling of visible normals; the models are described in the header.

#include "shading/microfacet.h"

#include "base/warp.h"

#include <algorithm>

namespace eye_render {

namespace {

// The slope x at which a share `u` of the visible facets lies below it, for facets of alpha 1 seen
// under an angle of this tangent: their density is exp(-x^2) (1 - x tan), up to where it is zero.
[[nodiscard]] double visible_slope(double u, double tan_theta)
{
    constexpr double steepest = 6.0;  // exp(-36): a double's last digits
    constexpr double tolerance = 1e-7;
    constexpr int most_steps = 40;

    const auto mass_below = [tan_theta](double x) {
        return 1.0 + std::erf(x) + tan_theta * std::numbers::inv_sqrtpi * std::exp(-x * x);
    };
    double low = -steepest;
    double high = tan_theta > 1.0 / steepest ? 1.0 / tan_theta : steepest;
    const double wanted = u * mass_below(high);
    // Newton's steps, or bisection where they leave the interval.
    double x = std::min(0.0, high);
    for (int step = 0; step < most_steps; ++step) {
        const double excess = mass_below(x) - wanted;
        (excess > 0.0 ? high : low) = x;
        const double density =
            2.0 * std::numbers::inv_sqrtpi * std::exp(-x * x) * (1.0 - x * tan_theta);
        double next = x - excess / density;
        if (!(next > low && next < high)) {
            next = 0.5 * (low + high);
        }
        if (std::abs(next - x) < tolerance) {
            return next;
        }
        x = next;
    }
    return x;
}

}  // namespace

V3f sample_visible_normal(const V3f& wo_local, float alpha_x, float alpha_y, const V2f& u)
{
    // In the space where the surface is a hemisphere, mirror directions of a visible hemisphere
    // fill a cap around the pole uniformly.
    const V3f wo_stretched =
        V3f(alpha_x * wo_local.x, alpha_y * wo_local.y, wo_local.z).normalized();
    const V3f mirrored = sample_uniform_cone(u, 1.0f + wo_stretched.z);
    const V3f h = mirrored + wo_stretched;
    const V3f m = V3f(alpha_x * h.x, alpha_y * h.y, std::max(0.0f, h.z));

    // Zero only if the cap's very rim was drawn; any normal does.
    const float length2 = m.length2();
    return length2 > 0.0f ? m / std::sqrt(length2) : V3f(0.0f, 0.0f, 1.0f);
}

V3f sample_visible_beckmann_normal(const V3f& wo_local, float alpha_x, float alpha_y, const V2f& u)
{
    // In the space where the facets have alpha 1, slopes along the view are independent of those
    // across it.
    const V3f wo = V3f(alpha_x * wo_local.x, alpha_y * wo_local.y, wo_local.z);
    const float across = std::hypot(wo.x, wo.y);
    const V2f along = across > 0.0f ? V2f(wo.x, wo.y) / across : V2f(1.0f, 0.0f);
    const auto x = static_cast<float>(
        visible_slope(static_cast<double>(u.x), static_cast<double>(across / wo.z)));
    const auto y = static_cast<float>(visible_slope(static_cast<double>(u.y), 0.0));
    return V3f(-alpha_x * (along.x * x - along.y * y), -alpha_y * (along.y * x + along.x * y),
               1.0f)
        .normalized();
}

}  // namespace eye_render
