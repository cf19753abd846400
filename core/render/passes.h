// The one table of render passes; the film, the bindings and the add-on read it. Names are
// Blender's.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eye_render {

enum class Pass {
    Combined,
    Depth,
    Mist,
    Position,
    Normal,
    Uv,
    Vector,
    ObjectIndex,
    MaterialIndex,
    DiffuseDirect,
    DiffuseIndirect,
    DiffuseColor,
    GlossyDirect,
    GlossyIndirect,
    GlossyColor,
    TransmissionDirect,
    TransmissionIndirect,
    TransmissionColor,
    VolumeDirect,
    VolumeIndirect,
    Emission,
    Environment,
    AmbientOcclusion,
    Shadow,
    ShadowCatcher,
    DenoisingNormal,
    DenoisingAlbedo,
    Defocus,
    Blur,
    CryptoObject,
    CryptoMaterial,
    CryptoAsset,
    LightGroup,
    AovValue,
    AovColor,
    SampleWeight,
};

inline constexpr std::size_t pass_count = static_cast<std::size_t>(Pass::SampleWeight) + 1;

enum class PassSource {
    // The mean over all samples of some of the light, channel by channel: blurred and filtered as
    // Combined is, and part of its sum.
    Light,
    // The mean over all samples of what is there, whatever light falls on it: blurred and filtered
    // as Combined is, so that it fits the picture at each pixel.
    Surface,
    // What the ray through the pixel's centre and the pupil's centre meets, which neither blur nor
    // antialiasing mixes with its neighbours.
    Chief,
    // The things that the samples met, and how many of them: the rows of one pass are a number of
    // pictures, named by a number after the name, with two things each.
    Coverage,
    // Of the film itself.
    Film,
};

struct PassInfo {
    Pass pass;
    std::string_view name;
    std::string_view channel_ids;
    PassSource source;
    // Light that a surface scattered is given without the surface's colour, as Blender has it: the
    // mean of the light over the mean of this pass. Their product is part of Combined, and a mean.
    std::optional<Pass> divisor{};
    // A picture each for some of the names that the scene gives, the pass's own before them.
    bool is_named = false;

    [[nodiscard]] constexpr std::size_t channels() const { return channel_ids.size(); }
};

// Of one kind of Cryptomatte: 16 things are the most that Blender asks for.
inline constexpr int most_crypto_pictures = 8;

// Depth of nothing, as Blender's own engines write it.
inline constexpr float background_depth = 1e10f;

inline constexpr std::array pass_table{
    PassInfo{Pass::Combined, "Combined", "RGBA", PassSource::Light},
    // Distance along the viewing axis, scene units.
    PassInfo{Pass::Depth, "Depth", "Z", PassSource::Chief},
    // 0 where mist begins, 1 where nothing is seen through it: by distance, not depth. A mean, so
    // that what is mixed by it has the picture's own blur.
    PassInfo{Pass::Mist, "Mist", "Z", PassSource::Surface},
    // In the world.
    PassInfo{Pass::Position, "Position", "XYZ", PassSource::Chief},
    // In the world, turned to the eye. A mean, as Cycles has it.
    PassInfo{Pass::Normal, "Normal", "XYZ", PassSource::Surface},
    // By the active UV map, and how much of the pixel has one. A mean, as Cycles has it: over a
    // smooth map it is that of the pixel's middle, and pictures laid on by it have soft edges.
    PassInfo{Pass::Uv, "UV", "UVA", PassSource::Surface},
    // How far the place has come in the picture while the shutter is open, pixels to the right
    // and up: where it was when the shutter opened, less where it is half way; and where it is
    // half way, less where it will be when the shutter closes.
    PassInfo{Pass::Vector, "Vector", "XYZW", PassSource::Chief},
    // Numbers that stand for things: means of them would stand for others.
    PassInfo{Pass::ObjectIndex, "Object Index", "X", PassSource::Chief},
    PassInfo{Pass::MaterialIndex, "Material Index", "X", PassSource::Chief},
    // Light by what the first surface did with it: direct if it came from a light, indirect if it
    // was scattered before. Through straight passages the first surface is the next one.
    PassInfo{Pass::DiffuseDirect, "Diffuse Direct", "RGB", PassSource::Light, Pass::DiffuseColor},
    PassInfo{Pass::DiffuseIndirect, "Diffuse Indirect", "RGB", PassSource::Light,
             Pass::DiffuseColor},
    PassInfo{Pass::DiffuseColor, "Diffuse Color", "RGB", PassSource::Surface},
    PassInfo{Pass::GlossyDirect, "Glossy Direct", "RGB", PassSource::Light, Pass::GlossyColor},
    PassInfo{Pass::GlossyIndirect, "Glossy Indirect", "RGB", PassSource::Light, Pass::GlossyColor},
    PassInfo{Pass::GlossyColor, "Glossy Color", "RGB", PassSource::Surface},
    PassInfo{Pass::TransmissionDirect, "Transmission Direct", "RGB", PassSource::Light,
             Pass::TransmissionColor},
    PassInfo{Pass::TransmissionIndirect, "Transmission Indirect", "RGB", PassSource::Light,
             Pass::TransmissionColor},
    PassInfo{Pass::TransmissionColor, "Transmission Color", "RGB", PassSource::Surface},
    // The same of light that a volume scattered first.
    PassInfo{Pass::VolumeDirect, "Volume Direct", "RGB", PassSource::Light},
    PassInfo{Pass::VolumeIndirect, "Volume Indirect", "RGB", PassSource::Light},
    // Light that nothing scattered: of surfaces, and of the world, which a transparent film keeps
    // here though not in Combined.
    PassInfo{Pass::Emission, "Emission", "RGB", PassSource::Light},
    PassInfo{Pass::Environment, "Environment", "RGB", PassSource::Light},
    // The part of the sky over a surface that nothing near covers.
    PassInfo{Pass::AmbientOcclusion, "Ambient Occlusion", "RGB", PassSource::Surface},
    // The mean over all lamps of how much of each one's light gets to a surface; 0 of one that is
    // behind it.
    PassInfo{Pass::Shadow, "Shadow", "RGB", PassSource::Surface},
    // What the light on shadow catchers must be multiplied by to be as it is with the objects.
    PassInfo{Pass::ShadowCatcher, "Shadow Catcher", "RGB", PassSource::Film},
    // Of the first surface that is not smooth, as seen in what is, or of what shines: in the
    // camera's space, +Z ahead, and the colour, at most white. Means, blurred as what is to be
    // denoised by them.
    PassInfo{Pass::DenoisingNormal, "Denoising Normal", "XYZ", PassSource::Surface},
    PassInfo{Pass::DenoisingAlbedo, "Denoising Albedo", "RGB", PassSource::Surface},
    // Mean of the paraxial E = K - I/x, dioptres: positive where the eye is focused nearer than
    // the surface.
    PassInfo{Pass::Defocus, "Defocus", "X", PassSource::Chief},
    // Major diameter of the paraxial blur ellipse, arcmin: of focus and astigmatism as next to the
    // axis, without aberrations of higher order.
    PassInfo{Pass::Blur, "Blur", "X", PassSource::Chief},
    // Cryptomatte: blur and antialiasing are coverage.
    PassInfo{Pass::CryptoObject, "CryptoObject", "rgba", PassSource::Coverage},
    PassInfo{Pass::CryptoMaterial, "CryptoMaterial", "rgba", PassSource::Coverage},
    PassInfo{Pass::CryptoAsset, "CryptoAsset", "rgba", PassSource::Coverage},
    // Of the light of one group of lamps, objects and the world: part of Combined.
    PassInfo{.pass = Pass::LightGroup,
             .name = "Combined_",
             .channel_ids = "RGB",
             .source = PassSource::Light,
             .is_named = true},
    // What materials and the world write out for compositors, where the camera sees them.
    PassInfo{.pass = Pass::AovValue,
             .name = "",
             .channel_ids = "X",
             .source = PassSource::Surface,
             .is_named = true},
    PassInfo{.pass = Pass::AovColor,
             .name = "",
             .channel_ids = "RGBA",
             .source = PassSource::Surface,
             .is_named = true},
    // By what Combined was divided, channel by channel, and in A the other means: the number of
    // samples, unless wavelengths or points of the pupil count differently. Pictures I of sample
    // ranges, with weights W, make the whole: sum(W I) / sum(W), if I is a mean.
    PassInfo{Pass::SampleWeight, "Sample Weight", "RGBA", PassSource::Film},
};

static_assert(pass_table.size() == pass_count);

[[nodiscard]] constexpr const PassInfo& info(Pass pass)
{
    return pass_table[static_cast<std::size_t>(pass)];
}

// One picture that a render delivers.
struct PassRequest {
    // NOLINTNEXTLINE(google-explicit-constructor): most passes are one picture
    PassRequest(Pass wanted, int picture = 0) : pass(wanted), number(picture) {}
    PassRequest(Pass wanted, std::string of) : pass(wanted), label(std::move(of)) {}

    Pass pass;
    int number = 0;     // among the pictures of Cryptomatte
    std::string label;  // of the light group or value

    [[nodiscard]] std::string name() const;

    bool operator==(const PassRequest&) const = default;
};

// By what PassRequest::name gives.
[[nodiscard]] std::optional<PassRequest> pass_named(std::string_view name);

}  // namespace eye_render
