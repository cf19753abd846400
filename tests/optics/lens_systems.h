// Eyes with constant indices, as the vectors and the tables list them.

#pragma once

#include "optics/lens_system.h"

#include <vector>

namespace eye_render::test {

struct Layer {
    double radius_mm, conic, thickness_mm, index;  // behind the surface
};

// The stop at the front vertex of the lens: the last surface but one.
inline LensSystem lens_system(const std::vector<Layer>& layers, double retina_radius_mm = -12.0)
{
    LensSystem system;
    double vertex_mm = 0.0;
    for (const Layer& layer : layers) {
        system.surfaces.push_back({.shape = ConicSurface::of_revolution(
                                       vertex_mm * 1e-3, layer.radius_mm * 1e-3, layer.conic),
                                   .behind = ConstantIndex{layer.index}});
        vertex_mm += layer.thickness_mm;
    }
    system.lens = system.surfaces.size() - 2;
    system.stop_m = system.surfaces[system.lens].shape.vertex_m;
    system.retina = ConicSurface::of_revolution(vertex_mm * 1e-3, retina_radius_mm * 1e-3, 0.0);
    return system;
}

// Navarro, Santamaria & Bescos 1985 and Le Grand's relaxed full eye, both at 589 nm.
inline LensSystem navarro_589()
{
    return lens_system({{7.72, -0.26, 0.55, 1.376},
                        {6.5, 0.0, 3.05, 1.3374},
                        {10.2, -3.1316, 4.0, 1.42},
                        {-6.0, -1.0, 16.40398, 1.336}});
}

inline LensSystem le_grand_589()
{
    return lens_system({{7.8, 0.0, 0.55, 1.3771},
                        {6.5, 0.0, 3.05, 1.3374},
                        {10.2, 0.0, 4.0, 1.42},
                        {-6.0, 0.0, 16.59655, 1.336}},
                       -13.4);
}

}  // namespace eye_render::test
