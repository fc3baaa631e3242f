#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <set>

#include "camera/box_filter.h"
#include "integrator/ray_tracer.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/refraction_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/recording_sampler.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

const IndependentSampler independent(1);
const BoxFilter box;
const Color sigma(0.8, 0.3, 1.7);

std::shared_ptr<const Texture> shining(const Color& radiance) { return std::make_shared<ConstantTexture>(radiance); }

std::shared_ptr<const Material> diffuse(const Color& reflectance) {
    return std::make_shared<DiffuseMaterial>(reflectance);
}

// Between x = 0 and x = 1, of index 1.5.
SceneObject pane(const Color& reflectance, const Color& transmittance, const Color& sigmaA) {
    SceneObject glass;
    glass.shape = std::make_shared<Box>(Vec3(0, -9, -9), Vec3(1, 9, 9));
    glass.material = std::make_shared<RefractionMaterial>(reflectance, transmittance);
    glass.interior = Interior{1.5, std::make_shared<AbsorbingMedium>(sigmaA), 0};
    return glass;
}

Color radiance(const Scene& scene, const Ray& ray, const RayTracerSettings& settings = {},
               const Sampler& sampler = independent) {
    const RayTracer tracer(scene, sampler, box, settings);
    RayCounts counts;
    return tracer.Li(ray, scene.mediaAt(ray.origin), sampler.start(0, {0, 0}, 0), counts);
}

void expectColor(const Color& found, const Color& expected, const std::string& question) {
    EXPECT_LE((found - expected).abs().maxCoeff(), 1e-10 * expected.maxCoeff())
        << question << "\nfound " << found.transpose() << ", expected " << expected.transpose();
}

// Two facing mirrors that shine, each in colours of its own. The eye sees one, in it the other, in that the first
// again, up to the depth and no further.
TEST(Recursion, MirrorCorridorIsAGeometricSeries) {
    const Color reflectance[2] = {Color(0.5, 0.9, 0.2), Color(0.7, 0.1, 0.6)};
    const Color shines[2] = {Color(1, 3, 2), Color(2, 0.5, 1)};
    const Vec3 corner(4, -3, 7);
    SceneObject walls[2];
    walls[0].shape = std::make_shared<Rectangle>(corner + Vec3(2, -1, -1), Vec3(0, 0, 2), Vec3(0, 2, 0));
    walls[1].shape = std::make_shared<Rectangle>(corner + Vec3(0, -1, -1), Vec3(0, 2, 0), Vec3(0, 0, 2));
    for (int i = 0; i < 2; ++i) {
        walls[i].material = std::make_shared<MirrorMaterial>(reflectance[i]);
        walls[i].emission = shining(shines[i]);
    }
    const Scene scene({{walls[0], walls[1]}, {}, Color::Zero(), nullptr});
    for (const int depth : {0, 1, 4, 7}) {
        Color expected = Color::Zero();
        Color passed = Color::Ones();
        for (int i = 0; i <= depth; ++i) {
            expected += passed * shines[i % 2];
            passed *= reflectance[i % 2];
        }
        expectColor(radiance(scene, {corner + Vec3(1, 0, 0), Vec3::UnitX()}, {.maxDepth = depth}), expected,
                    "At depth " + std::to_string(depth) + ": how many surfaces are seen, and what does each count?");
    }
}

// A pane that reflects R at both faces and lets T pass: T²/(1 − R²) of the lamp behind it is seen when all reflections
// within are followed.
TEST(Recursion, EveryLobeIsFollowed) {
    const Color R(0.5, 0.2, 0.4);
    const Color T(0.5, 0.7, 0.3);
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(3, -9, -9), Vec3(0, 0, 18), Vec3(0, 18, 0));
    lamp.emission = shining(Color(1, 2, 3));
    const Scene scene({{pane(R, T, Color::Zero()), lamp}, {}, Color::Zero(), nullptr});
    expectColor(radiance(scene, {Vec3(-1, 0, 0), Vec3::UnitX()}, {.maxDepth = 100, .leastWeight = 1e-12}),
                Color(1, 2, 3) * T * T / (1 - R * R),
                "Does light go on both ways at a boundary, reflected and refracted?");
}

// Through the pane: e^(−σ d); on the way before it, nothing is lost. From its inside, only the way out counts.
TEST(Recursion, AbsorbsInsideTheGlass) {
    const Color sky(1, 2, 0.5);
    const Scene scene({{pane(Color::Zero(), Color::Ones(), sigma)},
                       {std::make_shared<ConstantEnvironment>(sky)},
                       Color::Zero(),
                       nullptr});
    expectColor(radiance(scene, {Vec3(-5, 0, 0), Vec3::UnitX()}), sky * (-sigma).exp(),
                "On which side of the boundary is the medium, and does the way back count it?");
    const Color denser = sky * Color((-0.4 * sigma).exp()) * (1.5 * 1.5);
    expectColor(radiance(scene, {Vec3(0.6, 0, 0), Vec3::UnitX()}), denser, "What does the first ray start in?");
}

// From inside a medium without a boundary in sight: the way to the environment is infinite.
TEST(Recursion, LightFromBeyondIsAbsorbedToo) {
    SceneObject fog;
    fog.shape = std::make_shared<Box>(Vec3(-2, -2, -2), Vec3(2, 2, 2));
    fog.interior = Interior{1, std::make_shared<AbsorbingMedium>(sigma), 0};
    const Color sky(1, 2, 0.5);
    const Scene scene({{fog}, {std::make_shared<ConstantEnvironment>(sky)}, Color::Zero(), nullptr});
    expectColor(radiance(scene, {Vec3::Zero(), Vec3::UnitX()}), sky * (-2 * sigma).exp(),
                "What passed on the way before the ray left the scene?");
}

// A wall in tinted air: e^(−σ d) of its own light and of what it reflects arrives. Ambient light comes from everywhere
// and nothing is in its way, so that a wall of reflectance ρ sends out ρ of it; a mirror shows that, and has none
// itself.
TEST(Recursion, AmbientLightIsReflected) {
    const Color rho(0.8, 0.5, 0.3);
    const Color mirrors(0.9, 0.4, 0.6);
    const Color ambient(2, 1, 3);
    const Color shines(0.1, 0.7, 0.2);
    const Color intensity(4, 3, 9);
    SceneObject fog;
    fog.shape = std::make_shared<Box>(Vec3(-90, -90, -90), Vec3(90, 90, 90));
    fog.interior = Interior{1, std::make_shared<AbsorbingMedium>(sigma), 0};
    const auto rectangle = [](const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV) {
        return std::make_shared<Rectangle>(corner, edgeU, edgeV);
    };
    const SceneObject wall = {rectangle({-1, -9, -9}, {0, 18, 0}, {0, 0, 18}), diffuse(rho), {}, shining(shines)};
    const SceneObject mirror = {
        rectangle({2, -9, -9}, {0, 0, 18}, {0, 18, 0}), std::make_shared<MirrorMaterial>(mirrors), {}, nullptr};
    const SceneObject lamp = {rectangle({0, -1, -3}, {0, 2, 0}, {1, 0, 0}), nullptr, {}, shining(shines)};  // faces −z
    const Scene scene(
        {{fog, wall, mirror, lamp}, {std::make_shared<PointLight>(Vec3(0.5, 0, 0), intensity)}, ambient, nullptr});
    const Color direct = rho / std::numbers::pi * intensity / 2.25 * (-1.5 * sigma).exp();
    const Color sent = shines + direct + rho * ambient;
    for (const int depth : {0, 3}) {
        expectColor(radiance(scene, {Vec3(0.4, 0, 0), -Vec3::UnitX()}, {.maxDepth = depth}),
                    sent * (-1.4 * sigma).exp(),
                    "Where is the ambient light? Is only what is followed cut at the last depth?");
    }
    expectColor(radiance(scene, {Vec3(0.4, 0, 0), Vec3::UnitX()}), mirrors * sent * (-4.6 * sigma).exp(),
                "Does a mirror show the ambient light of what it shows, tinted by the way there, each once?");
    expectColor(radiance(scene, {Vec3(0.4, 0, -5), Vec3::UnitZ()}), shines * (-2 * sigma).exp(),
                "Is the light of a lamp absorbed on its way?");
}

// A ray counts what the lobes and the ways before it have left, the largest channel. Refraction is about energy: the
// factor 1/η² of radiance isn't lost, it comes back on the way out.
TEST(Recursion, FaintRaysAreNotFollowed) {
    const Color sky(1, 1, 1);
    const auto light = std::make_shared<ConstantEnvironment>(sky);
    const auto seen = [&](const SceneObject& object, const Ray& ray, Real leastWeight) {
        const Scene scene({{object}, {light}, Color::Zero(), nullptr});
        return radiance(scene, ray, {.maxDepth = 20, .leastWeight = leastWeight}).maxCoeff();
    };
    const Ray ray = {Vec3(-5, 0, 0), Vec3::UnitX()};
    const SceneObject clear = pane(Color::Zero(), Color(0.1, 0.6, 0.5), Color(0.2, 0.3, 0.1));
    // Into the pane 0.6 is left, out of it 0.6 · 0.6 · e^(−0.3) = 0.267.
    EXPECT_GT(seen(clear, ray, 0.26), 0) << "What counts, a ray's radiance or its energy?";
    EXPECT_EQ(seen(clear, ray, 0.28), 0) << "Does a ray know what the rays before it have left, and the way?";
    EXPECT_EQ(seen(clear, ray, 0.61), 0) << "Is a ray followed that counts too little?";

    // Into the pane, which shines inside, 0.6 is left, and so it is on the way out.
    const SceneObject glow = {std::make_shared<Rectangle>(Vec3(0.5, -9, -9), Vec3(0, 0, 18), Vec3(0, 18, 0)),
                              nullptr,
                              {},
                              shining(Color::Ones())};
    const Scene glowing({{clear, glow}, {}, Color::Zero(), nullptr});
    EXPECT_GT(radiance(glowing, ray, {.maxDepth = 1, .leastWeight = 0.59}).maxCoeff(), 0)
        << "What counts, a ray's radiance or its energy?";
    EXPECT_EQ(radiance(glowing, ray, {.maxDepth = 1, .leastWeight = 0.61}).maxCoeff(), 0)
        << "Is a ray followed that counts too little?";

    // To and fro within mirrors: R, R² and R³ are left after one, two, three reflections.
    const auto rays = [&](Real reflectance, Real leastWeight) {
        const SceneObject mirrors = {
            std::make_shared<Box>(Vec3(-9, -9, -9), Vec3(1, 9, 9)),
            std::make_shared<MirrorMaterial>(Color(0.3 * reflectance, reflectance, 0.7 * reflectance)),
            {},
            nullptr};
        const Scene corridor({{mirrors}, {}, Color::Zero(), nullptr});
        const RayTracer tracer(corridor, independent, box, {.maxDepth = 20, .leastWeight = leastWeight});
        RayCounts counts;
        tracer.Li(ray, {}, independent.start(0, {0, 0}, 0), counts);
        return counts.rays;
    };
    EXPECT_EQ(rays(0.3, 0.027 * (1 - 1e-9)), 4) << "Is a ray followed that counts a little more?";
    EXPECT_EQ(rays(0.3, 0.027 * (1 + 1e-9)), 3) << "Is a ray followed that counts a little less?";
    EXPECT_EQ(rays(0.5, 0.25), 2) << "Is a ray followed that counts as much and no more?";
    EXPECT_EQ(rays(0, 0), 1) << "Is a ray followed that counts nothing?";
}

// A mirror ball in a furnace reflects R of it, wherever it is seen, whatever its size: no ray meets it again. A clear
// ball lets all light through by two refractions.
TEST(Recursion, RaysLeaveTheirSurface) {
    const Color R(0.9, 0.4, 0.6);
    const Color sky(1, 2, 0.5);
    const auto light = std::make_shared<ConstantEnvironment>(sky);
    for (const Real size : {1e-6, 1.0, 1e6}) {
        const Vec3 center = size * Vec3(3, -2, 5);
        const auto shape = std::make_shared<Sphere>(center, size);
        const Scene mirror(
            {{{shape, std::make_shared<MirrorMaterial>(R), {}, nullptr}}, {light}, Color::Zero(), nullptr});
        const Scene clear({{{shape, std::make_shared<RefractionMaterial>(Color::Zero(), Color::Ones()),
                             Interior{1.5, nullptr, 0}, nullptr}},
                           {light},
                           Color::Zero(),
                           nullptr});
        for (int i = 0; i < 300; ++i) {
            const Vec3 aside(0.6 * std::cos(i), 0.6 * std::sin(2.0 * i), 0.3 * std::sin(3.0 * i));
            const Vec3 from = center + size * Vec3(1, 3, -2);
            const Ray ray = {from, (center + size * aside - from).normalized()};
            ASSERT_LE((radiance(mirror, ray, {.maxDepth = 2}) / (R * sky) - 1).abs().maxCoeff(), 1e-9)
                << "Where does a reflected ray start? Does it meet its own surface?";
            ASSERT_LE((radiance(clear, ray, {.maxDepth = 2}) / sky - 1).abs().maxCoeff(), 1e-9)
                << "On which side of the surface does a refracted ray start?";
        }
    }
}

// Glass between a floor and a ceiling, each under lamps and ambient light: both branches come to a wall at once, and
// share no numbers. Of a wall's vertex the point of the light is asked for, and what ambient light takes.
TEST(Recursion, BranchesHaveNumbersOfTheirOwn) {
    const auto plane = [](Real height, const Vec3& normal, const std::shared_ptr<const Material>& material) {
        return SceneObject{std::make_shared<Plane>(Vec3(0, height, 0), normal), material, {}, nullptr};
    };
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(-4, 1, -4), Vec3(9, 0, 0), Vec3(0, 0, 9));
    lamp.emission = shining(Color::Ones());
    SceneObject glass =
        plane(0, Vec3::UnitY(), std::make_shared<RefractionMaterial>(Color::Constant(0.4), Color::Constant(0.6)));
    glass.interior = Interior{1.5, nullptr, 0};
    const auto white = diffuse(Color::Constant(0.5));
    const Scene scene(
        {{plane(-1, Vec3::UnitY(), white), plane(3, -Vec3::UnitY(), white), glass, lamp}, {}, Color::Ones(), nullptr});
    const test::RecordingSampler sampler;
    radiance(scene, {Vec3(9, 0.3, 0.1), Vec3(0.6, -0.8, 0)}, {.maxDepth = 1, .shadowSamples = 2}, sampler);
    EXPECT_EQ(sampler.different(), 8U) << "Do both branches come to a wall, each with numbers of its own?";
    EXPECT_EQ(sampler.different(), sampler.asked().size()) << "Do two branches use the same numbers?";
    std::set<int> dimensions;
    for (const auto& asked : sampler.asked()) dimensions.insert(asked.dimension);
    EXPECT_EQ(dimensions,
              (std::set{Dimension::vertex(1, VertexUse::LightPoint).index,
                        Dimension::vertex(1, VertexUse::Direction).index, Dimension::vertex(1, VertexUse::Lobe).index}))
        << "Which vertex of the path is the wall behind the glass?";
}

}  // namespace
}  // namespace caustic
