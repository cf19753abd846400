// Nodes that ask where the hit is, on two bodies as Cycles of Blender 4.3 sees them:
// tests/data/nodes/hits.json, made by tests/tools/hit_references.py.

#include "../shading/asked_node.h"
#include "../shading/node_json.h"
#include "../shading/scattering.h"
#include "scene/mesh_attributes.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <deque>
#include <fstream>

namespace eye_render {
namespace {

using test::AnyResources;
using test::AskedNode;
using test::Json;
using test::options_of;

V3f vector_of(const Json& value)
{
    return {value.at(0).get<float>(), value.at(1).get<float>(), value.at(2).get<float>()};
}

// Blender writes matrices for column vectors.
M44d matrix_of(const Json& rows)
{
    M44d m;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            m[j][i] = rows[std::size_t(i)][std::size_t(j)].get<double>();
        }
    }
    return m;
}

class BesideCycles : public testing::Test {
protected:
    // A place that a pixel shows.
    struct Place {
        Place(std::size_t shown_by, const SurfaceHit& met, const SceneFrame& frame)
            : pixel(shown_by), is_flat(met.placement->mesh()->normal_domain == NormalDomain::Flat),
              hit(met), attributes(*hit.placement,
                                   hit.placement->pose,
                                   hit.primitive,
                                   hit.u,
                                   hit.v,
                                   hit.time,
                                   frame)
        {
        }

        std::size_t pixel;
        bool is_flat;
        SurfaceHit hit;
        MeshAttributes attributes;
    };

    BesideCycles()
    {
        std::ifstream file(std::string(EYE_TEST_DATA_DIR) + "/nodes/hits.json");
        table_ = Json::parse(file);
        data_.uv_layer_names = {"", "second", "absent"};
        data_.attribute_names = {"paint", "weight"};
        data_.attribute_names.resize(test::tangents + 1, "absent");
        data_.materials.push_back(plain_material("BSDF_DIFFUSE", {}));
        data_.materials[0].pass_index = table_["material_index"];
        for (const Json& body : table_["bodies"]) {
            add(body);
        }
        add_pictures();
        const M44d world_from_camera = matrix_of(table_["world_from_camera"]);
        frame_.eye_position_world = world_from_camera.translation();
        frame_.view.camera_from_world = M44f(world_from_camera.inverse());
        const V2f half(table_["half_slope"][0].get<float>(), table_["half_slope"][1].get<float>());
        frame_.view.slope_first = -half;
        frame_.view.slope_last = half;
        frame_.textures = &data_.textures;
        scene_ = std::make_unique<Scene>(data_, frame_.eye_position_world);
        meet_bodies();
    }

    // The value of an input: a number, three of them, or another node's output there.
    [[nodiscard]] NodeValue input_at(const Json& value, const Hit& hit) const
    {
        if (!value.is_array()) {
            return NodeValue(value.get<float>());
        }
        if (!value[0].is_string()) {
            return vector_of(value);
        }
        const std::string node = value[0];
        return AskedNode{.type = node}(value[1].get<std::string>(), hit);
    }

    // Names have numbers of their own here.
    [[nodiscard]] NodeValue asked(const Json& reference,
                                  const std::string& output,
                                  const Hit& hit) const
    {
        const std::string type = reference["node"];
        AskedNode node{.type = type, .options = options_of(reference["options"]), .names = names_};
        for (const auto& [input, value] : reference["inputs"].items()) {
            node.inputs[input] = input_at(value, hit);
        }
        return node(output, hit);
    }

    // Cycles lays tangents by mikktspace, which blends them on smooth surfaces.
    [[nodiscard]] static bool needs_flat(const Json& reference)
    {
        const Json& options = reference["options"];
        return options.value("direction_type", "") == "UV_MAP" ||
               options.value("space", "") == "TANGENT";
    }

    Json table_;
    SceneData data_;
    SceneFrame frame_;
    std::unique_ptr<Scene> scene_;
    std::deque<Place> places_;

private:
    void add(const Json& body)
    {
        Mesh mesh;
        for (const Json& p : body["positions"]) {
            mesh.positions.push_back(vector_of(p));
        }
        for (const Json& n : body["normals"]) {
            mesh.normals.push_back(vector_of(n));
        }
        mesh.normal_domain = mesh.normals.empty() ? NormalDomain::Flat : NormalDomain::PerVertex;
        for (const Json& t : body["triangles"]) {
            mesh.triangles.push_back(
                {t[0].get<std::uint32_t>(), t[1].get<std::uint32_t>(), t[2].get<std::uint32_t>()});
        }
        for (const auto& [name, values] : body["uvs"].items()) {
            UvLayer layer{.name = name, .per_corner = {}};
            for (const Json& uv : values) {
                layer.per_corner.emplace_back(uv[0].get<float>(), uv[1].get<float>());
            }
            mesh.uv_layers.push_back(std::move(layer));
        }
        for (const auto& [name, values] : body["attributes"].items()) {
            Attribute attribute{.name = name, .per_corner = {}};
            for (const Json& c : values) {
                attribute.per_corner.emplace_back(c[0].get<float>(), c[1].get<float>(),
                                                  c[2].get<float>(), c[3].get<float>());
            }
            mesh.attributes.push_back(std::move(attribute));
        }
        const Json& c = body["color"];
        data_.instances.push_back({.geometry = data_.geometries.size(),
                                   .world_from_object = matrix_of(body["world_from_object"]),
                                   .materials = {0},
                                   .look = {.color = Color4f(c[0].get<float>(), c[1].get<float>(),
                                                             c[2].get<float>(), c[3].get<float>()),
                                            .pass_index = body["pass_index"].get<float>()}});
        data_.geometries.push_back(std::move(mesh));
    }

    void add_pictures()
    {
        const auto smooth = table_["picture"].get<std::vector<float>>();
        data_.textures.add_pixels("smooth", PixelsF32{8, 4, smooth},
                                  {.colorspace = Colorspace::NonColor});
        for (const Json& tile : table_["tiles"]) {
            const V3f color = vector_of(tile);
            const std::vector<float> pixel{color.x, color.y, color.z, 1.0f};
            data_.textures.add_pixels("tile", PixelsF32{1, 1, pixel},
                                      {.colorspace = Colorspace::NonColor});
        }
    }

    // A picture's rays pass a little beside the middle of its pixels, so they are aimed at what
    // Cycles says that it saw.
    void meet_bodies()
    {
        const Json* seen = nullptr;
        for (const Json& reference : table_["cases"]) {
            if (reference["outputs"].contains("Position")) {
                seen = &reference["outputs"]["Position"];
            }
        }
        for (std::size_t pixel = 0; pixel < seen->size(); ++pixel) {
            const V3f p_world = vector_of((*seen)[pixel]);
            if (p_world == V3f(0.0f)) {
                continue;  // between the bodies
            }
            const V3f to_place = V3f(V3d(p_world) - frame_.eye_position_world);
            const auto hit = scene_->intersect({.direction = to_place.normalized()});
            ASSERT_TRUE(hit) << p_world;
            ASSERT_LT((hit->p_world - to_place).length(), 1e-5f);
            places_.emplace_back(pixel, *hit, frame_);
        }
        ASSERT_GT(places_.size(), 40u);
    }

    const std::map<std::string, int> names_{{"", 0},
                                            {"second", 1},
                                            {"absent", 2},
                                            {"paint", 0},
                                            {"weight", 1}};
};

// Six digits of each side's positions, and what a picture makes of them between two pixels.
constexpr float tolerance = 1e-4f;

const PathState camera_path;

TEST_F(BesideCycles, what_is_read_from_a_hit_is_the_same)
{
    for (const Json& reference : table_["cases"]) {
        SCOPED_TRACE(reference["node"].get<std::string>() + " " + reference["options"].dump() +
                     " " + reference["inputs"].dump());
        for (const auto& [output, values] : reference["outputs"].items()) {
            for (const Place& place : places_) {
                if (!place.is_flat && needs_flat(reference)) {
                    continue;
                }
                const Hit hit{
                    .point = place.hit.point, .attributes = place.attributes, .path = camera_path};
                const V3f expected = vector_of(values[place.pixel]);
                const V3f found = asked(reference, output, hit);
                EXPECT_LT((found - expected).length(), tolerance)
                    << output << " of pixel " << place.pixel << (place.is_flat ? ", flat" : "")
                    << (place.hit.point.backfacing ? ", back" : "") << " is " << found
                    << ", expected " << expected;
            }
        }
    }
}

// The normal that a smooth mirror has.
V3f mirror_normal(const ShaderProgram& program, const Hit& hit)
{
    const auto sample = program.shade(hit).bsdf.sample(0.5f, {0.5f, 0.5f});
    return sample ? (sample->wi + hit.point.wo).normalized() : V3f(0.0f);
}

// A mirror of the node's inputs, whose first shader-independent input `height` is the object's
// coordinates.
struct BentMirror {
    NodeGraph graph;
    std::size_t node;
    std::size_t mirror;

    BentMirror(const Json& reference, const char* height)
        : node(graph.add(reference["node"].get<std::string>(),
                         NodeOptions(options_of(reference["options"])))),
          mirror(graph.add("BSDF_GLOSSY"))
    {
        graph.set(mirror, "Roughness", V3f(0.0f));
        for (const auto& [input, value] : reference["inputs"].items()) {
            graph.set(node, input, V3f(value.get<float>()));
        }
        graph.link(node, height, graph.output(graph.add("TEX_COORD"), "Object"));
    }

    [[nodiscard]] ShaderProgram compiled(const std::optional<NodeOutput>& displacement) const
    {
        AnyResources resources;
        return {graph, graph.output(mirror, "BSDF"), displacement, resources};
    }
};

// What the difference of two heights loses, over a step of the footprint below.
constexpr float bump_tolerance = 1e-3f;
constexpr float footprint = 0.1f;

// The least elevation of a mirror direction, sine: what a normal beyond is bent back to.
bool is_bent_back(const V3f& normal, const ShadingPoint& point)
{
    const V3f mirrored = normal * (2.0f * normal.dot(point.wo)) - point.wo;
    return mirrored.dot(point.ng) < 0.011f;
}

TEST_F(BesideCycles, heights_bend_the_normal_alike)
{
    for (const Json& reference : table_["bumps"]) {
        BentMirror bent(reference, "Height");
        bent.graph.link(bent.mirror, "Normal", bent.graph.output(bent.node, "Normal"));
        const ShaderProgram program = bent.compiled(std::nullopt);
        for (const Place& place : places_) {
            ShadingPoint point = place.hit.point;
            point.footprint = footprint;
            const V3f expected = vector_of(reference["outputs"]["Normal"][place.pixel]);
            const V3f found = mirror_normal(
                program, {.point = point, .attributes = place.attributes, .path = camera_path});
            EXPECT_TRUE((found - expected).length() < bump_tolerance ||
                        is_bent_back(expected, point))
                << reference["options"] << reference["inputs"] << " pixel " << place.pixel
                << (place.is_flat ? ", flat" : "") << (point.backfacing ? ", back" : "") << " is "
                << found << ", expected " << expected << ", unbent " << point.ns;
        }
    }
}

TEST_F(BesideCycles, displacement_bends_the_normal_alike)
{
    for (const Json& reference : table_["displacements"]) {
        const bool is_vector = reference["node"] == "VECTOR_DISPLACEMENT";
        const BentMirror bent(reference, is_vector ? "Vector" : "Height");
        const ShaderProgram program = bent.compiled(bent.graph.output(bent.node, "Displacement"));
        for (const Place& place : places_) {
            if (!place.is_flat && needs_flat(reference)) {
                continue;
            }
            ShadingPoint point = place.hit.point;
            point.footprint = footprint;
            const V3f expected = vector_of(reference["normal"][place.pixel]);
            const V3f found = mirror_normal(
                program, {.point = point, .attributes = place.attributes, .path = camera_path});
            EXPECT_TRUE((found - expected).length() < bump_tolerance ||
                        is_bent_back(expected, point))
                << reference["node"] << reference["options"] << " pixel " << place.pixel
                << (place.is_flat ? ", flat" : "") << (point.backfacing ? ", back" : "") << " is "
                << found << ", expected " << expected << ", unbent " << point.ns;
        }
    }
}

}  // namespace
}  // namespace eye_render
