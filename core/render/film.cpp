#include "render/film.h"

#include "render/pixel_means.h"

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

void add_weighted(double* sums, const V3f& value, const V3d& weight)
{
    sums[0] += static_cast<double>(value.x) * weight.x;
    sums[1] += static_cast<double>(value.y) * weight.y;
    sums[2] += static_cast<double>(value.z) * weight.z;
}

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
    const std::size_t pixel = pixel_index(bounds_, sample.x, sample.y);
    double* sums = sums_.data() + pixel * layout_.stride();
    sums[FilmLayout::weight] += sample.weight;
    const V3d channel_weight = sample.channel_weight * sample.weight;
    double* const combined = sums + FilmLayout::combined;
    add_weighted(combined, sample.light.radiance, channel_weight);
    combined[3] += static_cast<double>(sample.light.alpha) * sample.weight;
    if (layout_.chromatic) {
        add_weighted(sums + layout_.channel_weights(), V3f(1.0f), channel_weight);
    }
    if (sample.values != nullptr) {
        add(*sample.values, pixel, channel_weight, sample.weight);
    }
}

void FilmTile::add(const PassValues& values,
                   std::size_t pixel,
                   const V3d& channel_weight,
                   double weight)
{
    double* const sums = sums_.data() + pixel * layout_.stride() + FilmLayout::pass_sums;
    const std::span<const float> channels = values.channels();
    const std::size_t light_channels = layout_.passes.light_channels();
    for (std::size_t i = 0; i < channels.size(); ++i) {
        sums[i] += static_cast<double>(channels[i]) *
                   (i < light_channels ? channel_weight[static_cast<int>(i % 3)] : weight);
    }
    for (const MatteShare& matte : values.mattes()) {
        mattes_[pixel * layout_.passes.matte_kinds() + matte.kind].add(
            matte.id, static_cast<double>(matte.coverage) * weight);
    }
}

void FilmTile::set(int x, int y, std::span<const float> chief)
{
    std::ranges::copy(chief, chief_.data() + pixel_index(bounds_, x, y) * chief.size());
}

Film::Film(const PixelBounds& bounds, const FilmLayout& layout)
    : bounds_(bounds), layout_(layout), sums_(pixel_count(bounds) * layout.stride()),
      chief_(pixel_count(bounds) * layout.passes.chief_channels()),
      mattes_(pixel_count(bounds) * layout.passes.matte_kinds())
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
    const std::size_t kinds = layout_.passes.matte_kinds();
    tile.mattes_.resize(pixel_count(bounds) * kinds);
    copy_window(mattes_, bounds_, tile.mattes_, bounds, bounds, kinds);
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
    copy_window(tile.mattes_, tile.bounds_, mattes_, bounds_, tile.bounds_,
                layout_.passes.matte_kinds());
}

RayFates Film::fates() const
{
    const std::scoped_lock lock(mutex_);
    return fates_;
}

void Film::write(const PassRequest& request, std::size_t pixel, std::span<float> channels) const
{
    const PassLayout& passes = layout_.passes;
    const PixelMeans means(layout_, sums_.data() + pixel * layout_.stride());
    const std::size_t first = passes.first(request);
    switch (info(request.pass).source) {
    case PassSource::Chief:
        std::copy_n(chief_.data() + pixel * passes.chief_channels() + first, channels.size(),
                    channels.begin());
        break;
    case PassSource::Coverage:
        mattes_[pixel * passes.matte_kinds() + first].write(
            static_cast<std::size_t>(request.number), means.weight(), channels.first<4>());
        break;
    default: means.write(request, channels); break;
    }
}

std::vector<PassImage> Film::snapshot(const std::vector<PassRequest>& passes) const
{
    std::vector<PassImage> images;
    const std::scoped_lock lock(mutex_);
    for (const PassRequest& request : passes) {
        const std::size_t channels = info(request.pass).channels();
        PassImage image{.pass = request,
                        .width = bounds_.width(),
                        .height = bounds_.height(),
                        .pixels = std::vector<float>(pixel_count(bounds_) * channels)};
        for (std::size_t pixel = 0; pixel < pixel_count(bounds_); ++pixel) {
            write(request, pixel, std::span(image.pixels).subspan(pixel * channels, channels));
        }
        images.push_back(std::move(image));
    }
    return images;
}

}  // namespace eye_render
