// The sheen of fibres: Zeltner, Burley & Chiang 2022, "Practical Multiple-Scattering Sheen Using
// Linearly Transformed Cosines".

#pragma once

namespace eye_render {

// The transform that turns a cosine lobe into the sheen's, in the frame whose x is the viewer's
// side: its inverse maps (x, y, z) to (a x + b z, a y, z).
struct SheenTransform {
    float a;
    float b;
    float albedo;  // share of light that the fibres scatter
};

// Both in [0, 1]; `roughness` is Blender's.
[[nodiscard]] SheenTransform sheen_transform(float roughness, float cos_o);

}  // namespace eye_render
