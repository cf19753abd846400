// The waves of each cell of a lattice and its neighbours, summed as phasors.

#include "shading/procedural/gabor.h"

#include "shading/procedural/hash.h"
#include "shading/procedural/safe_float.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// As many in every cell; their envelopes end one cell's width away.
constexpr int impulses = 8;

// Of the noise at frequencies above 1: the root of the impulses a cell, times the mean square of
// weights (1/2 in Blender's reckoning), times the integral of the squared kernel, 1/4 in the plane
// and 1/(4 sqrt(2)) in space (Lagae et al. 2009, eq. 9).
constexpr float deviation_2d = 1.0f;
constexpr float deviation_3d = 0.840896415f;

[[nodiscard]] V2f polar(float radius, float angle)
{
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

// A wave as a phasor under a Gaussian, which Hann's window brings to 0 at distance 1.
template <int D>
[[nodiscard]] V2f kernel(const Point<D>& p, const Point<D>& wave)
{
    const float distance2 = dot(p, p);
    const float window = 0.5f + 0.5f * std::cos(pi * distance2);
    return polar(std::exp(-pi * distance2) * window, 2.0f * pi * dot(p, wave));
}

// Independent random numbers of one impulse.
enum class Draw { Wave, Center, Weight };

template <int D>
[[nodiscard]] Point<D + 1> seed(const Point<D>& cell, int impulse, Draw draw)
{
    return Point<D + 1>::of_each([&](int axis) {
        return axis < D ? cell[axis] : static_cast<float>(3 * impulse + static_cast<int>(draw));
    });
}

[[nodiscard]] Point<2> random_center(const Point<3>& key)
{
    return {{unit_hash(key[0], key[1], key[2]), unit_hash(key[2], key[0], key[1])}};
}

[[nodiscard]] Point<3> random_center(const Point<4>& key)
{
    const V3f random = random_color(key);
    return {{random.x, random.y, random.z}};
}

// `p` is relative to the cell.
template <int D, typename WaveOf>
[[nodiscard]] V2f noise_of_cell(const Point<D>& cell, const Point<D>& p, const WaveOf& wave_of)
{
    V2f sum(0.0f);
    for (int i = 0; i < impulses; ++i) {
        const Point<D> q = p - random_center(seed(cell, i, Draw::Center));
        if (dot(q, q) < 1.0f) {
            const float weight = random_value(seed(cell, i, Draw::Weight)) < 0.5f ? -1.0f : 1.0f;
            sum += kernel(q, wave_of(seed(cell, i, Draw::Wave))) * weight;
        }
    }
    return sum;
}

// `wave_of` tells frequency and direction by an impulse's seed.
template <int D, typename WaveOf>
[[nodiscard]] V2f noise(const Point<D>& p, const WaveOf& wave_of)
{
    const auto cell = Point<D>::of_each([&](int axis) { return std::floor(p[axis]); });
    const Point<D> local = p - cell;
    constexpr int neighbours = D == 2 ? 9 : 27;
    V2f sum(0.0f);
    for (int n = 0; n < neighbours; ++n) {
        constexpr std::array step{1, 3, 9};
        const auto offset = Point<D>::of_each([&](int axis) {
            return static_cast<float>(n / step[static_cast<std::size_t>(axis)] % 3 - 1);
        });
        sum += noise_of_cell(cell + offset, local - offset, wave_of);
    }
    return sum;
}

[[nodiscard]] GaborAnswer answer_of(const V2f& phasor, float deviation)
{
    // Nearly all of the noise is within six deviations.
    const float most = 6.0f * deviation;
    return {.value = finite(phasor.y / most * 0.5f + 0.5f),
            .phase = finite((std::atan2(phasor.y, phasor.x) + pi) / (2.0f * pi)),
            .intensity = finite(phasor.length() / most)};
}

[[nodiscard]] float isotropy_of(const Gabor& gabor) { return 1.0f - unit_range(gabor.anisotropy); }

[[nodiscard]] float frequency_of(const Gabor& gabor)
{
    constexpr float lowest = 0.001f;
    return std::max(lowest, gabor.frequency);
}

}  // namespace

GaborAnswer gabor_texture(const Point<2>& p, const Gabor& gabor, float direction_rad)
{
    const float isotropy = isotropy_of(gabor);
    const float frequency = frequency_of(gabor);
    // A wave looks the same when turned by half a turn.
    const auto wave_of = [&](const Point<3>& key) {
        const float turned = (random_value(key) - 0.5f) * pi;
        const V2f wave = polar(frequency, direction_rad + turned * isotropy);
        return Point<2>{{wave.x, wave.y}};
    };
    return answer_of(noise(p, wave_of), deviation_2d);
}

GaborAnswer gabor_texture(const Point<3>& p, const Gabor& gabor, const V3f& direction)
{
    const float isotropy = isotropy_of(gabor);
    const float frequency = frequency_of(gabor);
    const V3f unit = unit_or(direction, V3f(0.0f));
    const float inclination = std::acos(unit.z);
    const float azimuth = std::atan2(unit.y, unit.x);
    const auto wave_of = [&](const Point<4>& key) {
        if (isotropy == 0.0f) {
            return Point<3>{{unit.x, unit.y, unit.z}} * frequency;
        }
        const V3f random = random_color(key);
        const float theta = inclination + random.x * pi * isotropy;
        const V2f across = polar(std::sin(theta), azimuth + random.y * pi * isotropy);
        return Point<3>{{across.x, across.y, std::cos(theta)}} * frequency;
    };
    return answer_of(noise(p, wave_of), deviation_3d);
}

}  // namespace eye_render
