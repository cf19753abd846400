// The Python module `eyecore`: NumPy arrays in and out, no decisions of its own.

#include "module.h"

PYBIND11_MODULE(eyecore, m)
{
    m.doc() = "A path tracer that sees a scene through a model of one person's eye.";
    m.attr("__version__") = EYE_VERSION;
    eye_render::bind_prescription(m);
    eye_render::bind_wavefront(m);
    eye_render::bind_eye(m);
    eye_render::bind_nodes(m);
    eye_render::bind_scene(m);
    eye_render::bind_observer(m);
    eye_render::bind_settings(m);
    eye_render::bind_render(m);
    eye_render::bind_analysis(m);
}
