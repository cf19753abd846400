// How an image is to be read as a texture.

#pragma once

namespace eye_render {

// What the numbers of an image are. Linear: as the scene's own colours. NonColor: as Linear, and
// alpha is packed.
enum class Colorspace { Srgb, LinearRec709, Linear, NonColor };
enum class Extension { Repeat, Extend, Clip };        // Clip: transparent black outside
enum class Interpolation { Linear, Closest, Cubic };  // Cubic: the uniform B-spline

// What the fourth channel is: how opaque the colour is, a number like any other, or nothing.
enum class AlphaChannel { Opacity, Packed, Ignored };

struct TextureOptions {
    Colorspace colorspace = Colorspace::Srgb;
    Extension extension = Extension::Repeat;
    Interpolation interpolation = Interpolation::Linear;
    AlphaChannel alpha = AlphaChannel::Opacity;

    // Whether colour is multiplied by alpha before it is interpolated.
    [[nodiscard]] bool is_associated() const
    {
        return colorspace != Colorspace::NonColor && alpha == AlphaChannel::Opacity;
    }
};

}  // namespace eye_render
