// eyecore.Eye, and what is known of pupils and accommodation.

#include "eye_options.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

void require_finite(const std::string& name, const V2d& numbers)
{
    for (const double number : {numbers.x, numbers.y}) {
        if (!std::isfinite(number)) {
            throw std::invalid_argument(name + " is " + number_text(number) +
                                        "; expected a finite number");
        }
    }
}

py::tuple rays(const EyeModel& eye,
               const Array<double>& chief_slope,
               const Array<double>& pupil_point_m,
               double wavelength_nm)
{
    const auto slopes = rows<V2d>(chief_slope, "chief_slope");
    const auto points = rows<V2d>(pupil_point_m, "pupil_point_m");
    if (slopes.size() != points.size()) {
        throw std::invalid_argument("chief_slope has " + std::to_string(slopes.size()) +
                                    " rows and pupil_point_m " + std::to_string(points.size()) +
                                    "; expected the same number");
    }
    require_range("wavelength_nm", wavelength_nm, min_wavelength_nm, max_wavelength_nm, "nm");
    for (const V2d& slope : slopes) {
        require_finite("chief_slope", slope);
    }
    // Points that are computed to lie on the pupil's edge may be off by their rounding.
    constexpr double rounding = 1e-9;
    const double radius_m = 0.5 * eye.pupil_diameter_m();
    for (const V2d& point_m : points) {
        require_finite("pupil_point_m", point_m);
        if (point_m.length() > radius_m * (1.0 + rounding)) {
            throw std::invalid_argument("pupil_point_m is " + number_text(point_m.length()) +
                                        " m from the centre; expected 0 to " +
                                        number_text(radius_m) + " m, the pupil's radius");
        }
    }
    const auto count = static_cast<py::ssize_t>(slopes.size());
    py::array_t<double> origin({count, py::ssize_t{3}});
    py::array_t<double> slope({count, py::ssize_t{2}});
    py::array_t<double> weight(count);
    py::array_t<std::uint8_t> fate(count);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const auto row = static_cast<py::ssize_t>(i);
        const EyeRay ray = eye.ray(slopes[i], points[i], wavelength_nm);
        for (int axis = 0; axis < 3; ++axis) {
            origin.mutable_at(row, axis) = ray.origin_eye_m[axis];
        }
        slope.mutable_at(row, 0) = ray.slope.x;
        slope.mutable_at(row, 1) = ray.slope.y;
        weight.mutable_at(row) = ray.weight;
        fate.mutable_at(row) = static_cast<std::uint8_t>(
            std::find(ray_fates.begin(), ray_fates.end(), ray.fate) - ray_fates.begin());
    }
    return py::make_tuple(origin, slope, weight, fate);
}

// Fitting a schematic eye takes seconds, in which other threads of Python go on.
std::shared_ptr<EyeModel> make_eye_from_options(const EyeDescription& description)
{
    const py::gil_scoped_release others_run;
    return make_eye(description);
}

std::string blur_text(const BlurEllipse& blur)
{
    return "BlurEllipse(major_arcmin=" + number_text(blur.major_arcmin) +
           ", minor_arcmin=" + number_text(blur.minor_arcmin) +
           ", angle_deg=" + (blur.angle_deg ? number_text(*blur.angle_deg) : "None") + ")";
}

std::string eye_text(const EyeModel& eye)
{
    const PowerMatrix k = eye.retinal_conjugate_d();
    return "Eye(pupil_mm=" + number_text(mm_from_m(eye.pupil_diameter_m())) +
           ", retinal_conjugate_d=((" + number_text(k.xx_d) + ", " + number_text(k.xy_d) + "), (" +
           number_text(k.xy_d) + ", " + number_text(k.yy_d) + ")))";
}

}  // namespace

void bind_eye(py::module_& m)
{
    using namespace py::literals;

    m.attr("EYE_MODELS") = names_of(eye_model_kinds);
    m.attr("RAY_FATES") = names_of(ray_fates);
    m.attr("REFRACTION_ZEROS") = names_of(refraction_zeros);
    m.attr("AMPLITUDE_FORMULAS") = names_of(amplitude_formulas);
    m.attr("PUPIL_FORMULAS") = names_of(pupil_formulas);
    m.attr("PUPIL_PATTERNS") = names_of(pupil_pattern_kinds);

    py::class_<BlurEllipse>(m, "BlurEllipse", "Full diameters of a point's blur.")
        .def_readonly("major_arcmin", &BlurEllipse::major_arcmin)
        .def_readonly("minor_arcmin", &BlurEllipse::minor_arcmin)
        .def_readonly("angle_deg", &BlurEllipse::angle_deg,
                      "Of the major diameter, counter-clockwise from +X as the patient sees it;\n"
                      "None when round.")
        .def_readonly("rms_radius_arcmin", &BlurEllipse::rms_radius_arcmin)
        .def("__repr__", &blur_text);

    py::class_<EyeDescription> description(m, "EyeDescription", "What Eye is made from.");
    description.def(py::init(&options_from<EyeDescription>), "Attributes by keyword.")
        .def_readwrite("pupil_mm", &EyeDescription::pupil_mm, "Diameter of the entrance pupil.")
        .def_readwrite("accommodation_d", &EyeDescription::accommodation_d,
                       "Of the relaxed eye's power, 0 to max_accommodation_d of the model.");
    define_eye_options(
        description, [](auto& eye) -> auto& { return eye; });

    py::class_<EyeModel, std::shared_ptr<EyeModel>> eye(m, "Eye",
                                                        "An eye as a model sees through it.");
    eye.def(py::init([](const py::kwargs& given) {
                return make_eye_from_options(options_from<EyeDescription>(given));
            }),
            "Attributes of EyeDescription by keyword. ValueError for what no such eye can be.");
    eye.def("rays", &rays, "chief_slope"_a, "pupil_point_m"_a,
            "wavelength_nm"_a = reference_wavelength_nm,
            "(origin_m (n, 3), slope (n, 2), weight (n,), fate (n,)) for chief slopes and pupil\n"
            "points (n, 2); fates are indices of RAY_FATES. Of a lost ray the weight is 0.")
        .def("blur_ellipse", &blur_at, "distance_m"_a = std::numeric_limits<double>::infinity(),
             "The paraxial blur in closed form; spot_ellipse is of all aberrations.")
        .def("line_spread_arcmin", &line_spread_arcmin, "line_deg"_a,
             "distance_m"_a = std::numeric_limits<double>::infinity(),
             "RMS width of a line's paraxial spread across itself, in closed form; line_deg is "
             "the line's\n"
             "own direction, counter-clockwise from +X as the patient sees it.")
        .def_property_readonly(
            "far_point_m", [](const EyeModel& model) { return far_point_m(model); },
            "Distance of the smallest RMS spot on the axis at 555 nm, as in clear_ranges; "
            "infinite\n"
            "for an emmetrope, negative behind the eye of a hyperope.")
        .def_property_readonly("max_accommodation_d", &EyeModel::max_accommodation_d,
                               "The most that the model has, whatever the age allows.")
        .def("__repr__", &eye_text)
        .def_property_readonly("retinal_conjugate_d", [](const EyeModel& model) {
            const PowerMatrix k = model.retinal_conjugate_d();
            return py::make_tuple(py::make_tuple(k.xx_d, k.xy_d), py::make_tuple(k.xy_d, k.yy_d));
        });

    const PupilConditions usual_light;
    m.def(
        "pupil_diameter_mm",
        [](const std::string& formula, double luminance_cd_m2, double area_deg2, double age_years,
           int eyes) {
            return pupil_diameter_mm(named_of("formula", formula, pupil_formulas),
                                     {.luminance_cd_m2 = luminance_cd_m2,
                                      .area_deg2 = area_deg2,
                                      .age_years = age_years,
                                      .eyes = eyes});
        },
        "formula"_a, "luminance_cd_m2"_a, "area_deg2"_a = usual_light.area_deg2,
        "age_years"_a = usual_light.age_years, "eyes"_a = usual_light.eyes,
        "Diameter of the entrance pupil, clamped to 1.5 to 9 mm; luminance is taken as 1e-6 to\n"
        "1e6 cd/m2 (WINN: 9 to 4400) and age as 20 to 83 years. ValueError for a luminance that\n"
        "is negative or NaN.");
    m.def(
        "accommodation_amplitude_d",
        [](double age_years, const std::string& formula) {
            return accommodation_amplitude_d(age_years,
                                             named_of("formula", formula, amplitude_formulas));
        },
        "age_years"_a, "formula"_a = "HOFSTETTER_MEAN", "One of AMPLITUDE_FORMULAS.");
}

}  // namespace eye_render
