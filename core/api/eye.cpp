#include "api/eye.h"

#include "base/error.h"
#include "base/units.h"

#include <stdexcept>

namespace eye_render {

std::unique_ptr<EyeModel> make_eye(const EyeDescription& description)
{
    return make_eye(EyeSpec{.model = description.model,
                            .rx = description.rx,
                            .rx_plane = description.rx_plane,
                            .vertex_m = m_from_mm(description.vertex_mm),
                            .pupil_diameter_m = m_from_mm(description.pupil_mm),
                            .accommodation_d = description.accommodation_d});
}

BlurEllipse blur_at(const EyeModel& eye, double object_distance_m)
{
    if (!(object_distance_m > 0.0)) {
        throw std::invalid_argument("distance_m is " + number_text(object_distance_m) +
                                    " m; expected above 0");
    }
    return blur_ellipse(eye.retinal_conjugate_d() - PowerMatrix::sphere(1.0 / object_distance_m),
                        eye.pupil_diameter_m());
}

double pupil_diameter_mm(PupilFormula formula, const PupilConditions& conditions)
{
    return mm_from_m(pupil_size(formula, conditions).diameter_m);
}

}  // namespace eye_render
