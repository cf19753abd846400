// eyecore.Settings, and the names that it takes.

#include "api/render_settings.h"
#include "bind_values.h"
#include "module.h"

#include <map>

namespace eye_render {

namespace {

// A mode's name, or True for the one that keeps the picture's brightness.
StilesCrawfordMode stiles_crawford_from(const py::object& mode)
{
    if (py::isinstance<py::bool_>(mode)) {
        return mode.cast<bool>() ? StilesCrawfordMode::Brightness : StilesCrawfordMode::Off;
    }
    if (!py::isinstance<py::str>(mode)) {
        throw std::invalid_argument("stiles_crawford is " + text_of(mode) +
                                    "; expected one of STILES_CRAWFORD_MODES or a bool");
    }
    return named_of("stiles_crawford", mode.cast<std::string>(), stiles_crawford_modes);
}

RenderSettings make_settings(std::uint32_t samples,
                             int max_bounces,
                             std::uint64_t seed,
                             const std::optional<std::array<std::uint32_t, 2>>& sample_range,
                             const std::string& pattern,
                             const std::vector<std::string>& passes,
                             int threads,
                             bool film_transparent,
                             const std::optional<double>& film_glass_roughness,
                             double exposure,
                             const std::string& pixel_filter,
                             double filter_width_px,
                             const LightPathLimits& limits,
                             bool chromatic,
                             const py::object& stiles_crawford,
                             float mist_start,
                             float mist_depth,
                             const std::string& mist_falloff,
                             float occlusion_distance,
                             float pass_alpha_threshold,
                             const std::map<std::string, std::string>& aovs)
{
    RenderSettings settings;
    settings.samples = samples;
    if (sample_range) {
        settings.range = SampleRange{(*sample_range)[0], (*sample_range)[1]};
    }
    settings.max_bounces = max_bounces;
    settings.limits = limits;
    settings.seed = seed;
    settings.pattern = named_of("pattern", pattern, pupil_pattern_kinds);
    settings.passes.clear();
    for (const std::string& name : passes) {
        const auto pass = pass_named(name);
        if (!pass) {
            throw std::invalid_argument("pass '" + name + "' does not exist; see eyecore.PASSES");
        }
        settings.passes.push_back(*pass);
    }
    for (const auto& [name, kind] : aovs) {
        settings.passes.emplace_back(
            named<Pass>("kind of AOV '" + name + "'", kind,
                        {{"VALUE", Pass::AovValue}, {"COLOR", Pass::AovColor}}),
            name);
    }
    settings.threads = threads;
    settings.film_transparent = film_transparent;
    settings.film_glass_roughness = film_glass_roughness;
    settings.exposure = exposure;
    settings.filter = named_of("pixel_filter", pixel_filter, pixel_filter_kinds);
    settings.filter_width_px = filter_width_px;
    settings.chromatic = chromatic;
    settings.stiles_crawford = stiles_crawford_from(stiles_crawford);
    settings.surface_passes = {
        .mist_start = mist_start,
        .mist_depth = mist_depth,
        .mist_falloff = named<MistFalloff>("mist_falloff", mist_falloff,
                                           {{"QUADRATIC", MistFalloff::Quadratic},
                                            {"LINEAR", MistFalloff::Linear},
                                            {"INVERSE_QUADRATIC", MistFalloff::InverseQuadratic}}),
        .occlusion_distance = occlusion_distance};
    settings.pass_alpha_threshold = pass_alpha_threshold;
    return settings;
}

LightPathLimits make_limits(int diffuse_bounces,
                            int glossy_bounces,
                            int transmission_bounces,
                            int volume_bounces,
                            int transparent_bounces,
                            bool reflective_caustics,
                            bool refractive_caustics,
                            float filter_glossy,
                            float clamp_direct,
                            float clamp_indirect)
{
    const LightPathLimits limits{.diffuse_bounces = diffuse_bounces,
                                 .glossy_bounces = glossy_bounces,
                                 .transmission_bounces = transmission_bounces,
                                 .volume_bounces = volume_bounces,
                                 .transparent_bounces = transparent_bounces,
                                 .reflective_caustics = reflective_caustics,
                                 .refractive_caustics = refractive_caustics,
                                 .filter_glossy = filter_glossy,
                                 .clamp_direct = clamp_direct,
                                 .clamp_indirect = clamp_indirect};
    require_valid(limits);
    return limits;
}

std::string settings_text(const RenderSettings& settings)
{
    const std::string range = settings.range
                                  ? ", sample_range=(" + std::to_string(settings.range->first) +
                                        ", " + std::to_string(settings.range->last) + ")"
                                  : "";
    return "Settings(samples=" + std::to_string(settings.samples) + range +
           ", max_bounces=" + std::to_string(settings.max_bounces) +
           ", seed=" + std::to_string(settings.seed) + ", pattern='" +
           std::string(to_string(settings.pattern)) + "')";
}

}  // namespace

void bind_settings(py::module_& m)
{
    using namespace py::literals;

    py::list passes;
    py::list cryptomatte;
    py::list named;
    for (const PassInfo& pass : pass_table) {
        const py::tuple row =
            py::make_tuple(std::string(pass.name), pass.channels(), std::string(pass.channel_ids));
        if (pass.is_named) {
            named.append(row);
        } else if (pass.source == PassSource::Coverage) {
            cryptomatte.append(row);
        } else if (pass.pass == Pass::SampleWeight) {
            // Not a picture to look at, but what merges pictures.
            m.attr("SAMPLE_WEIGHT") = row;
        } else {
            passes.append(row);
        }
    }
    m.attr("PASSES") = passes;
    m.attr("PIXEL_FILTERS") = names_of(pixel_filter_kinds);
    m.attr("CRYPTOMATTE") = cryptomatte;
    m.attr("NAMED_PASSES") = named;
    m.def("murmur3_32", &murmur3_32, "text"_a, "MurmurHash3 of the text in UTF-8.");
    m.def("matte_id", &matte_id, "name"_a, "The number of a name in Cryptomatte's pictures.");
    m.attr("STILES_CRAWFORD_MODES") = names_of(stiles_crawford_modes);

    const LightPathLimits all;
    py::class_<LightPathLimits>(m, "LightPathLimits",
                                "What is left out of the paths of light; by default nothing.")
        .def(py::init(&make_limits), py::kw_only(), "diffuse_bounces"_a = all.diffuse_bounces,
             "glossy_bounces"_a = all.glossy_bounces,
             "transmission_bounces"_a = all.transmission_bounces,
             "volume_bounces"_a = all.volume_bounces,
             "transparent_bounces"_a = all.transparent_bounces, "reflective_caustics"_a = true,
             "refractive_caustics"_a = true, "filter_glossy"_a = 0.0f, "clamp_direct"_a = 0.0f,
             "clamp_indirect"_a = 0.0f,
             "Bounces of a kind, at most, within max_bounces; surfaces that shadow rays pass\n"
             "straight. filter_glossy: roughens what is met after a bounce of a density below "
             "this.\n"
             "clamp_direct, clamp_indirect: the most that light scattered once, or more often, "
             "may\n"
             "bring to a sample; 0 for no limit.");

    py::class_<RenderSettings>(m, "Settings", "How it is rendered.")
        .def(py::init(&make_settings), py::kw_only(), "samples"_a = 64, "max_bounces"_a = 8,
             "seed"_a = 0, "sample_range"_a = py::none(), "pattern"_a = "SOBOL",
             "passes"_a = std::vector<std::string>{"Combined"}, "threads"_a = 0,
             "film_transparent"_a = false, "film_glass_roughness"_a = py::none(),
             "exposure"_a = 1.0, "pixel_filter"_a = "BLACKMAN_HARRIS", "filter_width_px"_a = 1.5,
             "limits"_a = all, "chromatic"_a = false, "stiles_crawford"_a = "OFF",
             "mist_start"_a = SurfacePassSettings{}.mist_start,
             "mist_depth"_a = SurfacePassSettings{}.mist_depth, "mist_falloff"_a = "QUADRATIC",
             "occlusion_distance"_a = SurfacePassSettings{}.occlusion_distance,
             "pass_alpha_threshold"_a = RenderSettings{}.pass_alpha_threshold,
             "aovs"_a = std::map<std::string, std::string>{},
             "sample_range: (first, last), last excluded, in place of samples. threads: 0 for "
             "all.\n"
             "film_glass_roughness: glass up to this shows a transparent film, too.\n"
             "exposure: a factor of all light in the picture. pixel_filter: one of "
             "PIXEL_FILTERS.\n"
             "stiles_crawford: 'BRIGHTNESS' (or True) shapes blur alone; with 'ENERGY' the "
             "picture\n"
             "darkens to what part of the pupil is as good as its peak, and where the eye loses\n"
             "rays. For passes: mist from mist_start over mist_depth units, falloff QUADRATIC,\n"
             "LINEAR or INVERSE_QUADRATIC; how far Ambient Occlusion looks; and below what alpha\n"
             "Depth and other passes without blur see through a surface. Cryptomatte's pictures "
             "go\n"
             "by names such as 'CryptoObject00', those of light groups by 'Combined_' and theirs; "
             "aovs:\n"
             "{name: 'VALUE' or 'COLOR'} of values that materials write out.")
        .def("__repr__", &settings_text);
}

}  // namespace eye_render
