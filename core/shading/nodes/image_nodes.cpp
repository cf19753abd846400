// Pictures laid on a surface or around the scene. Textures are numbers of the scene.

#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"
#include "shading/picture_coordinates.h"

#include <array>
#include <cmath>
#include <map>

namespace eye_render {

namespace {

using enum SocketType;
using Made = std::unique_ptr<const ValueNode>;

enum class Projection { Flat, Box, Sphere, Tube };

// One picture, or the tiles of a UDIM set by their number (1001 is the square from 0 to 1).
class Picture {
public:
    // `tiles` is number, texture, number, texture, ….
    Picture(int texture, const std::vector<float>& tiles, NodeResources& resources)
        : texture_(texture)
    {
        if (tiles.empty()) {
            resources.require_texture(texture);
        }
        for (std::size_t i = 0; i + 1 < tiles.size(); i += 2) {
            const int tile = static_cast<int>(tiles[i + 1]);
            resources.require_texture(tile);
            tiles_[static_cast<int>(tiles[i])] = tile;
        }
    }

    [[nodiscard]] Color4f look_up(const HitAttributes& attributes,
                                  const V2f& uv,
                                  TextureAlpha alpha) const
    {
        if (tiles_.empty()) {
            return attributes.texture(texture_, uv, alpha);
        }
        // Towards zero, as Cycles counts: what is less than 1 below belongs to the first tiles.
        constexpr float columns = 10.0f;
        constexpr float rows = 100.0f;
        const V2f corner(std::trunc(uv.x), std::trunc(uv.y));
        const bool is_in_grid =
            corner.x >= 0.0f && corner.x < columns && corner.y >= 0.0f && corner.y < rows;
        const auto tile =
            is_in_grid
                ? tiles_.find(1001 + static_cast<int>(corner.x) + 10 * static_cast<int>(corner.y))
                : tiles_.end();
        return tile == tiles_.end() ? missing_tile
                                    : attributes.texture(tile->second, uv - corner, alpha);
    }

private:
    // Magenta, as all pictures that are missing.
    static inline const Color4f missing_tile{1.0f, 0.0f, 1.0f, 1.0f};

    int texture_;
    std::map<int, int> tiles_;
};

class ImageTextureNode final : public ValueNode {
public:
    ImageTextureNode(Picture picture, Projection projection, float blend)
        : picture_(std::move(picture)), projection_(projection), blend_(blend)
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        // Nobody who leaves the alpha away wants the colour that hides behind it.
        const TextureAlpha alpha = in.wants(1) ? TextureAlpha::Straight : TextureAlpha::Associated;
        const Color4f c = look_up(in.hit(), in.vector(0), alpha);
        out[0] = {c.r, c.g, c.b};
        out[1] = NodeValue(c.a);
    }

private:
    [[nodiscard]] Color4f look_up(const Hit& hit, const V3f& p, TextureAlpha alpha) const
    {
        switch (projection_) {
        case Projection::Sphere: return picture_.look_up(hit.attributes, uv_on_sphere(p), alpha);
        case Projection::Tube: return picture_.look_up(hit.attributes, uv_on_tube(p), alpha);
        case Projection::Box: return look_up_box(hit, p, alpha);
        default: return picture_.look_up(hit.attributes, {p.x, p.y}, alpha);
        }
    }

    [[nodiscard]] Color4f look_up_box(const Hit& hit, const V3f& p, TextureAlpha alpha) const
    {
        V3f normal;
        hit.attributes.object().world_from_object.transposed().multDirMatrix(hit.point.ns, normal);
        const V3f weights = box_weights(normal, blend_);
        Color4f sum(0.0f);
        for (int side = 0; side < 3; ++side) {
            if (weights[side] > 0.0f) {
                sum += picture_.look_up(hit.attributes, uv_on_box(p, side, normal[side] < 0.0f),
                                        alpha) *
                       weights[side];
            }
        }
        return sum;
    }

    Picture picture_;
    Projection projection_;
    float blend_;
};

class EnvironmentTextureNode final : public ValueNode {
public:
    EnvironmentTextureNode(int texture, bool is_mirror_ball)
        : texture_(texture), is_mirror_ball_(is_mirror_ball)
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const V3f direction = in.vector(0);
        const Color4f c =
            in.hit().attributes.texture(texture_,
                                        is_mirror_ball_ ? uv_on_mirror_ball(direction.normalized())
                                                        : uv_equirectangular(direction),
                                        TextureAlpha::Associated);
        out[0] = {c.r, c.g, c.b};
    }

private:
    int texture_;
    bool is_mirror_ball_;
};

Made make_image_texture(const NodeOptions& options, NodeResources& resources)
{
    return std::make_unique<ImageTextureNode>(
        Picture(static_cast<int>(options.number("texture", -1.0)), options.numbers("tiles"),
                resources),
        options.choice<Projection>("projection", {{"FLAT", Projection::Flat},
                                                  {"BOX", Projection::Box},
                                                  {"SPHERE", Projection::Sphere},
                                                  {"TUBE", Projection::Tube}}),
        static_cast<float>(options.number("projection_blend", 0.0)));
}

Made make_environment_texture(const NodeOptions& options, NodeResources& resources)
{
    const int texture = static_cast<int>(options.number("texture", -1.0));
    resources.require_texture(texture);
    return std::make_unique<EnvironmentTextureNode>(
        texture,
        options.choice<bool>("projection", {{"EQUIRECTANGULAR", false}, {"MIRROR_BALL", true}}));
}

constexpr std::array image_in{InputSocket{"Vector", Vector, NodeValue(0.0f), ImplicitInput::Uv}};
constexpr std::array environment_in{
    InputSocket{"Vector", Vector, NodeValue(0.0f), ImplicitInput::Position}};
constexpr std::array image_out{OutputSocket{"Color", Color}, OutputSocket{"Alpha", Number}};
constexpr std::array environment_out{OutputSocket{"Color", Color}};
constexpr std::array<std::string_view, 4> image_options{"texture", "tiles", "projection",
                                                        "projection_blend"};
constexpr std::array<std::string_view, 2> environment_options{"texture", "projection"};

}  // namespace

std::span<const NodeType> image_texture_nodes()
{
    static const std::array nodes{
        value_node("TEX_IMAGE", Reads::Hit, image_in, image_out, make_image_texture,
                   image_options),
        value_node("TEX_ENVIRONMENT", Reads::Hit, environment_in, environment_out,
                   make_environment_texture, environment_options),
    };
    return nodes;
}

}  // namespace eye_render
