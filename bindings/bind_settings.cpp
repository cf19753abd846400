// eyecore.Settings, and the names that it takes.

#include "api/render_settings.h"
#include "options.h"

#include <algorithm>
#include <array>
#include <iterator>
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

bool is_aov(const PassRequest& request)
{
    return request.pass == Pass::AovValue || request.pass == Pass::AovColor;
}

std::vector<std::string> pass_names(const RenderSettings& settings)
{
    std::vector<std::string> names;
    for (const PassRequest& request : settings.passes) {
        if (!is_aov(request)) {
            names.push_back(request.name());
        }
    }
    return names;
}

void set_passes(RenderSettings& settings, const std::vector<std::string>& names)
{
    std::vector<PassRequest> wanted;
    for (const std::string& name : names) {
        const auto pass = pass_named(name);
        if (!pass) {
            throw std::invalid_argument("pass '" + name + "' does not exist; see eyecore.PASSES");
        }
        wanted.push_back(*pass);
    }
    std::ranges::copy_if(settings.passes, std::back_inserter(wanted), is_aov);
    settings.passes = std::move(wanted);
}

std::map<std::string, std::string> aov_kinds(const RenderSettings& settings)
{
    std::map<std::string, std::string> kinds;
    for (const PassRequest& request : settings.passes) {
        if (is_aov(request)) {
            kinds[request.label] = request.pass == Pass::AovValue ? "VALUE" : "COLOR";
        }
    }
    return kinds;
}

void set_aovs(RenderSettings& settings, const std::map<std::string, std::string>& kinds)
{
    std::vector<PassRequest> aovs;
    aovs.reserve(kinds.size());
    for (const auto& [name, kind] : kinds) {
        aovs.emplace_back(named<Pass>("kind of AOV '" + name + "'", kind,
                                      {{"VALUE", Pass::AovValue}, {"COLOR", Pass::AovColor}}),
                          name);
    }
    std::erase_if(settings.passes, is_aov);
    settings.passes.insert(settings.passes.end(), aovs.begin(), aovs.end());
}

std::optional<std::array<std::uint32_t, 2>> sample_range(const RenderSettings& settings)
{
    if (!settings.range) {
        return std::nullopt;
    }
    return std::array{settings.range->first, settings.range->last};
}

void set_sample_range(RenderSettings& settings,
                      const std::optional<std::array<std::uint32_t, 2>>& range)
{
    settings.range.reset();
    if (range) {
        settings.range = SampleRange{(*range)[0], (*range)[1]};
    }
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

void bind_limits(py::module_& m)
{
    using Limits = LightPathLimits;
    py::class_<Limits>(m, "LightPathLimits",
                       "What is left out of the paths of light; by default nothing.")
        .def(py::init([](const py::kwargs& given) {
                 const auto limits = options_from<Limits>(given);
                 require_valid(limits);
                 return limits;
             }),
             "Attributes by keyword. ValueError for one out of range.")
        .def_readwrite("diffuse_bounces", &Limits::diffuse_bounces,
                       "Off wide lobes, at most, and within max_bounces; 0 to 1024.")
        .def_readwrite("glossy_bounces", &Limits::glossy_bounces)
        .def_readwrite("transmission_bounces", &Limits::transmission_bounces)
        .def_readwrite("volume_bounces", &Limits::volume_bounces)
        .def_readwrite("transparent_bounces", &Limits::transparent_bounces,
                       "Surfaces that a shadow ray passes straight.")
        .def_readwrite("reflective_caustics", &Limits::reflective_caustics)
        .def_readwrite("refractive_caustics", &Limits::refractive_caustics)
        .def_readwrite("filter_glossy", &Limits::filter_glossy,
                       "Roughens what is met after a bounce of a density, per steradian, below\n"
                       "this; 0 for nothing.")
        .def_readwrite("clamp_direct", &Limits::clamp_direct,
                       "The most that light scattered once may bring to a sample, as the mean of\n"
                       "its channels; 0 for no limit.")
        .def_readwrite("clamp_indirect", &Limits::clamp_indirect,
                       "The same of light scattered more often.");
}

void define_pass_settings(py::class_<RenderSettings>& settings)
{
    settings
        .def_property(
            "passes", &pass_names, &set_passes,
            "Names of PASSES; Cryptomatte's such as 'CryptoObject00', and those of light\n"
            "groups 'Combined_' and the group's name.")
        .def_property("aovs", &aov_kinds, &set_aovs,
                      "{name: 'VALUE' or 'COLOR'} of values that materials write out.")
        .def_readwrite("pass_alpha_threshold", &RenderSettings::pass_alpha_threshold,
                       "Below this alpha, Depth and other passes without blur see through a\n"
                       "surface; 0 to 1.");
    define_option(
        settings, "mist_start", [](auto& s) -> auto& { return s.surface_passes.mist_start; },
        "In the scene's units, as the others.");
    define_option(
        settings, "mist_depth", [](auto& s) -> auto& { return s.surface_passes.mist_depth; },
        "From where mist starts to where it hides all.");
    define_named_option(
        settings, "mist_falloff", [](auto& s) -> auto& { return s.surface_passes.mist_falloff; },
        mist_falloffs, "QUADRATIC, LINEAR or INVERSE_QUADRATIC.");
    define_option(
        settings, "occlusion_distance",
        [](auto& s) -> auto& { return s.surface_passes.occlusion_distance; },
        "How far the pass Ambient Occlusion looks.");
}

void bind_render_settings(py::module_& m)
{
    using Settings = RenderSettings;
    py::class_<Settings> settings(m, "Settings", "How it is rendered.");
    settings.def(py::init(&options_from<Settings>), "Attributes by keyword.")
        .def_readwrite("samples", &Settings::samples, "A pixel; 1 to 16777216.")
        .def_property("sample_range", &sample_range, &set_sample_range,
                      "(first, last), last excluded, of the samples; None for all.")
        .def_readwrite("max_bounces", &Settings::max_bounces, "0 to 1024.")
        .def_readwrite("limits", &Settings::limits)
        .def_readwrite("seed", &Settings::seed)
        .def_readwrite("threads", &Settings::threads, "0 for all that the processor has.")
        .def_readwrite("film_transparent", &Settings::film_transparent)
        .def_readwrite("film_glass_roughness", &Settings::film_glass_roughness,
                       "Glass up to this shows a transparent film, too; None: no glass does.")
        .def_readwrite("exposure", &Settings::exposure, "A factor of all light in the picture.")
        .def_readwrite("filter_width_px", &Settings::filter_width_px)
        .def_readwrite("chromatic", &Settings::chromatic, "Each path at a wavelength of its own.")
        .def_readwrite("motion_blur", &Settings::motion_blur,
                       "Without it what moves is seen half way, and the Vector pass tells how it\n"
                       "moves.")
        .def_readwrite("shutter_curve", &Settings::shutter_curve,
                       "How far the shutter is open at equally spaced times; empty: it opens and\n"
                       "closes at once.")
        .def_property(
            "stiles_crawford",
            [](const Settings& s) { return std::string(to_string(s.stiles_crawford)); },
            [](Settings& s, const py::object& mode) {
                s.stiles_crawford = stiles_crawford_from(mode);
            },
            "'BRIGHTNESS' (or True) shapes blur alone; with 'ENERGY' the picture darkens to what\n"
            "part of the pupil is as good as its peak, and where the eye loses rays; 'OFF'.")
        .def("__repr__", &settings_text);
    define_named_option(
        settings, "pattern", [](auto& s) -> auto& { return s.pattern; }, pupil_pattern_kinds,
        "Of points in the pupil: one of PUPIL_PATTERNS.");
    define_named_option(
        settings, "pixel_filter", [](auto& s) -> auto& { return s.filter; }, pixel_filter_kinds,
        "One of PIXEL_FILTERS.");
    define_pass_settings(settings);
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

    bind_limits(m);
    bind_render_settings(m);
}

}  // namespace eye_render
