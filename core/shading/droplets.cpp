#include "shading/droplets.h"

#include "shading/input_range.h"

#include <cmath>

namespace eye_render {

DropletScattering scattering_of_droplets(float diameter_um)
{
    constexpr float largest_um = 50.0f;
    const float d = in_range(diameter_um, 0.0f, largest_um);
    const float l = std::log(d);
    if (d <= 0.1f) {  // eq. 11 to 14
        return {.narrow = {.g = 13.8f * d * d},
                .wide = {.g = 1.1456f * d * std::sin(9.29044f * d), .alpha = 250.0f},
                .wide_share = 0.252977f - 312.983f * std::pow(d, 4.3f)};
    }
    if (d < 1.5f) {  // eq. 15 to 18
        const float wave = std::cos((l - 0.238604f) * (l + 1.00667f) / (0.507522f - 0.15677f * l));
        return {.narrow = {.g = 0.862f - 0.143f * l * l},
                .wide = {.g = 0.379685f * std::cos(1.19692f * wave + 1.37932f * l + 0.0625835f) +
                              0.344213f,
                         .alpha = 250.0f},
                .wide_share =
                    0.146209f * std::cos(3.38707f * l + 2.11193f) + 0.316072f + 0.0778917f * l};
    }
    if (d < 5.0f) {  // eq. 19 to 22
        const float ll = std::log(l);
        return {.narrow = {.g = 0.0604931f * ll + 0.940256f},
                .wide = {.g = 0.500411f - 0.081287f / (-2.0f * l + std::tan(l) + 1.27551f),
                         .alpha = 7.30354f * l + 6.31675f},
                .wide_share =
                    0.026914f * (l - std::cos(5.68947f * (ll - 0.0292149f))) + 0.376475f};
    }
    // eq. 7 to 10
    return {.narrow = {.g = std::exp(-0.0990567f / (d - 1.67154f))},
            .wide = {.g = std::exp(-2.20679f / (d + 3.91029f) - 0.428934f),
                     .alpha = std::exp(3.62489f - 8.29288f / (d + 5.52825f))},
            .wide_share = std::exp(-0.599085f / (d - 0.641583f) - 0.665888f)};
}

}  // namespace eye_render
