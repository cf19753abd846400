// eyecore.Session and render.

#include "api/engine.h"
#include "module.h"

#include <algorithm>
#include <chrono>

namespace eye_render {

namespace {

py::dict snapshot(Engine& engine)
{
    std::vector<PassImage> images;
    {
        const py::gil_scoped_release release;
        images = engine.session().snapshot();
    }
    py::dict result;
    for (const PassImage& image : images) {
        py::array_t<float> array({static_cast<py::ssize_t>(image.height),
                                  static_cast<py::ssize_t>(image.width),
                                  static_cast<py::ssize_t>(info(image.pass.pass).channels())});
        std::memcpy(array.mutable_data(), image.pixels.data(),
                    image.pixels.size() * sizeof(float));
        result[py::str(image.pass.name())] = array;
    }
    return result;
}

std::unique_ptr<Engine> make_engine(const std::shared_ptr<SceneBuilder>& scene,
                                    const Observer& observer,
                                    const RenderSettings& settings)
{
    // Before other Python threads run, which might be about to change the scene.
    const auto lease = scene->lease();
    const py::gil_scoped_release release;
    return std::make_unique<Engine>(scene, observer, settings);
}

py::dict render(const std::shared_ptr<SceneBuilder>& scene,
                const Observer& observer,
                const RenderSettings& settings)
{
    const std::unique_ptr<Engine> engine = make_engine(scene, observer, settings);
    engine->session().start();
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

    py::class_<Engine>(m, "Session", "One render: start, wait, look, cancel.")
        .def(py::init(&make_engine), "scene"_a, "observer"_a, "settings"_a,
             "Checks, plans and builds; starts nothing.")
        .def(
            "start", [](Engine& engine) { engine.session().start(); },
            "Renders in the background; once, a second call does nothing.")
        .def(
            "cancel", [](Engine& engine) { engine.session().cancel(); },
            "Asks the render to end: it does within a pixel's samples.")
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
            "Waits until the render has ended, at most timeout_s seconds; True if it has.")
        .def("snapshot", &snapshot, "{pass: float32 (height, width, channels)}, rows bottom-up.")
        .def_property_readonly(
            "samples_done", [](Engine& engine) { return engine.session().samples_done(); },
            "Samples that every pixel has.")
        .def_property_readonly("samples_total",
                               [](Engine& engine) { return engine.session().samples_total(); })
        .def_property_readonly(
            "progress", [](Engine& engine) { return engine.session().progress(); },
            "0 to 1: samples_done of samples_total.")
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
        .def_property_readonly(
            "error", [](Engine& engine) { return engine.session().error(); },
            "What went wrong while it ran; None if all went well.")
        .def_property_readonly(
            "plan_text", [](const Engine& engine) { return engine.plan().text(); },
            "What this scene, seen by this eye, needs: a fact a line.")
        .def_property_readonly("warnings", &Engine::warnings,
                               "What the picture does not show as asked.")
        .def_property_readonly("facts", &Engine::facts,
                               "What is known about the picture's making, numbers as numbers.")
        .def_property_readonly("metadata", &Engine::metadata, "The facts as texts, for files.")
        .def_property_readonly(
            "pupil_mm", [](const Engine& engine) { return engine.eye().pupil_mm; },
            "Diameter of the entrance pupil.")
        .def_property_readonly(
            "luminance_cd_m2", [](const Engine& engine) { return engine.eye().luminance_cd_m2; },
            "Of the field that set the pupil.")
        .def_property_readonly("pupil_report", &Engine::pupil_report,
                               "How the pupil was found, for people.")
        .def_property_readonly(
            "accommodation_d", [](const Engine& engine) { return engine.eye().accommodation_d; },
            "Of the eye, dioptres.");

    m.def("render", &render, "scene"_a, "observer"_a, "settings"_a,
          "Renders to the end; {pass: float32 (height, width, channels)}, rows bottom-up. What\n"
          "Session.warnings tells is issued by warnings.warn.");
}

}  // namespace eye_render
