#include "shading/procedural/magic.h"

#include "shading/procedural/safe_float.h"

#include <array>
#include <cmath>
#include <numbers>

namespace eye_render {
namespace {

enum class Function { Sine, Cosine };

// One fold: the channel becomes sign * function(signs . channels) * distortion.
struct Fold {
    int channel;
    float sign;
    Function function;
    V3f signs;
};

const std::array<Fold, 10> folds{{
    {1, -1.0f, Function::Cosine, {1.0f, -1.0f, 1.0f}},
    {0, 1.0f, Function::Cosine, {1.0f, -1.0f, -1.0f}},
    {2, 1.0f, Function::Sine, {-1.0f, -1.0f, -1.0f}},
    {0, -1.0f, Function::Cosine, {-1.0f, 1.0f, -1.0f}},
    {1, -1.0f, Function::Sine, {-1.0f, 1.0f, 1.0f}},
    {1, -1.0f, Function::Cosine, {-1.0f, 1.0f, 1.0f}},
    {0, 1.0f, Function::Cosine, {1.0f, 1.0f, 1.0f}},
    {2, 1.0f, Function::Sine, {1.0f, 1.0f, -1.0f}},
    {0, -1.0f, Function::Cosine, {-1.0f, -1.0f, 1.0f}},
    {1, -1.0f, Function::Sine, {1.0f, -1.0f, 1.0f}},
}};

// As Cycles does it, before scaling: it repeats the texture unless the scale is whole.
[[nodiscard]] float repeated(float x)
{
    return std::fmod(finite(x), 2.0f * std::numbers::pi_v<float>);
}

}  // namespace

Color3f magic_texture(const V3f& p, float scale, int depth, float distortion)
{
    const V3f place(repeated(p.x), repeated(p.y), repeated(p.z));
    const float x = std::sin((place.x + place.y + place.z) * 5.0f * scale);
    const float y = std::cos((-place.x + place.y - place.z) * 5.0f * scale);
    const float z = -std::cos((-place.x - place.y + place.z) * 5.0f * scale);
    V3f channels(x, y, z);
    if (depth > 0) {
        channels *= distortion;
    }
    for (int i = 0; i < depth && i < static_cast<int>(folds.size()); ++i) {
        const Fold& fold = folds[static_cast<std::size_t>(i)];
        const float phase =
            fold.signs.x * channels.x + fold.signs.y * channels.y + fold.signs.z * channels.z;
        const float folded = fold.function == Function::Sine ? std::sin(phase) : std::cos(phase);
        channels[fold.channel] = fold.sign * folded * distortion;
    }
    if (distortion != 0.0f) {
        channels /= 2.0f * distortion;
    }
    return finite(V3f(0.5f) - channels);
}

}  // namespace eye_render
