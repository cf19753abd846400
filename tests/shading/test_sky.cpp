// The Sky Texture against what Cycles of Blender 4.3 shows (tests/tools/sky_references.py), and
// what can be said of a sky beforehand.

#include "node_json.h"

#include "shading/nodes/node_tables.h"
#include "shading/sky.h"

#include <cmath>
#include <fstream>
#include <limits>

namespace eye_render::test {
namespace {

const Json& references()
{
    static const Json table = [] {
        std::ifstream file(std::string(EYE_TEST_DATA_DIR) + "/nodes/skies.json");
        return Json::parse(file);
    }();
    return table;
}

Color3f seen(NodeTrial& sky, const V3f& direction)
{
    return sky.set("Vector", direction)("Color");
}

// Cycles steps through the air in single precision, half a metre at the Earth's radius, and its
// table has texels as ours; at the brightest, its sun is a thousand million times its sky.
constexpr float steps_of_air = 2e-3f;
constexpr float against_sun = 1e-12f;

TEST(Sky, looks_as_in_cycles)
{
    ASSERT_FALSE(references().empty());
    std::string options;
    std::optional<NodeTrial> sky;
    for (const Json& reference : references()) {
        // A sky takes a while to compute, and its views follow each other.
        if (reference["options"].dump() != options) {
            options = reference["options"].dump();
            sky.emplace(sky_nodes()[0], options_of(reference["options"]));
        }
        SCOPED_TRACE(options);
        float brightest = 0.0f;
        for (const Json& color : reference["colors"]) {
            brightest = std::max(brightest, max_component(value_of(color)));
        }
        for (std::size_t i = 0; i < reference["colors"].size(); ++i) {
            const V3f direction = value_of(reference["directions"][i]);
            const Color3f expected = value_of(reference["colors"][i]);
            const Color3f made = seen(*sky, direction);
            EXPECT_LE((made - expected).length(),
                      steps_of_air * max_component(expected) + against_sun * brightest)
                << "towards " << direction << ": " << made << " instead of " << expected;
        }
    }
}

TEST(Sky, disc_is_where_the_sky_shows_it)
{
    const Options options{
        {"sun_elevation", 0.4}, {"sun_rotation", 2.0}, {"sun_size", 0.02}, {"dust_density", 0.5}};
    const std::optional<SunDisc> disc = sun_disc(NodeOptions(options), WorkingSpace::Rec709);
    ASSERT_TRUE(disc);
    EXPECT_NEAR(disc->direction.z, std::sin(0.4f), 1e-6f);
    EXPECT_NEAR(std::atan2(disc->direction.x, disc->direction.y), 2.0f, 1e-6f);
    EXPECT_FLOAT_EQ(disc->radius_rad, 0.01f);

    NodeTrial sky(sky_nodes()[0], options);
    const Color3f middle = seen(sky, disc->direction);
    EXPECT_LE((middle - disc->radiance).length(), 1e-4f * middle.length());
    // Sideways, where the air reddens all alike.
    const V3f side = disc->direction.cross(V3f(0.0f, 0.0f, 1.0f)).normalized();
    const auto beside = [&](float angle_rad) {
        return seen(sky, disc->direction * std::cos(angle_rad) + side * std::sin(angle_rad)).x;
    };
    constexpr float limb = 0.4f;
    EXPECT_NEAR(beside(0.99999f * disc->radius_rad), limb * middle.x, 0.01f * middle.x);
    EXPECT_LT(beside(1.00001f * disc->radius_rad), 1e-3f * middle.x);
}

TEST(Sky, disc_of_twice_the_width_is_a_quarter_as_bright)
{
    const auto middle = [](double size) {
        const Options options{{"sun_elevation", 0.9}, {"sun_size", size}};
        return sun_disc(NodeOptions(options), WorkingSpace::Rec709)->radiance.y;
    };
    // The air over a wider disc varies more, and small solid angles round.
    EXPECT_NEAR(middle(0.04) / middle(0.08), 4.0f, 0.02f);
}

TEST(Sky, has_no_disc_when_it_is_told_so_or_the_sun_is_down)
{
    EXPECT_TRUE(sun_disc(NodeOptions(Options{{"sun_elevation", -0.004}}), WorkingSpace::Rec709));
    EXPECT_FALSE(sun_disc(NodeOptions(Options{{"sun_elevation", -0.006}}), WorkingSpace::Rec709));
    EXPECT_FALSE(sun_disc(NodeOptions(Options{{"sun_disc", 0.0}}), WorkingSpace::Rec709));
    EXPECT_FALSE(sun_disc(NodeOptions(Options{{"sky_type", "PREETHAM"}}), WorkingSpace::Rec709));
}

TEST(Sky, is_as_bright_left_of_the_sun_as_right_of_it)
{
    NodeTrial sky(sky_nodes()[0], {{"sun_disc", 0.0}, {"sun_rotation", 1.0}});
    const auto at = [&](float azimuth) {
        return seen(sky, {0.8f * std::sin(azimuth), 0.8f * std::cos(azimuth), 0.6f});
    };
    for (const float angle : {0.1f, 1.0f, 2.0f, 3.1f}) {
        const Color3f left = at(1.0f - angle);
        EXPECT_LE((left - at(1.0f + angle)).length(), 1e-5f * left.length()) << angle;
    }
}

TEST(Sky, is_finite_in_every_direction)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const char* type : {"NISHITA", "PREETHAM", "HOSEK_WILKIE"}) {
        NodeTrial sky(sky_nodes()[0], {{"sky_type", type}});
        for (const V3f& direction :
             {V3f(0.0f), V3f(0.0f, 0.0f, 1.0f), V3f(0.0f, 0.0f, -1.0f), V3f(1e30f), V3f(-1e30f),
              V3f(nan), V3f(std::numeric_limits<float>::infinity())}) {
            const Color3f color = seen(sky, direction);
            for (int i = 0; i < 3; ++i) {
                EXPECT_TRUE(std::isfinite(color[i]) && color[i] >= 0.0f)
                    << type << " " << direction << ": " << color;
            }
        }
    }
}

TEST(Sky, sun_of_blender_5_does_not_hide_the_sky_behind_it)
{
    const V3f to_sun = sun_disc(NodeOptions(Options{}), WorkingSpace::Rec709)->direction;
    const auto seen = [&](Options options) {
        NodeTrial sky(sky_nodes()[0], std::move(options));
        return sky.set("Vector", to_sun)("Color");
    };
    const V3f sky = seen({{"sun_disc", 0.0}});
    const V3f both = seen({{"sky_type", "NISHITA"}}) + sky;
    EXPECT_GT(sky.length(), 1e-5f * both.length());
    EXPECT_LE((seen({{"sky_type", "SINGLE_SCATTERING"}}) - both).length(), 1e-6f * both.length());
}

TEST(Sky, refuses_what_it_does_not_model)
{
    const auto make = [](Options options) {
        return NodeTrial(sky_nodes()[0], std::move(options));
    };
    EXPECT_THROW(make({{"sky_type", "MULTIPLE_SCATTERING"}}), std::invalid_argument);
    EXPECT_THROW(make({{"air_density", -1.0}}), std::invalid_argument);
    EXPECT_THROW(make({{"sky_type", "PREETHAM"}, {"turbidity", 0.0}}), std::invalid_argument);
    const Options single{{"sky_type", "SINGLE_SCATTERING"}};  // Nishita's in Blender 5
    EXPECT_TRUE(sun_disc(NodeOptions(single), WorkingSpace::Rec709));
}

}  // namespace
}  // namespace eye_render::test
