#include "shading/procedural/noise.h"

#include "shading/procedural/hash.h"
#include "shading/procedural/perlin.h"

#include <algorithm>

namespace eye_render {
namespace {

// Where the noise of each number is found, as Perlin noise itself takes no seed: far enough not to
// look alike, near enough not to lose digits. One for each axis' distortion, and two for green and
// blue.
template <int D>
constexpr auto offsets_of_seeds = [] {
    std::array<Point<D>, D + 2> offsets;
    float seed = 0.0f;
    for (Point<D>& offset : offsets) {
        offset = Point<D>::of_each([seed](int axis) {
            const auto key = static_cast<float>(axis);
            return 100.0f + 100.0f * (D == 1 ? unit_hash(seed) : unit_hash(seed, key));
        });
        seed += 1.0f;
    }
    return offsets;
}();

template <int D>
Point<D> distorted(const Point<D>& p, float distortion)
{
    if (distortion == 0.0f) {
        return p;
    }
    return Point<D>::of_each([&](int axis) {
        const Point<D>& offset = offsets_of_seeds<D>[static_cast<std::size_t>(axis)];
        return p[axis] + perlin_noise(p + offset) * distortion;
    });
}

[[nodiscard]] Fractal with_roughness_not_negative(Fractal fractal)
{
    fractal.roughness = std::max(0.0f, fractal.roughness);
    return fractal;
}

}  // namespace

template <int D>
float noise_value(const Point<D>& p, const Noise& noise)
{
    return fractal_noise(distorted(p, noise.distortion),
                         with_roughness_not_negative(noise.fractal));
}

template <int D>
V3f noise_color(const Point<D>& p, const Noise& noise)
{
    const Fractal fractal = with_roughness_not_negative(noise.fractal);
    const Point<D> place = distorted(p, noise.distortion);
    return {fractal_noise(place, fractal), fractal_noise(place + offsets_of_seeds<D>[D], fractal),
            fractal_noise(place + offsets_of_seeds<D>[D + 1], fractal)};
}

template float noise_value(const Point<1>& p, const Noise& noise);
template float noise_value(const Point<2>& p, const Noise& noise);
template float noise_value(const Point<3>& p, const Noise& noise);
template float noise_value(const Point<4>& p, const Noise& noise);
template V3f noise_color(const Point<1>& p, const Noise& noise);
template V3f noise_color(const Point<2>& p, const Noise& noise);
template V3f noise_color(const Point<3>& p, const Noise& noise);
template V3f noise_color(const Point<4>& p, const Noise& noise);

}  // namespace eye_render
