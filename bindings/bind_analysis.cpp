// The part of eyecore.Eye that says what becomes of a point: spot, PSF, MTF, focus.

#include "api/eye_analysis.h"
#include "api/observer_eye.h"
#include "module.h"

#include <limits>

namespace eye_render {

namespace {

using EyeClass = py::class_<EyeModel, std::shared_ptr<EyeModel>>;

constexpr double infinity = std::numeric_limits<double>::infinity();

PointView view_of(double distance_m,
                  const std::array<double, 2>& field_deg,
                  double wavelength_nm,
                  std::uint32_t samples)
{
    return {.distance_m = distance_m,
            .field_deg = {field_deg[0], field_deg[1]},
            .wavelength_nm = wavelength_nm,
            .samples = samples};
}

// What `compute` gives, computed while other Python threads run.
template <typename Compute>
auto without_gil(const Compute& compute)
{
    const py::gil_scoped_release release;
    return compute();
}

std::vector<double> numbers(const Array<double>& array)
{
    return {array.data(), array.data() + array.size()};
}

py::array_t<double> array_like(const std::vector<double>& values, const py::array& shape)
{
    py::array_t<double> array(
        std::vector<py::ssize_t>(shape.shape(), shape.shape() + shape.ndim()));
    std::copy(values.begin(), values.end(), array.mutable_data());
    return array;
}

py::tuple spot(const EyeModel& eye,
               double distance_m,
               const std::array<double, 2>& field_deg,
               double wavelength_nm,
               std::uint32_t samples)
{
    const PointView view = view_of(distance_m, field_deg, wavelength_nm, samples);
    const SpotDiagram diagram = without_gil([&] { return spot_diagram(eye, view); });
    const auto count = static_cast<py::ssize_t>(diagram.weights.size());
    py::array_t<double> points({count, py::ssize_t{2}});
    double* to = points.mutable_data();
    for (const V2d& point_arcmin : diagram.points_arcmin) {
        *to++ = point_arcmin.x;
        *to++ = point_arcmin.y;
    }
    return py::make_tuple(points, py::array_t<double>(count, diagram.weights.data()));
}

py::array_t<double> psf_array(const EyeModel& eye,
                              double distance_m,
                              double size_arcmin,
                              int resolution,
                              double wavelength_nm,
                              const std::array<double, 2>& field_deg,
                              std::uint32_t samples)
{
    const PointView view = view_of(distance_m, field_deg, wavelength_nm, samples);
    const auto pixels = without_gil([&] { return psf(eye, view, size_arcmin, resolution); });
    return py::array_t<double>({resolution, resolution}, pixels.data());
}

py::array_t<double> mtf_array(const EyeModel& eye,
                              const Array<double>& frequencies_cpd,
                              double distance_m,
                              double meridian_deg,
                              bool diffraction,
                              double wavelength_nm,
                              const std::array<double, 2>& field_deg,
                              std::uint32_t samples)
{
    const PointView view = view_of(distance_m, field_deg, wavelength_nm, samples);
    const std::vector<double> frequencies = numbers(frequencies_cpd);
    return array_like(
        without_gil([&] { return mtf(eye, view, frequencies, meridian_deg, diffraction); }),
        frequencies_cpd);
}

py::array_t<double> through_focus_array(const EyeModel& eye,
                                        const Array<double>& vergences_d,
                                        double wavelength_nm,
                                        const std::array<double, 2>& field_deg,
                                        std::uint32_t samples)
{
    const PointView view = view_of(infinity, field_deg, wavelength_nm, samples);
    const std::vector<double> vergences = numbers(vergences_d);
    return array_like(without_gil([&] { return through_focus_arcmin(eye, view, vergences); }),
                      vergences_d);
}

py::object ray_counts(const EyeModel& eye,
                      const std::array<double, 2>& field_deg,
                      double wavelength_nm,
                      std::uint32_t samples)
{
    using namespace py::literals;
    const PointView view = view_of(infinity, field_deg, wavelength_nm, samples);
    const RayCounts counts = without_gil([&] { return spot_diagram(eye, view).counts; });
    return py::dict("transmitted"_a = counts.transmitted, "vignetted"_a = counts.vignetted,
                    "missed"_a = counts.missed, "total_reflection"_a = counts.total_reflection);
}

}  // namespace

void bind_analysis(py::module_& m)
{
    using namespace py::literals;

    constexpr std::array axis{0.0, 0.0};
    constexpr std::uint32_t samples = PointView{}.samples;
    constexpr std::uint32_t psf_samples = 1 << 18;
    constexpr double wavelength_nm = reference_wavelength_nm;

    auto eye = py::reinterpret_borrow<EyeClass>(m.attr("Eye"));
    eye.def(
           "spot", &spot, "distance_m"_a = infinity, "field_deg"_a = axis,
           "wavelength_nm"_a = wavelength_nm, "samples"_a = 4096,
           "(points_arcmin (n, 2), weights (n,)): where a point's light appears, relative to the\n"
           "chief ray, +X right and +Y up as the patient sees; rays that are lost are left out.")
        .def("ray_counts", &ray_counts, "field_deg"_a = axis, "wavelength_nm"_a = wavelength_nm,
             "samples"_a = samples, "How many rays are transmitted, and how many lost, by fate.")
        .def(
            "spot_ellipse",
            [](const EyeModel& model, double distance_m, const std::array<double, 2>& field_deg,
               double nm, std::uint32_t count) {
                const PointView view = view_of(distance_m, field_deg, nm, count);
                return without_gil([&] { return spot_ellipse(model, view); });
            },
            "distance_m"_a = infinity, "field_deg"_a = axis, "wavelength_nm"_a = wavelength_nm,
            "samples"_a = samples,
            "The evenly filled ellipse with the spot's second moments, for every model.")
        .def("psf", &psf_array, "distance_m"_a = infinity, "size_arcmin"_a = 60.0,
             "resolution"_a = 128, "wavelength_nm"_a = wavelength_nm, "field_deg"_a = axis,
             "samples"_a = psf_samples,
             "The geometrical point spread function, (resolution, resolution), rows bottom-up,\n"
             "its centre the chief ray. Sums to 1, or less if the square does not hold it all.")
        .def("mtf", &mtf_array, "frequencies_cpd"_a, "distance_m"_a = infinity,
             "meridian_deg"_a = 0.0, "diffraction"_a = false, "wavelength_nm"_a = wavelength_nm,
             "field_deg"_a = axis, "samples"_a = samples,
             "The geometrical modulation transfer, of the rays alone. meridian_deg: across the\n"
             "grating's bars, 0 for vertical bars. diffraction: that of the waves as well.")
        .def("through_focus", &through_focus_array, "vergences_d"_a,
             "wavelength_nm"_a = wavelength_nm, "field_deg"_a = axis, "samples"_a = samples,
             "RMS radius of the spot in arcmin for each object vergence.")
        .def(
            "is_diffraction_limited",
            [](const EyeModel& model, double distance_m, double nm) {
                const PointView view = view_of(distance_m, {}, nm, samples);
                return without_gil([&] { return is_diffraction_limited(model, view); });
            },
            "distance_m"_a = infinity, "wavelength_nm"_a = wavelength_nm,
            "Whether the geometrical blur is shorter than the Airy disk; rays alone are then too\n"
            "sharp.")
        .def_property_readonly(
            "best_focus_d",
            [](const EyeModel& model) { return without_gil([&] { return best_focus_d(model); }); },
            "Vergence of the smallest RMS spot on the axis at 555 nm; None for a pinhole.")
        .def_property_readonly("pupil_mm", &pupil_mm);

    py::class_<ClearRange>(m, "ClearRange", "What an eye sees sharply, as vergences.")
        .def_readonly("meridian_deg", &ClearRange::meridian_deg,
                      "Of the pupil, counter-clockwise from +X as the patient sees; None: the "
                      "mean.")
        .def_readonly("far_d", &ClearRange::far_d)
        .def_readonly("near_d", &ClearRange::near_d);

    m.def(
        "clear_ranges",
        [](const EyeModel& relaxed, const EyeModel& accommodated) {
            return without_gil([&] { return clear_ranges(relaxed, accommodated); });
        },
        "relaxed"_a, "accommodated"_a,
        "From far to near point: the mean, then the principal meridians of a toric eye.");
    m.def(
        "diffraction_mtf",
        [](const Array<double>& frequencies_cpd, double pupil_mm, double nm) {
            return array_like(diffraction_mtf(numbers(frequencies_cpd), pupil_mm, nm),
                              frequencies_cpd);
        },
        "frequencies_cpd"_a, "pupil_mm"_a, "wavelength_nm"_a = wavelength_nm,
        "The modulation transfer of a perfect eye, which none exceeds.");
    m.def("airy_radius_arcmin", &airy_radius_arcmin, "pupil_mm"_a,
          "wavelength_nm"_a = wavelength_nm);
    m.def("quarter_wave_d", &quarter_wave_d, "pupil_mm"_a, "wavelength_nm"_a = wavelength_nm,
          "The defocus that makes a quarter of a wave at the pupil's edge.");
    m.def(
        "observer_eye",
        [](const Observer& observer, double pupil_mm, double accommodation_d) {
            return std::shared_ptr<EyeModel>(eye_in_state(observer, pupil_mm, accommodation_d));
        },
        "observer"_a, "pupil_mm"_a, "accommodation_d"_a = 0.0,
        "The eye that an observer looks with, in that state.");
}

}  // namespace eye_render
