// eyecore.Prescription.

#include "api/eye.h"
#include "module.h"

namespace eye_render {

namespace {

std::string side_name(EyeSide side)
{
    switch (side) {
    case EyeSide::Right: return "OD";
    case EyeSide::Left: return "OS";
    case EyeSide::Both: return "OU";
    case EyeSide::Unspecified: break;
    }
    return "";
}

EyeSide side_named(const std::string& name)
{
    for (const EyeSide side :
         {EyeSide::Unspecified, EyeSide::Right, EyeSide::Left, EyeSide::Both}) {
        if (side_name(side) == name) {
            return side;
        }
    }
    throw std::invalid_argument("eye is '" + name + "'; expected OD, OS, OU or nothing");
}

py::tuple power_matrix_tuple(const PowerMatrix& m)
{
    return py::make_tuple(py::make_tuple(m.xx_d, m.xy_d), py::make_tuple(m.xy_d, m.yy_d));
}

}  // namespace

void bind_prescription(py::module_& m)
{
    using namespace py::literals;

    py::class_<Prescription>(m, "Prescription", "Power of the correcting lens, axis TABO.")
        .def(py::init([](double sphere_d, double cylinder_d, double axis_deg, double add_d,
                         double base_in_pd, double base_up_pd, const std::string& eye) {
                 const Prescription rx{.sphere_d = sphere_d,
                                       .cylinder_d = cylinder_d,
                                       .axis_deg = axis_deg,
                                       .add_d = add_d,
                                       .base_in_pd = base_in_pd,
                                       .base_up_pd = base_up_pd,
                                       .eye = side_named(eye)};
                 require_valid(rx);
                 return rx;
             }),
             "sphere_d"_a = 0.0, "cylinder_d"_a = 0.0, "axis_deg"_a = 180.0, "add_d"_a = 0.0,
             py::kw_only(), "base_in_pd"_a = 0.0, "base_up_pd"_a = 0.0, "eye"_a = "",
             "Prisms in prism dioptres, negative base out or down; eye: OD, OS, OU or nothing.")
        .def_static(
            "parse", &parse_prescription, "text"_a,
            "From the usual notations, such as '-2.00DS -0.75DC 160A'. ValueError says why\n"
            "a text is none.")
        .def_readonly("sphere_d", &Prescription::sphere_d)
        .def_readonly("cylinder_d", &Prescription::cylinder_d)
        .def_readonly("axis_deg", &Prescription::axis_deg)
        .def_readonly("add_d", &Prescription::add_d)
        .def_readonly("base_in_pd", &Prescription::base_in_pd)
        .def_readonly("base_up_pd", &Prescription::base_up_pd)
        .def_property_readonly("eye", [](const Prescription& rx) { return side_name(rx.eye); })
        .def("text", &format_prescription)
        .def("__str__", &format_prescription)
        .def("__repr__",
             [](const Prescription& rx) {
                 return "Prescription('" + format_prescription(rx) + "')";
             })
        .def("transposed", &transposed, "The same lens in the other cylinder form.")
        .def("crossed", &crossed, "other"_a,
             "The lens that both make in contact, whatever their axes; the side is the first's.")
        .def(
            "meridional_power",
            [](const Prescription& rx, double meridian_deg) {
                const MeridionalPower power =
                    meridional_power(power_matrix_tabo(rx), meridian_deg);
                return py::make_tuple(power.curvital_d, power.torsional_d);
            },
            "meridian_deg"_a,
            "(curvital, torsional) in dioptres, TABO frame: how much a ray that enters on the\n"
            "meridian is bent along it, and how much out of it.")
        .def(
            "power_vector",
            [](const Prescription& rx) {
                const PowerVector v = power_vector(rx);
                return py::make_tuple(v.m_d, v.j0_d, v.j45_d);
            },
            "(M, J0, J45) in dioptres, TABO frame.")
        .def(
            "power_matrix",
            [](const Prescription& rx) { return power_matrix_tuple(power_matrix_camera(rx)); },
            "Dioptric power matrix in the camera frame.")
        .def(
            "__eq__", [](const Prescription& a, const Prescription& b) { return a == b; },
            py::is_operator());
}

}  // namespace eye_render
