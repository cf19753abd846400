// Direct light by three estimators that must agree: light sampling alone, BSDF sampling alone, and
// the path tracer, which weighs both. The first two are put together here from the scene's and the
// surface's own functions.

#include "estimate.h"
#include "scene/light_path.h"
#include "scenes.h"

namespace eye_render {
namespace {

using test::Estimate;
using test::estimate;
using test::mean_of;

// A surface seen along a ray, with its lights weighed. The scene and the hit stay where they are.
struct LitSurface {
    const Scene& scene;
    SurfaceHit hit;
    ShadedPoint shaded;
    LitPoint point;

    LitSurface(const Scene& lit_scene, const Ray& ray)
        : scene(lit_scene), hit(scene.intersect(ray).value()), shaded(scene.shade(hit, {}))
    {
        scene.weigh_lights(hit.p_world, hit.point.ng, point);
    }

    [[nodiscard]] Estimate by_light_sampling(int count) const
    {
        return mean_of(count, [&](int i) {
            SampleSequence sequence = test::sequence_of(i, 1);
            const auto u = sequence.next();
            const auto light = scene.sample_light(point, u[2], V2f(u[0], u[1]));
            if (!light) {
                return 0.0;
            }
            const Color3f f = shaded.bsdf.evaluate(light->wi).value;
            const Ray shadow{.origin = hit.origin_towards(light->wi),
                             .direction = light->wi,
                             .t_max = light->distance};
            return static_cast<double>(f.x * light->radiance.x * scene.transmittance(shadow).x /
                                       light->pdf);
        });
    }

    [[nodiscard]] Estimate by_bsdf_sampling(int count) const
    {
        return mean_of(count, [&](int i) {
            SampleSequence sequence = test::sequence_of(i, 2);
            const auto u = sequence.next();
            const auto sample = shaded.bsdf.sample(u[2], V2f(u[0], u[1]));
            if (!sample) {
                return 0.0;
            }
            const Ray ray{.origin = hit.origin_towards(sample->wi), .direction = sample->wi};
            const auto beyond = scene.intersect(ray);
            float radiance = 0.0f;
            scene.visit_lamps(point, light_path, ray.direction, 0.0f,
                              beyond ? beyond->t : ray.t_max,
                              [&](const LampContribution& lamp) { radiance += lamp.radiance.x; });
            if (!beyond) {
                radiance += scene.background(ray.direction, {}).x;
            }
            return static_cast<double>(sample->weight.x * radiance);
        });
    }
};

// Two means of independent samples: four standard errors of their difference.
void expect_agree(const Estimate& a, const Estimate& b)
{
    EXPECT_GT(a.mean, 0.0);
    EXPECT_NEAR(a.mean, b.mean, 4.0 * std::hypot(a.standard_error, b.standard_error))
        << "standard errors " << a.standard_error << " and " << b.standard_error;
}

// Of what is seen straight ahead.
void expect_all_agree(const SceneData& data)
{
    const Scene scene(data, V3d(0.0));
    const Ray ray;
    const LitSurface surface(scene, ray);
    const Estimate by_light = surface.by_light_sampling(40000);
    const Estimate by_bsdf = surface.by_bsdf_sampling(40000);
    const Estimate by_both = estimate(scene, {.max_bounces = 0}, ray, 20000);
    expect_agree(by_light, by_bsdf);
    expect_agree(by_both, by_light);
    expect_agree(by_both, by_bsdf);
}

// A plane square to the view, with a lamp of 1 m beside the eye, half of it behind a blind.
SceneData plane_under_area_lamp(const Material& material)
{
    SceneData data;
    test::place(data, test::square(10.0f), V3d(0.0, 0.0, -2.0), material);
    test::place(data, test::square(0.5f), V3d(0.9, 0.0, -0.7), test::diffuse(0.0f));
    LampData lamp = test::point_lamp(V3d(0.6, 0.1, 0.0), 100.0f);
    lamp.settings.kind = LampKind::Area;
    data.lamps.push_back(lamp);
    return data;
}

Material glossy(float roughness)
{
    return plain_material("BSDF_GLOSSY", {{"Color", V3f(0.8f)}, {"Roughness", V3f(roughness)}});
}

class MultipleImportance : public testing::TestWithParam<float> {};

TEST_P(MultipleImportance, light_and_bsdf_sampling_of_an_area_lamp_agree_with_both_together)
{
    expect_all_agree(plane_under_area_lamp(glossy(GetParam())));
}

TEST_P(MultipleImportance, a_lamp_and_the_world_together_agree_as_well)
{
    SceneData data = plane_under_area_lamp(glossy(GetParam()));
    data.world = test::even_world(0.5f);
    expect_all_agree(data);
}

INSTANTIATE_TEST_SUITE_P(Roughness, MultipleImportance, testing::Values(0.3f, 0.6f, 1.0f));

}  // namespace
}  // namespace eye_render
