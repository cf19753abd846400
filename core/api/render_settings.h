// How a picture is rendered, as the outside says it.

#pragma once

#include "eye/pupil_pattern.h"
#include "render/light_path_limits.h"
#include "render/passes.h"
#include "render/tracer.h"

#include <optional>
#include <string>
#include <vector>

namespace eye_render {

struct RenderSettings {
    std::uint32_t samples = 64;        // of the whole picture; shapes circinate and grid patterns
    std::optional<SampleRange> range;  // of these, those to render; nothing: all
    int max_bounces = 8;
    LightPathLimits limits{};
    std::uint64_t seed = 0;
    PupilPatternKind pattern = PupilPatternKind::Sobol;
    std::vector<PassRequest> passes{Pass::Combined};
    SurfacePassSettings surface_passes{};
    float pass_alpha_threshold = 0.5f;  // what is clearer is not in passes of chief rays
    int threads = 0;                    // 0: all the processor has
    bool film_transparent = false;
    // Glass up to this roughness shows a transparent film, too; nothing: no glass does.
    std::optional<double> film_glass_roughness{};
    double exposure = 1.0;  // of the film: a factor of all light in the picture
    PixelFilterKind filter = PixelFilterKind::BlackmanHarris;
    double filter_width_px = 1.5;
    bool chromatic = false;  // each path at a wavelength of its own
    StilesCrawfordMode stiles_crawford = StilesCrawfordMode::Off;
    // Without, what moves is seen half way, and only the Vector pass tells of its motion.
    bool motion_blur = true;
    std::vector<double> shutter_curve{};  // as Shutter has it; empty: opens and closes at once
};

// Throws std::invalid_argument for a number out of range.
void require_valid(const RenderSettings& settings);

[[nodiscard]] SampleRange samples_of(const RenderSettings& settings);

// "0:64"
[[nodiscard]] std::string range_text(const SampleRange& range);

// What the settings say about paths, apart from what the plan finds.
[[nodiscard]] IntegratorSettings integrator_settings(const RenderSettings& settings);

}  // namespace eye_render
