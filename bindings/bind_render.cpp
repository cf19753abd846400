// eyecore.Observer, Settings, Session and render.

#include "api/engine.h"
#include "bind_values.h"
#include "module.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

namespace eye_render {

namespace {

Observer make_observer(const std::string& model,
                       const py::object& rx,
                       const std::string& rx_plane,
                       double vertex_mm,
                       double age_years,
                       const py::object& pupil,
                       const std::string& pupil_formula,
                       double cd_m2_per_unit,
                       double luminance_sigma,
                       const std::optional<double>& field_area_deg2,
                       int eyes,
                       const py::object& focus,
                       const std::string& correction,
                       const py::object& worn,
                       bool near_part,
                       const std::optional<Wavefront>& wavefront,
                       const std::string& refraction_zero,
                       bool exact_trace,
                       const std::string& amplitude_formula)
{
    Observer observer;
    observer.amplitude_formula =
        named_of("amplitude_formula", amplitude_formula, amplitude_formulas);
    observer.eye = eye_from_python(model, rx, rx_plane, vertex_mm, correction, worn, near_part,
                                   wavefront, refraction_zero, exact_trace);
    observer.age_years = age_years;
    if (const auto diameter_mm = number_from(pupil)) {
        observer.pupil_mm = *diameter_mm;
    } else if (!py::isinstance<py::str>(pupil) || pupil.cast<std::string>() != "auto") {
        throw std::invalid_argument("pupil is " + text_of(pupil) +
                                    "; expected 'auto' or a number of mm");
    }
    observer.pupil_formula = named_of("pupil_formula", pupil_formula, pupil_formulas);
    observer.cd_m2_per_unit = cd_m2_per_unit;
    observer.luminance_sigma = luminance_sigma;
    observer.field_area_deg2 = field_area_deg2;
    observer.eyes = eyes;
    if (const auto distance_m = number_from(focus)) {
        observer.focus = FocusMode::Distance;
        observer.focus_distance_m = *distance_m;
    } else if (py::isinstance<py::str>(focus)) {
        observer.focus =
            named<FocusMode>("focus", focus.cast<std::string>(),
                             {{"relaxed", FocusMode::Relaxed}, {"center", FocusMode::Center}});
    } else {
        throw std::invalid_argument("focus is " + text_of(focus) +
                                    "; expected 'relaxed', 'center' or a number of metres");
    }
    return observer;
}

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

std::string observer_text(const Observer& observer)
{
    std::string text =
        "Observer(model='" + std::string(to_string(observer.eye.model)) + "', rx='" +
        format_prescription(observer.eye.rx) + "', age_years=" + number_text(observer.age_years) +
        ", pupil=" + (observer.pupil_mm ? number_text(*observer.pupil_mm) : "'auto'") + ", focus=";
    text += observer.focus == FocusMode::Distance
                ? number_text(observer.focus_distance_m)
                : "'" + std::string(to_string(observer.focus)) + "'";
    if (observer.eye.correction != Correction::None) {
        text += ", correction='" + std::string(to_string(observer.eye.correction)) + "'";
    }
    if (observer.eye.worn) {
        text += ", worn='" + format_prescription(*observer.eye.worn) + "'";
    }
    if (observer.eye.wavefront) {
        text += ", wavefront=" + py::repr(py::cast(*observer.eye.wavefront)).cast<std::string>();
    }
    return text + ")";
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

py::dict snapshot(Engine& engine)
{
    std::vector<PassImage> images;
    {
        const py::gil_scoped_release release;
        images = engine.session().snapshot();
    }
    py::dict result;
    for (const PassImage& image : images) {
        const PassInfo& pass = info(image.pass);
        py::array_t<float> array({static_cast<py::ssize_t>(image.height),
                                  static_cast<py::ssize_t>(image.width),
                                  static_cast<py::ssize_t>(pass.channels())});
        std::memcpy(array.mutable_data(), image.pixels.data(),
                    image.pixels.size() * sizeof(float));
        result[py::str(std::string(pass.name))] = array;
    }
    return result;
}

py::dict render(const std::shared_ptr<SceneBuilder>& scene,
                const Observer& observer,
                const RenderSettings& settings)
{
    std::unique_ptr<Engine> engine;
    {
        const py::gil_scoped_release release;
        engine = std::make_unique<Engine>(scene, observer, settings);
        engine->session().start();
    }
    // In short waits, so that Ctrl-C ends the render as it ends any Python program.
    for (bool ended = false; !ended;) {
        {
            const py::gil_scoped_release release;
            ended = engine->session().wait(std::chrono::milliseconds(100));
        }
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
    }
    if (const auto error = engine->session().error()) {
        throw std::runtime_error(*error);
    }
    for (const std::string& warning : engine->warnings()) {
        if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) {
            throw py::error_already_set();  // warnings are errors for this caller
        }
    }
    return snapshot(*engine);
}

}  // namespace

void bind_render(py::module_& m)
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

    py::class_<Observer>(m, "Observer", "Who looks: prescription, pupil, focus, age.")
        .def(py::init(&make_observer), py::kw_only(), "model"_a = "paraxial", "rx"_a = "plano",
             "rx_plane"_a = "spectacle", "vertex_mm"_a = 12.0, "age_years"_a = 30.0,
             "pupil"_a = "auto", "pupil_formula"_a = "WATSON_YELLOTT", "cd_m2_per_unit"_a = 179.0,
             "luminance_sigma"_a = 0.5, "field_area_deg2"_a = py::none(), "eyes"_a = 2,
             "focus"_a = "relaxed", "correction"_a = "none", "worn"_a = py::none(),
             "near_part"_a = false, "wavefront"_a = py::none(), "refraction_zero"_a = "paraxial",
             "exact_trace"_a = false, "amplitude_formula"_a = "HOFSTETTER_MEAN",
             "pupil: 'auto' or mm. field_area_deg2: what an automatic pupil adapts to, None for\n"
             "the picture's; eyes: how many see it. focus: 'relaxed', 'center' or metres.\n"
             "correction: 'none', 'glasses' or 'contacts', made to `worn`, by default the eye's "
             "own\n"
             "prescription. wavefront: what the model of that name needs. refraction_zero,\n"
             "exact_trace: for the schematic eyes.")
        .def("__repr__", &observer_text);

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

    py::class_<Engine>(m, "Session", "One render: start, wait, look, cancel.")
        .def(py::init([](const std::shared_ptr<SceneBuilder>& scene, const Observer& observer,
                         const RenderSettings& settings) {
                 const py::gil_scoped_release release;
                 return std::make_unique<Engine>(scene, observer, settings);
             }),
             "scene"_a, "observer"_a, "settings"_a, "Checks, plans and builds; starts nothing.")
        .def("start", [](Engine& engine) { engine.session().start(); })
        .def("cancel", [](Engine& engine) { engine.session().cancel(); })
        .def(
            "wait",
            [](Engine& engine, double timeout_s) {
                // A longer wait would overflow the clock.
                constexpr double a_year_s = 3.2e7;
                if (!(timeout_s >= 0.0)) {
                    throw std::invalid_argument("timeout_s is " + std::to_string(timeout_s) +
                                                " s; expected 0 or more");
                }
                return engine.session().wait(
                    std::chrono::duration<double>(std::min(timeout_s, a_year_s)));
            },
            "timeout_s"_a, py::call_guard<py::gil_scoped_release>(),
            "True when the render has ended.")
        .def("snapshot", &snapshot, "{pass: float32 (height, width, channels)}, rows bottom-up.")
        .def_property_readonly("samples_done",
                               [](Engine& engine) { return engine.session().samples_done(); })
        .def_property_readonly("samples_total",
                               [](Engine& engine) { return engine.session().samples_total(); })
        .def_property_readonly("progress",
                               [](Engine& engine) { return engine.session().progress(); })
        .def_property_readonly(
            "ray_fates",
            [](Engine& engine) {
                const RayFates fates = engine.session().fates();
                py::dict counts;
                for (const RayFate fate : ray_fates) {
                    counts[py::str(std::string(to_string(fate)))] = fates[fate];
                }
                return counts;
            },
            "Rays so far by what became of them in the eye: transmitted, vignetted, missed,\n"
            "total_reflection.")
        .def_property_readonly("error", [](Engine& engine) { return engine.session().error(); })
        .def_property_readonly("plan_text",
                               [](const Engine& engine) { return engine.plan().text(); })
        .def_property_readonly("warnings", &Engine::warnings)
        .def_property_readonly("facts", &Engine::facts,
                               "What is known about the picture's making, numbers as numbers.")
        .def_property_readonly("metadata", &Engine::metadata, "The facts as texts, for files.")
        .def_property_readonly("pupil_mm",
                               [](const Engine& engine) { return engine.eye().pupil_mm; })
        .def_property_readonly("luminance_cd_m2",
                               [](const Engine& engine) { return engine.eye().luminance_cd_m2; })
        .def_property_readonly("pupil_report", &Engine::pupil_report)
        .def_property_readonly("accommodation_d",
                               [](const Engine& engine) { return engine.eye().accommodation_d; });

    m.def("render", &render, "scene"_a, "observer"_a, "settings"_a,
          "Renders to the end; {pass: float32 (height, width, channels)}, rows bottom-up. What\n"
          "Session.warnings tells is issued by warnings.warn.");
}

}  // namespace eye_render
