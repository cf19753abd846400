#include "api/engine.h"

#include "base/error.h"

#include <algorithm>

namespace eye_render {

namespace {

void require_valid(const Observer& observer)
{
    require_range("age", observer.age_years, 0, 120, "years");
    require_range("cd_m2_per_unit", observer.cd_m2_per_unit, 1e-12, 1e12, "cd/m2");
    require_range("luminance_sigma", observer.luminance_sigma, 1e-3, 1e6, "");
    if (observer.pupil_mm) {
        require_range("pupil", *observer.pupil_mm, 0.0, 9.0, "mm");
    }
    if (observer.field_area_deg2) {
        // A whole sphere is 41253 square degrees.
        require_range("field_area_deg2", *observer.field_area_deg2, 1e-6, 41253.0, "deg2");
    }
    require_range("eyes", observer.eyes, 1, 2, "");
    eye_render::require_valid(observer.eye.rx);
    if (observer.eye.worn) {
        eye_render::require_valid(*observer.eye.worn);
    }
}

// As Cycles has it: who asks for the factor of the shadow applies it.
CaughtShadow caught_shadow(const RenderSettings& settings)
{
    if (std::ranges::find(settings.passes, PassRequest(Pass::ShadowCatcher)) !=
        settings.passes.end()) {
        return CaughtShadow::Apart;
    }
    return settings.film_transparent ? CaughtShadow::OverNothing : CaughtShadow::OverWorld;
}

}  // namespace

Engine::Engine(std::shared_ptr<const SceneBuilder> scene,
               const Observer& observer,
               const RenderSettings& settings)
    : scene_data_(std::move(scene)), lease_(scene_data_->lease()), observer_(observer),
      settings_(settings)
{
    eye_render::require_valid(settings);
    require_valid(observer);
    const CameraFrame& frame = scene_data_->camera();
    const SceneData& data = scene_data_->data();
    plan_ = make_plan(data, settings.passes);

    RenderJob job;
    job.filter = PixelFilter(settings.filter, settings.filter_width_px);
    job.scene = std::make_shared<Scene>(data, frame.position_world, view_frame(frame));
    job.frame = frame;
    eye_ = make_observer_eye(observer, job.scene, frame, settings.threads);
    const bool weighs_pupil = settings.stiles_crawford != StilesCrawfordMode::Off;
    const std::vector<CameraFrame>& camera_motion = scene_data_->camera_motion();
    plan_lens(plan_, data, frame, *eye_.model, settings.chromatic, weighs_pupil, camera_motion);
    plan_.motion_blur = settings.motion_blur;
    job.moves = plan_.motion_blur && plan_.moves();
    if (!settings.shutter_curve.empty()) {
        job.shutter.emplace(settings.shutter_curve);
    }
    if (plan_.moving_camera) {
        job.camera_motion.emplace(camera_motion);
    }
    job.eye = eye_.model;
    job.pattern = make_pupil_pattern(settings.pattern, settings.samples);
    job.lens = plan_.lens;
    job.chromatic = plan_.chromatic;
    const StilesCrawford cones(cone_directivity(observer.eye.rx.eye), job.eye->pupil_diameter_m());
    if (plan_.stiles_crawford) {
        job.stiles_crawford = cones;
    }
    SessionSettings session{.samples = samples_of(settings),
                            .passes = settings.passes,
                            .shadow = caught_shadow(settings),
                            .exposure = settings.exposure,
                            .threads = settings.threads};
    if (settings.stiles_crawford == StilesCrawfordMode::Energy) {
        session.efficiency = cones.effective_area_ratio();
    }
    job.passes = PassLayout(settings.passes, {.has_shadow_catcher = plan_.shadow_catcher,
                                              .light_groups = data.light_groups,
                                              .aovs = data.aovs});
    job.chief_least_alpha = settings.pass_alpha_threshold;
    job.integrator = integrator_settings(settings);
    job.integrator.pixel_slope = static_cast<float>(frame.pixel_slope_size().x);
    job.seed = settings.seed;
    session_ = std::make_unique<Session>(std::move(job), std::move(session));
}

}  // namespace eye_render
