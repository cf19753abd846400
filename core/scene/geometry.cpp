#include "scene/geometry.h"

#include <cmath>

namespace eye_render {

namespace {

bool is_finite(const V3f& p) { return std::isfinite(p.x + p.y + p.z); }

void extend(Imath::Box3f& box, const std::vector<V3f>& positions)
{
    for (const V3f& p : positions) {
        if (is_finite(p)) {
            box.extendBy(p);
        }
    }
}

// By the centres, or by all of the balls around them.
void extend(Imath::Box3f& box, const std::vector<SizedPoint>& points, bool with_radius)
{
    for (const SizedPoint& point : points) {
        if (point.is_finite()) {
            const V3f around(with_radius ? point.radius : 0.0f);
            box.extendBy(point.center - around);
            box.extendBy(point.center + around);
        }
    }
}

// What texture spaces are laid out in.
Imath::Box3f resting_box(const Geometry& geometry)
{
    Imath::Box3f box;
    if (const Mesh* mesh = std::get_if<Mesh>(&geometry)) {
        extend(box, mesh->positions);
    } else if (const Curves* curves = std::get_if<Curves>(&geometry)) {
        extend(box, curves->keys, false);
    } else {
        extend(box, std::get<Points>(geometry).points, false);
    }
    return box;
}

}  // namespace

const std::string& name_of(const Geometry& geometry)
{
    return std::visit([](const auto& any) -> const std::string& { return any.name; }, geometry);
}

bool is_empty(const Geometry& geometry)
{
    if (const Mesh* mesh = std::get_if<Mesh>(&geometry)) {
        return mesh->triangles.empty();
    }
    if (const Curves* curves = std::get_if<Curves>(&geometry)) {
        return curves->keys.empty();
    }
    return std::get<Points>(geometry).points.empty();
}

TextureSpace texture_space_of(const Geometry& geometry)
{
    const auto& own = std::visit(
        [](const auto& any) -> const auto& { return any.texture_space; }, geometry);
    if (own) {
        return *own;
    }
    const Imath::Box3f box = resting_box(geometry);
    if (box.isEmpty()) {
        return {};
    }
    TextureSpace space{.origin = box.min, .size = box.size()};
    for (int axis = 0; axis < 3; ++axis) {
        // A flat geometry has one coordinate in its middle, as in Blender.
        if (!(space.size[axis] > 0.0f)) {
            space.size[axis] = 1.0f;
            space.origin[axis] -= 0.5f;
        }
    }
    return space;
}

Imath::Box3f bounds_of(const Geometry& geometry)
{
    Imath::Box3f box;
    if (const Mesh* mesh = std::get_if<Mesh>(&geometry)) {
        extend(box, mesh->positions);
        for (const std::vector<V3f>& step : mesh->motion_positions) {
            extend(box, step);
        }
        return box;
    }
    const auto extend_all = [&box](const auto& points, const auto& motion) {
        extend(box, points, true);
        for (const std::vector<SizedPoint>& step : motion) {
            extend(box, step, true);
        }
    };
    if (const Curves* curves = std::get_if<Curves>(&geometry)) {
        extend_all(curves->keys, curves->motion);
    } else {
        const auto& points = std::get<Points>(geometry);
        extend_all(points.points, points.motion);
    }
    return box;
}

bool deforms(const Geometry& geometry)
{
    if (const Mesh* mesh = std::get_if<Mesh>(&geometry)) {
        return !mesh->motion_positions.empty();
    }
    if (const Curves* curves = std::get_if<Curves>(&geometry)) {
        return !curves->motion.empty();
    }
    return !std::get<Points>(geometry).motion.empty();
}

void validate(const Geometry& geometry)
{
    std::visit([](const auto& any) { validate(any); }, geometry);
}

std::string drop_broken(Geometry& geometry)
{
    const auto said = [](std::size_t count, const char* what) {
        return count == 0 ? std::string() : std::to_string(count) + what;
    };
    if (Mesh* mesh = std::get_if<Mesh>(&geometry)) {
        return said(drop_broken_triangles(*mesh), " triangles with a corner that is not finite");
    }
    if (Curves* curves = std::get_if<Curves>(&geometry)) {
        return said(drop_broken_strands(*curves), " strands with a key that is not finite");
    }
    return said(drop_broken_points(std::get<Points>(geometry)), " points that are not finite");
}

}  // namespace eye_render
