#include <gtest/gtest.h>

#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "integrator/path_tracer.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/phong_material.h"
#include "modeler/peers_box.h"
#include "one_page_path_tracer.h"
#include "sampling/independent_sampler.h"
#include "shape/sphere.h"
#include "support/coloured_fog.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

// The loop that the lesson opens with is the path tracer itself: the same bits and the same rays, path by path.
void expectSame(const Scene& scene, int maxLength) {
    const IndependentSampler sampler(12);
    const BoxFilter box;
    const OnePagePathTracer page(scene, sampler, box, maxLength);
    const PathTracer full(scene, sampler, box, {{.maxLength = maxLength, .rouletteStart = 1}, Direct::DirectLight});
    std::vector<Splat> splats;
    RayCounts ofPage;
    RayCounts ofFull;
    Color sum = Color::Zero();
    for (int i = 0; i < 4000; ++i) {
        const PathId path = {{i % 40, i / 40 % 40}, i / 1600};
        const Color one = page.tracePath(path, splats, ofPage);
        const Color other = full.tracePath(path, splats, ofFull);
        EXPECT_TRUE((one == other).all()) << i;
        sum += one;
    }
    EXPECT_GT(sum.minCoeff(), 0);
    EXPECT_EQ(ofPage.rays, ofFull.rays);
    EXPECT_EQ(ofPage.shadowRays, ofFull.shadowRays);
    EXPECT_EQ(ofPage.crossings, ofFull.crossings);
    EXPECT_EQ(ofPage.distanceSamples, ofFull.distanceSamples);
}

// Diffuse walls, a mirror, glass, a lamp.
TEST(OnePage, IsThePathTracerInThePeersBox) {
    const Scene scene(peersBox(40, 40));
    for (const int maxLength : {1, 2, 10}) expectSame(scene, maxLength);
}

// Coloured fog, a glossy ball half in it, a point light and an environment.
TEST(OnePage, IsThePathTracerInFog) {
    SceneDescription description;
    const auto fog = std::make_shared<test::ColouredFog>(Color(0.2, 0.1, 0), Color(0.3, 0.9, 2));
    const auto glossy = std::make_shared<PhongMaterial>(std::make_shared<ConstantTexture>(Color(0.3, 0.4, 0.2)),
                                                        Color(0.5, 0.4, 0.6), 30);
    description.objects = {{.shape = std::make_shared<Sphere>(Vec3::Zero(), 1), .interior = Interior{1, fog, 0}},
                           {.shape = std::make_shared<Sphere>(Vec3(0.7, 0.1, -0.2), 0.6), .material = glossy}};
    description.lights = {std::make_shared<PointLight>(Vec3(-0.2, 0.3, 0.5), Color(3, 2, 1)),
                          std::make_shared<ConstantEnvironment>(Color(0.1, 0.2, 0.4))};
    description.camera =
        std::make_shared<PinholeCamera>(Vec3(0.4, -3, 0.5), Vec3(0.1, 0, 0), Vec3::UnitZ(), 0.8, 40, 40);
    expectSame(Scene(description), 20);
}

}  // namespace
}  // namespace caustic
