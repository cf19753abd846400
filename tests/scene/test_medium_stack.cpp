// What a path is in, by the surfaces that it crossed.

#include "scene/medium_stack.h"

#include <gtest/gtest.h>

#include <deque>

namespace eye_render {
namespace {

// An object with one triangle, filled with that much extinction.
class Object {
public:
    explicit Object(float extinction)
    {
        Mesh mesh;
        mesh.triangles = {{0, 1, 2}};
        geometry_ = mesh;
        medium_.extinction = Color3f(extinction);
        placement_.geometry = &geometry_;
        placement_.materials = {&material_};
        placement_.media = {&medium_};
    }
    Object(const Object&) = delete;  // it points into itself
    Object& operator=(const Object&) = delete;

    [[nodiscard]] SurfaceHit hit(bool backfacing) const
    {
        SurfaceHit hit;
        hit.placement = &placement_;
        hit.point.backfacing = backfacing;
        return hit;
    }

private:
    Geometry geometry_;
    Material material_;
    ParticipatingMedium medium_;
    Placement placement_;
};

constexpr bool in = false;
constexpr bool out = true;

TEST(MediumStack, is_in_what_was_entered_and_not_left)
{
    const Object milk(1.0f);
    const Object ice(4.0f);
    MediumStack media(nullptr);
    EXPECT_FALSE(media.in_medium());
    media.cross(milk.hit(in));
    media.cross(ice.hit(in));
    EXPECT_EQ(media.mixture().extinction, Color3f(5.0f));
    media.cross(milk.hit(out));  // before the other: they overlap
    EXPECT_EQ(media.mixture().extinction, Color3f(4.0f));
    media.cross(ice.hit(out));
    EXPECT_FALSE(media.in_medium());
}

TEST(MediumStack, enters_an_object_once_and_leaves_only_where_it_is)
{
    const Object milk(1.0f);
    MediumStack media(nullptr);
    media.cross(milk.hit(out));
    EXPECT_FALSE(media.in_medium());
    media.cross(milk.hit(in));
    media.cross(milk.hit(in));
    EXPECT_EQ(media.mixture().extinction, Color3f(1.0f));
    media.cross(milk.hit(out));
    EXPECT_FALSE(media.in_medium());
}

TEST(MediumStack, is_always_in_the_world)
{
    ParticipatingMedium fog;
    fog.extinction = Color3f(0.5f);
    const Object milk(1.0f);
    MediumStack media(&fog);
    media.cross(milk.hit(in));
    EXPECT_EQ(media.mixture().extinction, Color3f(1.5f));
    media.leave_meshes();
    EXPECT_TRUE(media.in_medium());
    EXPECT_EQ(media.mixture().extinction, fog.extinction);
}

TEST(MediumStack, more_than_it_holds_are_left_out)
{
    std::deque<Object> objects;
    MediumStack media(nullptr);
    for (int i = 0; i < 40; ++i) {
        media.cross(objects.emplace_back(1.0f).hit(in));
    }
    EXPECT_EQ(media.mixture().extinction, Color3f(16.0f));
}

}  // namespace
}  // namespace eye_render
