#include "api/render_settings.h"

#include "base/error.h"

namespace eye_render {

void require_valid(const RenderSettings& settings)
{
    // 2^24 samples a pixel: the last number of the Sobol index that still is stratified in float.
    require_range("samples", settings.samples, 1, 1 << 24, "");
    if (settings.range) {
        const SampleRange& range = *settings.range;
        if (range.last <= range.first) {
            throw std::invalid_argument("sample range is " + range_text(range) +
                                        "; expected FIRST:LAST with FIRST below LAST");
        }
        require_range("last sample of the range", range.last, 1, 1 << 24, "");
    }
    require_range("max_bounces", settings.max_bounces, 0, most_bounces, "");
    require_valid(settings.limits);
    require_range("threads", settings.threads, 0, 4096, "");
    require_range("exposure", settings.exposure, 0.0, 1e6, "");
    if (settings.film_glass_roughness) {
        require_range("film_glass_roughness", *settings.film_glass_roughness, 0.0, 1.0, "");
    }
    const SurfacePassSettings& surface = settings.surface_passes;
    require_range("mist_start", surface.mist_start, 0.0, 1e30, "units");
    require_range("mist_depth", surface.mist_depth, 1e-30, 1e30, "units");
    require_range("occlusion_distance", surface.occlusion_distance, 0.0, 1e30, "units");
    require_range("pass_alpha_threshold", settings.pass_alpha_threshold, 0.0, 1.0, "");
    if (settings.passes.empty()) {
        throw std::invalid_argument("no passes are asked for; expected at least one");
    }
}

SampleRange samples_of(const RenderSettings& settings)
{
    return settings.range.value_or(SampleRange{.first = 0, .last = settings.samples});
}

std::string range_text(const SampleRange& range)
{
    return std::to_string(range.first) + ":" + std::to_string(range.last);
}

IntegratorSettings integrator_settings(const RenderSettings& settings)
{
    IntegratorSettings integrator{.max_bounces = settings.max_bounces,
                                  .limits = settings.limits,
                                  .film_transparent = settings.film_transparent,
                                  .surface_passes = settings.surface_passes};
    if (settings.film_transparent && settings.film_glass_roughness) {
        // A roughness is the root of an alpha.
        const auto roughness = static_cast<float>(*settings.film_glass_roughness);
        const float alpha = roughness * roughness;
        integrator.clear_alpha_squared = alpha * alpha;
    }
    return integrator;
}

}  // namespace eye_render
