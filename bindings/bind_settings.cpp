// eyecore.Settings, and the names that it takes.

#include "api/observer.h"
#include "bind_values.h"
#include "module.h"

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
                             double filter_width_px,
                             bool chromatic,
                             const py::object& stiles_crawford)
{
    RenderSettings settings;
    settings.samples = samples;
    if (sample_range) {
        settings.range = SampleRange{(*sample_range)[0], (*sample_range)[1]};
    }
    settings.max_bounces = max_bounces;
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
    settings.threads = threads;
    settings.film_transparent = film_transparent;
    settings.filter_width_px = filter_width_px;
    settings.chromatic = chromatic;
    settings.stiles_crawford = stiles_crawford_from(stiles_crawford);
    return settings;
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
    for (const PassInfo& pass : pass_table) {
        const py::tuple row =
            py::make_tuple(std::string(pass.name), pass.channels(), std::string(pass.channel_ids));
        // Not a picture to look at, but what merges pictures.
        if (pass.pass == Pass::SampleWeight) {
            m.attr("SAMPLE_WEIGHT") = row;
        } else {
            passes.append(row);
        }
    }
    m.attr("PASSES") = passes;
    m.attr("STILES_CRAWFORD_MODES") = names_of(stiles_crawford_modes);

    py::class_<RenderSettings>(m, "Settings", "How it is rendered.")
        .def(py::init(&make_settings), py::kw_only(), "samples"_a = 64, "max_bounces"_a = 8,
             "seed"_a = 0, "sample_range"_a = py::none(), "pattern"_a = "SOBOL",
             "passes"_a = std::vector<std::string>{"Combined"}, "threads"_a = 0,
             "film_transparent"_a = false, "filter_width_px"_a = 1.5, "chromatic"_a = false,
             "stiles_crawford"_a = "OFF",
             "sample_range: (first, last), last excluded, in place of samples. threads: 0 for "
             "all.\n"
             "stiles_crawford: 'BRIGHTNESS' (or True) shapes blur alone; with 'ENERGY' the "
             "picture\n"
             "darkens to what part of the pupil is as good as its peak, and where the eye loses\n"
             "rays.")
        .def("__repr__", &settings_text);
}

}  // namespace eye_render
