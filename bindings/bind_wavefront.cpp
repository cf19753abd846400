// eyecore.Wavefront.

#include "api/eye.h"
#include "module.h"

namespace eye_render {

namespace {

Wavefront make_wavefront(std::vector<double> coefficients_um,
                         double pupil_mm,
                         double wavelength_nm)
{
    Wavefront wavefront{.coefficients_um = std::move(coefficients_um),
                        .pupil_diameter_m = m_from_mm(pupil_mm),
                        .wavelength_nm = wavelength_nm};
    require_valid(wavefront);
    return wavefront;
}

Wavefront population(double pupil_mm, const std::string& eye)
{
    return population_wavefront(
        m_from_mm(pupil_mm),
        named<EyeSide>("eye", eye, {{"OD", EyeSide::Right}, {"OS", EyeSide::Left}}));
}

}  // namespace

void bind_wavefront(py::module_& m)
{
    using namespace py::literals;

    py::class_<Wavefront>(m, "Wavefront",
                          "Aberrations of an eye: OSA/ANSI Zernike coefficients in micrometres, "
                          "from index 0, over a\n"
                          "pupil, in the frame of a clinician who faces the patient.")
        .def(py::init(&make_wavefront), "coefficients_um"_a, "pupil_mm"_a,
             "wavelength_nm"_a = reference_wavelength_nm)
        .def_static("population", &population, "pupil_mm"_a, "eye"_a = "OD",
                    "The mean of 200 healthy eyes (Thibos et al. 2002), right (OD) or left (OS),\n"
                    "over a pupil of 1 to 7.5 mm.")
        .def_static(
            "corrected_by",
            [](const Prescription& rx, double pupil_mm) {
                Wavefront wavefront =
                    wavefront_corrected_by(power_vector(rx), m_from_mm(pupil_mm));
                require_valid(wavefront);
                return wavefront;
            },
            "rx"_a, "pupil_mm"_a,
            "Defocus and astigmatism that a lens in the plane of the pupil corrects; rx() gives "
            "it back.")
        .def_readonly("coefficients_um", &Wavefront::coefficients_um)
        .def_property_readonly("pupil_mm",
                               [](const Wavefront& w) { return mm_from_m(w.pupil_diameter_m); })
        .def_readonly("wavelength_nm", &Wavefront::wavelength_nm)
        .def(
            "rescaled",
            [](const Wavefront& w, double pupil_mm) { return rescaled(w, m_from_mm(pupil_mm)); },
            "pupil_mm"_a, "The same wavefront over a smaller pupil.")
        .def_property_readonly("rms_um", &higher_order_rms_um,
                               "Root mean square of the third order and above.")
        .def(
            "rx", [](const Wavefront& w) { return prescription_from(paraxial_refraction(w)); },
            "The prescription, at the entrance pupil and for 555 nm, that flattens the middle of\n"
            "the wavefront. The wavefront model takes its focus from the prescription alone: "
            "give\n"
            "it this one to see with the whole wavefront.")
        .def("__repr__", &wavefront_text);
}

}  // namespace eye_render
