// How an image is to be read as a texture.

#pragma once

namespace eye_render {

enum class Colorspace { Srgb, Linear, NonColor };  // NonColor: as Linear, and alpha is left alone
enum class Extension { Repeat, Extend, Clip };     // Clip: transparent black outside
enum class Interpolation { Linear, Closest };

struct TextureOptions {
    Colorspace colorspace = Colorspace::Srgb;
    Extension extension = Extension::Repeat;
    Interpolation interpolation = Interpolation::Linear;
};

}  // namespace eye_render
