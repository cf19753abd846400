#include "render/pixel_means.h"

#include <algorithm>

namespace eye_render {

namespace {

constexpr std::size_t alpha = 3;

}  // namespace

void PixelMeans::write(const PassRequest& request, std::span<float> channels) const
{
    if (layout_.passes.catcher() && request.pass == Pass::Combined) {
        const CaughtLight light = caught();
        const auto rgba = layout_.shadow == CaughtShadow::Apart         ? without_shadow(light)
                          : layout_.shadow == CaughtShadow::OverNothing ? over_nothing(light)
                                                                        : over_world(light);
        for (std::size_t channel = 0; channel < channels.size(); ++channel) {
            channels[channel] = static_cast<float>(rgba[channel]);
        }
        return;
    }
    for (std::size_t channel = 0; channel < channels.size(); ++channel) {
        channels[channel] = static_cast<float>(value(request, channel));
    }
}

double PixelMeans::value(const PassRequest& request, std::size_t channel) const
{
    switch (request.pass) {
    case Pass::SampleWeight: return sample_weight(channel);
    case Pass::Combined: return combined(channel);
    case Pass::ShadowCatcher:
        return layout_.passes.catcher() ? catcher_factor(caught())[static_cast<int>(channel)]
                                        : 1.0;
    default: break;
    }
    const std::optional<Pass> color = info(request.pass).divisor;
    return mean(request, channel) / (color ? divisor(mean(*color, channel)) : 1.0);
}

double PixelMeans::mean(const PassRequest& request, std::size_t channel) const
{
    const std::size_t sum = FilmLayout::pass_sums + layout_.passes.first(request) + channel;
    const bool is_light = info(request.pass).source == PassSource::Light;
    return is_light ? light(sum, channel) : sums_[sum] / weight();
}

double PixelMeans::light(std::size_t sum, std::size_t channel) const
{
    return layout_.light_scale() * sums_[sum] / divisor(sample_weight(channel));
}

double PixelMeans::sample_weight(std::size_t channel) const
{
    return sums_[channel < alpha ? layout_.weight_of_light(channel) : FilmLayout::weight];
}

double PixelMeans::combined(std::size_t channel) const
{
    const std::size_t sum = FilmLayout::combined + channel;
    return channel < alpha ? light(sum, channel) : coverage(sum);
}

// Noise may take the mean of few paths out of its range.
double PixelMeans::coverage(std::size_t sum) const
{
    return std::clamp(sums_[sum] / weight(), 0.0, 1.0);
}

CaughtLight PixelMeans::caught() const
{
    const CatcherChannels& catcher = *layout_.passes.catcher();
    const auto color = [&](std::size_t first) {
        return V3d(light(first, 0), light(first + 1, 1), light(first + 2, 2));
    };
    return {.all = color(FilmLayout::combined),
            .matte = color(FilmLayout::pass_sums + catcher.matte),
            .bare = color(FilmLayout::pass_sums + catcher.bare),
            .behind = color(FilmLayout::pass_sums + catcher.behind),
            .alpha = combined(alpha),
            .matte_alpha = coverage(FilmLayout::pass_sums + catcher.matte_alpha)};
}

}  // namespace eye_render
