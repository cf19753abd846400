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
constexpr std::size_t normal_sums = 5;
constexpr std::size_t albedo_sums = 8;

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
    if (layout_.first_surface) {
        add_weighted(sums + normal_sums, sample.light.normal, V3d(sample.weight));
        add_weighted(sums + albedo_sums, sample.light.albedo, V3d(sample.weight));
    }
}

void FilmTile::set(int x, int y, const ChiefSample& chief)
{
    chief_[pixel_index(bounds_, x, y)] = chief;
}

Film::Film(const PixelBounds& bounds, const FilmLayout& layout)
    : bounds_(bounds), layout_(layout), sums_(pixel_count(bounds) * layout.stride()),
      chief_(layout.chief ? pixel_count(bounds) : 0)
{
}

FilmTile Film::take(const PixelBounds& bounds) const
{
    FilmTile tile;
    tile.bounds_ = bounds;
    tile.layout_ = layout_;
    tile.sums_.resize(pixel_count(bounds) * layout_.stride());
    copy_window(sums_, bounds_, tile.sums_, bounds, bounds, layout_.stride());
    if (layout_.chief) {
        tile.chief_.resize(pixel_count(bounds));
        copy_window(chief_, bounds_, tile.chief_, bounds, bounds, 1);
    }
    return tile;
}

void Film::put(const FilmTile& tile)
{
    const std::scoped_lock lock(mutex_);
    copy_window(tile.sums_, tile.bounds_, sums_, bounds_, tile.bounds_, layout_.stride());
    for (std::size_t i = 0; i < fates_.count.size(); ++i) {
        fates_.count[i] += tile.fates_.count[i];
    }
    if (layout_.chief) {
        copy_window(tile.chief_, tile.bounds_, chief_, bounds_, tile.bounds_, 1);
    }
}

void Film::write_mean(std::vector<float>& pixels, std::size_t first, std::size_t channels) const
{
    float* out = pixels.data();
    for (std::size_t i = 0; i < sums_.size(); i += layout_.stride()) {
        const double weight = divisor(sums_[i + weight_sum]);
        for (std::size_t channel = 0; channel < channels; ++channel) {
            *out++ = static_cast<float>(sums_[i + first + channel] / weight);
        }
    }
}

void Film::write_combined(std::vector<float>& pixels) const
{
    float* out = pixels.data();
    for (std::size_t i = 0; i < sums_.size(); i += layout_.stride()) {
        for (std::size_t channel = 0; channel < rgba; ++channel) {
            const double weight = divisor(sums_[i + weight_of(channel)]);
            const double scale = channel < 3 ? layout_.efficiency.value_or(1.0) : 1.0;
            *out++ = static_cast<float>(scale * sums_[i + combined_sums + channel] / weight);
        }
    }
}

void Film::write_sample_weight(std::vector<float>& pixels) const
{
    float* out = pixels.data();
    for (std::size_t i = 0; i < sums_.size(); i += layout_.stride()) {
        for (std::size_t channel = 0; channel < rgba; ++channel) {
            *out++ = static_cast<float>(sums_[i + weight_of(channel)]);
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
        const auto write_chief = [&](float ChiefSample::*member) {
            std::ranges::transform(chief_, image.pixels.begin(), member);
        };
        switch (pass) {
        case Pass::Combined: write_combined(image.pixels); break;
        case Pass::Normal: write_mean(image.pixels, normal_sums, channels); break;
        case Pass::Albedo: write_mean(image.pixels, albedo_sums, channels); break;
        case Pass::Depth: write_chief(&ChiefSample::depth); break;
        case Pass::Defocus: write_chief(&ChiefSample::defocus_d); break;
        case Pass::Blur: write_chief(&ChiefSample::blur_arcmin); break;
        case Pass::SampleWeight: write_sample_weight(image.pixels); break;
        }
        images.push_back(std::move(image));
    }
    return images;
}

}  // namespace eye_render
