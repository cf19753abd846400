// The observer and the render, as the outside says them: plain values in the user's units.
// engine.h turns them into an eye and a session.

#pragma once

#include "api/eye.h"
#include "render/passes.h"
#include "render/tracer.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eye_render {

enum class FocusMode { Relaxed, Distance, Center };

// "relaxed", "distance", "center".
[[nodiscard]] std::string_view to_string(FocusMode mode);

struct Observer {
    // Its pupil and accommodation are found, and not read. The wavefront model without a wavefront
    // is the mean of healthy eyes.
    EyeDescription eye{};
    double age_years = 30.0;
    AmplitudeFormula amplitude_formula = AmplitudeFormula::HofstetterMean;
    std::optional<double> pupil_mm;  // nothing: from the light of the scene
    PupilFormula pupil_formula = PupilFormula::WatsonYellott;
    double cd_m2_per_unit = 179.0;  // luminance of radiance 1 in all channels
    double luminance_sigma = 0.5;   // of the Gaussian weight, in half picture heights and widths
    std::optional<double> field_area_deg2;  // that the pupil adapts to; nothing: the picture's
    int eyes = 2;                           // that see the light, 1 or 2
    FocusMode focus = FocusMode::Relaxed;
    double focus_distance_m = 0.0;  // with FocusMode::Distance, from the entrance pupil
};

struct RenderSettings {
    std::uint32_t samples = 64;        // of the whole picture; shapes circinate and grid patterns
    std::optional<SampleRange> range;  // of these, those to render; nothing: all
    int max_bounces = 8;
    std::uint64_t seed = 0;
    PupilPatternKind pattern = PupilPatternKind::Sobol;
    std::vector<Pass> passes{Pass::Combined};
    int threads = 0;  // 0: all the processor has
    bool film_transparent = false;
    double filter_width_px = 1.5;
    bool chromatic = false;  // each path at a wavelength of its own
    StilesCrawfordMode stiles_crawford = StilesCrawfordMode::Off;
};

}  // namespace eye_render
