// Traces a range of samples of a picture into a film, on all threads.

#pragma once

#include "eye/eye_model.h"
#include "eye/pupil_pattern.h"
#include "eye/stiles_crawford.h"
#include "render/camera_motion.h"
#include "render/film.h"
#include "render/pixel_filter.h"
#include "render/shutter.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace eye_render {

// Sample numbers first to last, last excluded.
struct SampleRange {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
};

struct RenderJob {
    std::shared_ptr<const Scene> scene;
    CameraFrame frame;
    std::optional<CameraMotion> camera_motion{};  // nothing: `frame` at all times
    // Every path has a time of its own; else all have the shutter's middle.
    bool moves = false;
    std::optional<Shutter> shutter{};  // nothing: opens and closes at once
    std::shared_ptr<const EyeModel> eye;
    PupilPattern pattern;
    // False: all rays pass the pupil's centre (the plan found no blur to show).
    bool lens = true;
    // Every path has a wavelength of its own; else all have the reference wavelength.
    bool chromatic = false;
    std::optional<StilesCrawford> stiles_crawford{};  // nothing: all of the pupil counts the same
    IntegratorSettings integrator;
    PassLayout passes{};
    float chief_least_alpha = 0.5f;  // of what the chief rays' passes see
    PixelFilter filter{PixelFilterKind::BlackmanHarris, 1.5};
    std::uint64_t seed = 0;
};

// Runs `work` on at most `threads` threads, 0 for all the processor has.
void on_threads(int threads, const std::function<void()>& work);

// Adds the samples in `range` to the film of the job's border. Returns false if `cancelled` became
// true meanwhile: the film then holds whole samples, but not the same number everywhere.
bool trace_samples(const RenderJob& job,
                   const SampleRange& range,
                   Film& film,
                   const std::atomic<bool>& cancelled);

// Fills the film's chief samples, one ray a pixel. False if cancelled.
bool trace_chief_rays(const RenderJob& job, Film& film, const std::atomic<bool>& cancelled);

}  // namespace eye_render
