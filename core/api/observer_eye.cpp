#include "api/observer_eye.h"

#include "analysis/least_blur.h"
#include "analysis/through_focus.h"
#include "base/error.h"
#include "base/units.h"
#include "eye/field_luminance.h"
#include "optics/population_wavefront.h"
#include "render/chief_passes.h"
#include "render/tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

// The picture from which the pupil takes its luminance: coarse, since only its mean is wanted. 64
// pixels along the longer side by 32 samples estimate the mean of a hall to about 1 %, which moves
// the pupil by 0.01 mm.
constexpr int luminance_size_px = 64;
constexpr std::uint32_t luminance_samples = 32;
constexpr int luminance_bounces = 4;

double focus_distance_m(const Observer& observer,
                        const EyeModel& relaxed_eye,
                        const Scene& scene,
                        const CameraFrame& frame)
{
    switch (observer.focus) {
    case FocusMode::Distance:
        if (observer.focus_distance_m != std::numeric_limits<double>::infinity()) {
            require_range("focus", observer.focus_distance_m, min_object_distance_m, 1e12, "m");
        }
        return observer.focus_distance_m;
    case FocusMode::Center:
        return distance_along_m({.scene = scene, .frame = frame, .eye = relaxed_eye},
                                V2d(0.5 * (frame.slope_left + frame.slope_right),
                                    0.5 * (frame.slope_bottom + frame.slope_top)));
    case FocusMode::Relaxed: break;
    }
    return std::numeric_limits<double>::infinity();
}

// The accommodation that the object takes, within the amplitude and, as far as its focus alone
// goes, without that limit: negative for what lies beyond the far point.
struct Accommodation {
    double least_blur_d = 0.0;
    double wanted_d = 0.0;
};

Accommodation accommodation_for(const Observer& observer,
                                const ObserverEye& eye,
                                const EyeModel& relaxed_eye)
{
    const double object_vergence_d = 1.0 / eye.focus_distance_m;
    if (relaxed_eye.is_first_order() || eye.pupil_mm == 0.0) {
        const PowerMatrix error_d = relaxed_eye.error_d(object_vergence_d);
        return {best_accommodation_d(error_d, eye.amplitude_d), 0.0 - error_d.mean_d()};
    }
    Observer traced = observer;
    traced.eye.exact_trace = true;  // a fit takes longer than the few rays that are asked for
    const auto eye_at = [&](double accommodation_d) {
        return eye_in_state(traced, eye.pupil_mm, accommodation_d);
    };
    const double least_blur_d =
        least_blur_accommodation_d(eye_at, object_vergence_d, eye.amplitude_d);
    if (least_blur_d > 0.0 && least_blur_d < eye.amplitude_d) return {least_blur_d, least_blur_d};
    // At an end, what its best focus then lacks; less than the search is exact to is nothing.
    constexpr double search_d = 0.02;
    const double lacking_d =
        object_vergence_d -
        through_focus(*eye_at(least_blur_d)).best_focus_d.value_or(object_vergence_d);
    return {least_blur_d, least_blur_d + (std::abs(lacking_d) < search_d ? 0.0 : lacking_d)};
}

void accommodate(ObserverEye& eye, const Observer& observer, const EyeModel& relaxed_eye)
{
    const double of_age_d =
        accommodation_amplitude_d(observer.age_years, observer.amplitude_formula);
    eye.amplitude_d = std::min(of_age_d, relaxed_eye.max_accommodation_d());
    if (observer.focus == FocusMode::Relaxed) {
        return;
    }
    const auto [least_blur_d, wanted_d] = accommodation_for(observer, eye, relaxed_eye);
    eye.accommodation_d = least_blur_d;
    const std::string object = std::isfinite(eye.focus_distance_m)
                                   ? "at " + number_text(eye.focus_distance_m) + " m"
                                   : "far away";
    if (wanted_d > eye.amplitude_d) {
        eye.notes.push_back("focus: seeing sharply " + object + " takes " + number_text(wanted_d) +
                            " D of accommodation; " +
                            (eye.amplitude_d < of_age_d
                                 ? "this eye model has "
                                 : "at " + number_text(observer.age_years) + " years there are ") +
                            number_text(eye.amplitude_d) + " D");
    } else if (wanted_d < 0.0) {
        eye.notes.push_back("focus: what lies " + object +
                            " is beyond the far point; the relaxed eye is " +
                            number_text(-wanted_d) + " D too strong for it");
    }
}

// The scene as a small picture without blur. The pupil answers to the whole field, whatever part
// of it is rendered.
std::vector<Color3f> field_radiance(const std::shared_ptr<const Scene>& scene,
                                    const CameraFrame& full_frame,
                                    int threads,
                                    std::size_t& width)
{
    RenderJob job;
    job.scene = scene;
    job.frame = full_frame;
    CameraFrame& frame = job.frame;
    const int longer_px = std::max(full_frame.width_px, full_frame.height_px);
    const int size_px = std::min(longer_px, luminance_size_px);
    frame.width_px = std::max(1, full_frame.width_px * size_px / longer_px);
    frame.height_px = std::max(1, full_frame.height_px * size_px / longer_px);
    frame.border = {0, 0, frame.width_px, frame.height_px};
    job.eye = make_eye(EyeDescription{.model = EyeModelKind::Pinhole});
    job.lens = false;
    job.integrator.max_bounces = luminance_bounces;
    Film film(frame.border, {});
    const std::atomic<bool> never_cancelled{false};
    on_threads(threads, [&] {
        trace_samples(job, {.first = 0, .last = luminance_samples}, film, never_cancelled);
    });
    const PassImage image = film.snapshot({Pass::Combined}).front();
    std::vector<Color3f> radiance;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        radiance.emplace_back(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
    }
    width = static_cast<std::size_t>(image.width);
    return radiance;
}

void adapt_pupil(ObserverEye& eye,
                 const Observer& observer,
                 const std::shared_ptr<const Scene>& scene,
                 const CameraFrame& frame,
                 int threads)
{
    if (observer.pupil_mm) {
        eye.pupil_mm = *observer.pupil_mm;
        return;
    }
    std::size_t width = 0;
    const std::vector<Color3f> radiance = field_radiance(scene, frame, threads, width);
    const bool as_in_paper = observer.pupil_formula == PupilFormula::Paper;
    eye.luminance_cd_m2 = field_luminance_cd_m2(
        radiance, width,
        {.weights = as_in_paper ? paper_luminance_weights
                                : V3d(luminance_weights(scene->working_space())),
         .sigma = observer.luminance_sigma,
         .cd_m2_per_unit = observer.cd_m2_per_unit});
    eye.field_area_deg2 =
        observer.field_area_deg2.value_or(field_area_deg2({.left = frame.slope_left,
                                                           .right = frame.slope_right,
                                                           .bottom = frame.slope_bottom,
                                                           .top = frame.slope_top}));
    const PupilSize size =
        pupil_size(observer.pupil_formula, {.luminance_cd_m2 = eye.luminance_cd_m2,
                                            .area_deg2 = eye.field_area_deg2,
                                            .age_years = observer.age_years,
                                            .eyes = observer.eyes});
    eye.pupil_mm = mm_from_m(size.diameter_m);
    eye.pupil_clamps = size.clamps;
    if (observer.eye.model == EyeModelKind::Wavefront) {
        const double measured_mm =
            mm_from_m(observer.eye.wavefront ? observer.eye.wavefront->pupil_diameter_m
                                             : max_population_pupil_m);
        if (eye.pupil_mm > measured_mm) {
            eye.pupil_clamps.push_back("diameter " + number_text(eye.pupil_mm) +
                                       " mm is wider than the wavefront's pupil of " +
                                       number_text(measured_mm) + " mm, which is used");
            eye.pupil_mm = measured_mm;
        }
    }
}

}  // namespace

std::string_view to_string(FocusMode mode)
{
    switch (mode) {
    case FocusMode::Relaxed: return "relaxed";
    case FocusMode::Distance: return "distance";
    case FocusMode::Center: return "center";
    }
    return "";
}

std::unique_ptr<EyeModel> eye_in_state(const Observer& observer,
                                       double pupil_mm,
                                       double accommodation_d)
{
    EyeDescription description = observer.eye;
    description.pupil_mm = pupil_mm;
    description.accommodation_d = accommodation_d;
    if (description.model == EyeModelKind::Wavefront && !description.wavefront) {
        const double measured_pupil_m = std::max(m_from_mm(pupil_mm), min_wavefront_pupil_m);
        description.wavefront = population_wavefront(measured_pupil_m, description.rx.eye);
    }
    return make_eye(description);
}

ObserverEye make_observer_eye(const Observer& observer,
                              const std::shared_ptr<const Scene>& scene,
                              const CameraFrame& frame,
                              int threads)
{
    ObserverEye eye;
    if (observer.eye.model != EyeModelKind::Pinhole) {
        adapt_pupil(eye, observer, scene, frame, threads);
    }
    eye.model = eye_in_state(observer, eye.pupil_mm, 0.0);
    eye.focus_distance_m = focus_distance_m(observer, *eye.model, *scene, frame);
    accommodate(eye, observer, *eye.model);
    if (eye.accommodation_d > 0.0) {
        eye.model = eye_in_state(observer, eye.pupil_mm, eye.accommodation_d);
    }
    return eye;
}

}  // namespace eye_render
