// What the film keeps for a pixel: only what some pass of the plan needs is allocated. And what
// becomes of light that the eye loses.

#pragma once

#include "render/pass_layout.h"

#include <optional>

namespace eye_render {

// How a picture shows the shadows on shadow catchers.
enum class CaughtShadow { OverWorld, OverNothing, Apart };

struct FilmLayout {
    PassLayout passes{};
    bool chromatic = false;
    CaughtShadow shadow = CaughtShadow::OverWorld;
    // Nothing: the picture keeps its brightness, as seeing does; lost rays are counted and left
    // out of the means. A number: what part of the light counts; the picture darkens to it, and
    // by the lost rays, which are black.
    std::optional<double> efficiency{};
    double exposure = 1.0;  // a factor of all light in the picture

    // What the means of light are multiplied by.
    [[nodiscard]] double light_scale() const { return exposure * efficiency.value_or(1.0); }

    // Sums of a pixel: weight, RGB, alpha, the channels of the passes, and with a chromatic film
    // the channels' weights.
    static constexpr std::size_t weight = 0;
    static constexpr std::size_t combined = 1;
    static constexpr std::size_t pass_sums = 5;
    [[nodiscard]] std::size_t channel_weights() const { return pass_sums + passes.channels(); }
    [[nodiscard]] std::size_t stride() const { return channel_weights() + (chromatic ? 3 : 0); }

    // Where the sum of the weights stands that went into a channel of light.
    [[nodiscard]] std::size_t weight_of_light(std::size_t channel) const
    {
        return chromatic ? channel_weights() + channel : weight;
    }
};

}  // namespace eye_render
