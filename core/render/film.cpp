#include "render/film.h"

#include <algorithm>

namespace eye_render {

namespace {

std::size_t pixel_count(const PixelBounds& bounds)
{
    return static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height());
}

std::size_t pixel_index(const PixelBounds& bounds, int x, int y)
{
    return static_cast<std::size_t>(y - bounds.y0) * static_cast<std::size_t>(bounds.width()) +
           static_cast<std::size_t>(x - bounds.x0);
}

// Where the sums stand within a pixel's stride.
constexpr std::size_t weight_sum = 0;
constexpr std::size_t combined_sums = 1;
constexpr std::size_t pass_sums = 5;

constexpr std::size_t rgba = 4;

void add_weighted(double* sums, const V3f& value, const V3d& weight)
{
    sums[0] += static_cast<double>(value.x) * weight.x;
    sums[1] += static_cast<double>(value.y) * weight.y;
    sums[2] += static_cast<double>(value.z) * weight.z;
}

// Without samples every sum is 0, and so is every mean.
double divisor(double weight) { return weight > 0.0 ? weight : 1.0; }

// Copies a window of rows of `stride` values a pixel from one picture into another.
template <typename T>
void copy_window(const std::vector<T>& from,
                 const PixelBounds& from_bounds,
                 std::vector<T>& to,
                 const PixelBounds& to_bounds,
                 const PixelBounds& window,
                 std::size_t stride)
{
    for (int y = window.y0; y < window.y1; ++y) {
        std::copy_n(from.data() + pixel_index(from_bounds, window.x0, y) * stride,
                    static_cast<std::size_t>(window.width()) * stride,
                    to.data() + pixel_index(to_bounds, window.x0, y) * stride);
    }
}

}  // namespace

void FilmTile::add(const PathSample& sample)
{
    ++fates_[sample.fate];
    if (sample.fate != RayFate::Transmitted && !layout_.efficiency) {
        return;
    }
    double* sums = sums_.data() + pixel_index(bounds_, sample.x, sample.y) * layout_.stride();
    sums[weight_sum] += sample.weight;
    const V3d channel_weight = sample.channel_weight * sample.weight;
    add_weighted(sums + combined_sums, sample.light.radiance, channel_weight);
    if (layout_.chromatic) {
        add_weighted(sums + layout_.channel_weights(), V3f(1.0f), channel_weight);
    }
    sums[combined_sums + 3] += static_cast<double>(sample.light.alpha) * sample.weight;
    const std::size_t light_channels = layout_.passes.light_channels();
    for (std::size_t i = 0; i < sample.values.size(); ++i) {
        const double weight =
            i < light_channels ? channel_weight[static_cast<int>(i % 3)] : sample.weight;
        sums[pass_sums + i] += static_cast<double>(sample.values[i]) * weight;
    }
}

void FilmTile::set(int x, int y, std::span<const float> chief)
{
    std::ranges::copy(chief, chief_.data() + pixel_index(bounds_, x, y) * chief.size());
}

Film::Film(const PixelBounds& bounds, const FilmLayout& layout)
    : bounds_(bounds), layout_(layout), sums_(pixel_count(bounds) * layout.stride()),
      chief_(pixel_count(bounds) * layout.passes.chief_channels())
{
}

FilmTile Film::take(const PixelBounds& bounds) const
{
    FilmTile tile;
    tile.bounds_ = bounds;
    tile.layout_ = layout_;
    tile.sums_.resize(pixel_count(bounds) * layout_.stride());
    copy_window(sums_, bounds_, tile.sums_, bounds, bounds, layout_.stride());
    const std::size_t chief_channels = layout_.passes.chief_channels();
    tile.chief_.resize(pixel_count(bounds) * chief_channels);
    copy_window(chief_, bounds_, tile.chief_, bounds, bounds, chief_channels);
    return tile;
}

void Film::put(const FilmTile& tile)
{
    const std::scoped_lock lock(mutex_);
    copy_window(tile.sums_, tile.bounds_, sums_, bounds_, tile.bounds_, layout_.stride());
    for (std::size_t i = 0; i < fates_.count.size(); ++i) {
        fates_.count[i] += tile.fates_.count[i];
    }
    copy_window(tile.chief_, tile.bounds_, chief_, bounds_, tile.bounds_,
                layout_.passes.chief_channels());
}

double Film::mean(const double* sums, Pass pass, std::size_t channel) const
{
    const bool is_light = info(pass).source == PassSource::Light && channel < 3;
    const std::size_t first =
        pass == Pass::Combined ? combined_sums
                               : pass_sums + static_cast<std::size_t>(layout_.passes.first(pass));
    const double scale = is_light ? layout_.light_scale() : 1.0;
    return scale * sums[first + channel] /
           divisor(sums[is_light ? weight_of(channel) : weight_sum]);
}

void Film::write(std::vector<float>& pixels, Pass pass) const
{
    const std::size_t channels = info(pass).channels();
    const std::optional<Pass> color = info(pass).divisor;
    float* out = pixels.data();
    for (std::size_t i = 0; i < sums_.size(); i += layout_.stride()) {
        for (std::size_t channel = 0; channel < channels; ++channel) {
            double value = pass == Pass::SampleWeight ? sums_[i + weight_of(channel)]
                                                      : mean(sums_.data() + i, pass, channel);
            if (color) {
                value /= divisor(mean(sums_.data() + i, *color, channel));
            }
            *out++ = static_cast<float>(value);
        }
    }
}

std::size_t Film::weight_of(std::size_t channel) const
{
    const bool is_color = channel < 3;
    return layout_.chromatic && is_color ? layout_.channel_weights() + channel : weight_sum;
}

RayFates Film::fates() const
{
    const std::scoped_lock lock(mutex_);
    return fates_;
}

std::vector<PassImage> Film::snapshot(std::span<const Pass> passes) const
{
    std::vector<PassImage> images;
    const std::scoped_lock lock(mutex_);
    for (const Pass pass : passes) {
        const std::size_t channels = info(pass).channels();
        PassImage image{.pass = pass,
                        .width = bounds_.width(),
                        .height = bounds_.height(),
                        .pixels = std::vector<float>(pixel_count(bounds_) * channels)};
        if (info(pass).source == PassSource::Chief) {
            const auto first = static_cast<std::size_t>(layout_.passes.first(pass));
            for (std::size_t i = 0; i < pixel_count(bounds_); ++i) {
                std::copy_n(chief_.data() + i * layout_.passes.chief_channels() + first, channels,
                            image.pixels.data() + i * channels);
            }
        } else {
            write(image.pixels, pass);
        }
        images.push_back(std::move(image));
    }
    return images;
}

}  // namespace eye_render
