// What an engine tells of its render: warnings, and what was rendered with which eye.

#include "api/engine.h"
#include "optics/prescription_text.h"

#include <algorithm>

namespace eye_render {

namespace {

std::string joined(const std::vector<std::string>& texts)
{
    std::string text;
    for (const std::string& part : texts) {
        text += (text.empty() ? "" : "; ") + part;
    }
    return text;
}

bool has_second_order(const Wavefront& wavefront)
{
    const std::vector<double>& c = wavefront.coefficients_um;
    for (std::size_t j = 3; j < std::min<std::size_t>(c.size(), 6); ++j) {
        if (c[j] != 0.0) {
            return true;
        }
    }
    return false;
}

// How a schematic eye's rays are found.
std::string trace_text(const EyeDescription& eye, const std::optional<double>& fitted_field_deg)
{
    if (fitted_field_deg) return "fitted over " + number_text(*fitted_field_deg) + " degrees";
    if (eye.exact_trace) return "exact";
    return "exact: no fit within " + number_text(max_fit_error_arcmin) + " arcmin";
}

// Whether something in the scene may give light; a picture counts as light unseen.
bool has_light(const SceneData& scene, const RenderPlan& plan)
{
    const bool has_lamp =
        std::any_of(scene.lamps.begin(), scene.lamps.end(),
                    [](const LampData& lamp) { return lamp.settings.color != Color3f(0.0f); });
    const auto radiance = scene.world.surface.constant_emission();
    const bool has_world = !radiance || *radiance != Color3f(0.0f);
    const bool has_glow = scene.world.volume.may_emit() ||
                          std::ranges::any_of(scene.materials, [](const Material& m) {
                              return m.volume.may_emit();
                          });
    return has_lamp || has_world || has_glow || plan.emissive_meshes;
}

}  // namespace

std::vector<std::string> Engine::warnings() const
{
    std::vector<std::string> all = scene_data_->warnings();
    if (!has_light(scene_data_->data(), plan_)) {
        all.emplace_back("there is no light in the scene, so the picture is black");
    }
    all.insert(all.end(), eye_.notes.begin(), eye_.notes.end());
    if (!eye_.pupil_clamps.empty()) {
        all.push_back("pupil: " + joined(eye_.pupil_clamps));
    }
    const EyeDescription& eye = observer_.eye;
    if (is_schematic(eye.model) && !eye.exact_trace && !eye_.model->fitted_field_deg()) {
        all.push_back("the rays of the eye '" + std::string(to_string(eye.model)) + "' are " +
                      trace_text(eye, std::nullopt) +
                      " was found at this pupil and accommodation, so rendering takes longer");
    }
    if (settings_.stiles_crawford != StilesCrawfordMode::Off &&
        m_from_mm(eye_.pupil_mm) > 2.0 * max_measured_radius_m) {
        all.push_back("the Stiles-Crawford effect is known to " +
                      number_text(mm_from_m(max_measured_radius_m)) +
                      " mm from the pupil's centre; of the pupil of " +
                      number_text(eye_.pupil_mm) + " mm the rest is extrapolated");
    }
    if (observer_.eye.wavefront && has_second_order(*observer_.eye.wavefront)) {
        all.emplace_back(
            "the wavefront's own defocus and astigmatism (OSA indices 3 to 5) are left "
            "out, because the prescription states them");
    }
    return all;
}

std::string Engine::pupil_report() const
{
    if (observer_.eye.model == EyeModelKind::Pinhole) {
        return "a pinhole";
    }
    std::string text = number_text(eye_.pupil_mm) + " mm";
    if (!observer_.pupil_mm) {
        text += " (" + std::string(to_string(observer_.pupil_formula)) + ", " +
                number_text(eye_.luminance_cd_m2) + " cd/m2 over " +
                number_text(eye_.field_area_deg2) + " deg2" +
                (observer_.eyes == 1 ? " seen by one eye" : "") + ")";
    }
    return text;
}

std::map<std::string, Fact> Engine::facts() const
{
    std::map<std::string, Fact> entries{
        {"rx", format_prescription(observer_.eye.rx)},
        {"rx_plane", std::string(to_string(observer_.eye.rx_plane))},
        {"model", std::string(to_string(observer_.eye.model))},
        {"pupil_mm", eye_.pupil_mm},
        {"accommodation_d", eye_.accommodation_d},
        {"accommodation_amplitude_d", eye_.amplitude_d},
        {"age_years", observer_.age_years},
        {"amplitude_formula", std::string(to_string(observer_.amplitude_formula))},
        {"samples", range_text(samples_of(settings_))},
        {"seed", std::to_string(settings_.seed)},
        {"max_bounces", std::to_string(settings_.max_bounces)},
        {"exposure", settings_.exposure},
        {"pixel_filter", std::string(to_string(settings_.filter))},
        {"filter_width_px", settings_.filter_width_px},
        {"pupil_pattern", std::string(to_string(settings_.pattern))},
        {"chromatic", plan_.chromatic ? "yes" : "no"},
        {"stiles_crawford", std::string(to_string(settings_.stiles_crawford))},
    };
    if (observer_.eye.rx_plane == RxPlane::Spectacle) {
        entries["vertex_mm"] = observer_.eye.vertex_mm;
    }
    if (!observer_.pupil_mm && observer_.eye.model != EyeModelKind::Pinhole) {
        entries["pupil_formula"] = std::string(to_string(observer_.pupil_formula));
        entries["luminance_cd_m2"] = eye_.luminance_cd_m2;
        entries["cd_m2_per_unit"] = observer_.cd_m2_per_unit;
        entries["luminance_sigma"] = observer_.luminance_sigma;
        entries["field_area_deg2"] = eye_.field_area_deg2;
        entries["eyes"] = std::to_string(observer_.eyes);
        if (!eye_.pupil_clamps.empty()) {
            entries["pupil_clamps"] = joined(eye_.pupil_clamps);
        }
    }
    if (is_schematic(observer_.eye.model)) {
        entries["refraction_zero"] = std::string(to_string(observer_.eye.refraction_zero));
        const auto fitted_field_deg = eye_.model->fitted_field_deg();
        entries["exact_trace"] = fitted_field_deg ? "no" : "yes";
        entries["trace"] = trace_text(observer_.eye, fitted_field_deg);
        if (fitted_field_deg) {
            entries["fit_residual_arcmin"] = eye_.model->approximation_arcmin();
        }
    }
    if (observer_.eye.model == EyeModelKind::Wavefront) {
        entries["wavefront"] =
            observer_.eye.wavefront ? wavefront_text(*observer_.eye.wavefront) : "population mean";
    }
    if (observer_.eye.correction != Correction::None) {
        entries["correction"] = std::string(to_string(observer_.eye.correction));
        entries["worn"] =
            observer_.eye.worn ? format_prescription(*observer_.eye.worn) : "full correction";
        if (observer_.eye.near_part) {
            entries["worn_part"] = "near";
        }
    }
    entries["focus"] = std::string(to_string(observer_.focus));
    if (observer_.focus != FocusMode::Relaxed) {
        entries["focus_m"] = eye_.focus_distance_m;
    }
    return entries;
}

std::map<std::string, std::string> Engine::metadata() const
{
    std::map<std::string, std::string> texts;
    for (const auto& [key, fact] : facts()) {
        const double* const number = std::get_if<double>(&fact);
        texts[key] = number != nullptr ? number_text(*number) : std::get<std::string>(fact);
    }
    return texts;
}

}  // namespace eye_render
