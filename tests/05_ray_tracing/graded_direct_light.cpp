#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>

#include "camera/box_filter.h"
#include "integrator/ray_tracer.h"
#include "light/area_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/independent_sampler.h"
#include "sampling/stratified_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/leaning_mesh.h"
#include "support/recording_light.h"
#include "support/recording_sampler.h"
#include "support/translucent.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
constexpr Real sizes[] = {1e-6, 1, 1e6};
const IndependentSampler independent(1);
const BoxFilter box;
const Color rho(0.8, 0.5, 0.3);

std::shared_ptr<const Material> diffuse(const Color& reflectance) {
    return std::make_shared<DiffuseMaterial>(reflectance);
}

std::shared_ptr<PointLight> pointLight(const Vec3& position, const Color& intensity) {
    return std::make_shared<PointLight>(position, intensity);
}

// What RayTracer::direct says of the place that a ray meets, as vertex `vertex` of a path.
Color directAt(const Scene& scene, const Ray& ray, const RayTracerSettings& settings, const PathNumbers& numbers,
               int vertex = 0) {
    const RayTracer tracer(scene, independent, box, settings);
    MediumStack media = scene.mediaAt(ray.origin);
    Color transmittance;
    RayCounts counts;
    const auto at = scene.follow(ray, media, transmittance, counts);
    return tracer.direct(*at, vertex, numbers, counts);
}

Color directAt(const Scene& scene, const Ray& ray) { return directAt(scene, ray, {}, independent.start(0, {0, 0}, 0)); }

void expectColor(const Color& found, const Color& expected, const char* question) {
    EXPECT_LE(((found - expected) / expected).abs().maxCoeff(), 1e-9)
        << question << "\nfound " << found.transpose() << ", expected " << expected.transpose();
}

// Lambert: L = (ρ / π) I cos θ / d² of each light, with the shading normal's cosine. In colours, on a plane that stands
// askew off the origin and is smooth or isn't, whatever its size.
TEST(DirectLight, PointLightFallsWithDistanceAndCosine) {
    const Vec3 ng = Vec3(0.36, -0.48, 0.8);
    for (const Vec3& ns : {ng, Vec3(0.2, -0.7, 0.65).normalized()}) {
        for (const Real size : sizes) {
            const Vec3 point = size * Vec3(-2, 5, 1);
            const SceneObject plane = {test::leaningPlane(point, ng, ns, 9 * size), diffuse(rho), {}, nullptr};
            const Vec3 lamps[2] = {point + size * Vec3(1, -0.3, 2), point + size * Vec3(-0.4, -2, 0.5)};
            const Color intensities[2] = {Color(4, 1, 2), Color(0, 3, 1)};
            // Two lamps show their backs: nothing comes from there.
            SceneObject back[2];
            for (int i = 0; i < 2; ++i) {
                back[i].shape = std::make_shared<Rectangle>(point + size * (3 + i) * ng, size * Vec3(0.8, 0.6, 0),
                                                            size * Vec3(-0.48, 0.64, 0.6));
                back[i].emission = std::make_shared<ConstantTexture>(Color(5, 6, 7));
            }
            const Scene scene(
                {{back[0], plane, back[1]},
                 {pointLight(lamps[0], size * size * intensities[0]),
                  pointLight(lamps[1], size * size * intensities[1]), pointLight(point - size * ng, Color::Ones())},
                 Color::Zero(),
                 nullptr});
            Color expected = Color::Zero();
            for (int i = 0; i < 2; ++i) {
                const Vec3 way = (lamps[i] - point) / size;
                expected += rho / pi * intensities[i] * ns.dot(way) / std::pow(way.norm(), 3);
            }
            const Vec3 wo = (ng + Vec3(0.3, 0.2, 0)).normalized();
            expectColor(
                directAt(scene, {point + size * wo, -wo}), expected,
                "Which cosine belongs to the rendering equation, and is it there once? Does every light count?");
        }
    }
    const auto lit = [](const std::shared_ptr<const Material>& material) {
        const SceneObject plane = {std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), material, {}, nullptr};
        const Scene scene({{plane}, {pointLight({4, 2, 0}, Color::Constant(pi))}, Color::Zero(), nullptr});
        return directAt(scene, {Vec3(4, 1, 0), -Vec3::UnitY()});
    };
    const Color whole = lit(diffuse(Color::Ones()));
    for (const Color& channels : {Color(0, 0.5, 0.7), Color(0.4, 0, 0.2), Color(0.4, 0.1, 0)}) {
        EXPECT_LE((lit(diffuse(channels)) - channels * whole).abs().maxCoeff(), 1e-12)
            << "Does light end where one of its colours does?";
    }
    EXPECT_TRUE((lit(std::make_shared<MirrorMaterial>(rho)) == 0).all()) << "What does a mirror spread of it?";
    SceneObject lamp;
    lamp.shape = std::make_shared<Rectangle>(Vec3(-1, 1, -1), Vec3(2, 0, 0), Vec3(0, 0, 2));
    lamp.emission = std::make_shared<ConstantTexture>(Color::Ones());
    const Scene alone({{lamp}, {pointLight({0, 3, 0}, Color::Ones())}, Color::Zero(), nullptr});
    EXPECT_TRUE((directAt(alone, {Vec3(0, 2, 0), -Vec3::UnitY()}) == 0).all())
        << "A lamp without a material has no BSDF.";
}

// A lid hides one of two lamps. And nothing hides from itself: neither a ball, nor a lamp that is turned anyhow.
TEST(DirectLight, ShadowIsBlack) {
    const Vec3 corner(3, -2, 5);
    const SceneObject floor = {std::make_shared<Plane>(corner, Vec3::UnitY()), diffuse(rho), {}, nullptr};
    const SceneObject lid = {std::make_shared<Rectangle>(corner + Vec3(-1, 1.5, -1), Vec3(2, 0, 0), Vec3(0, 0, 2)),
                             diffuse(Color::Ones()),
                             {},
                             nullptr};
    const auto near = pointLight(corner + Vec3(0, 2, 0), Color(1, 2, 3));
    const auto far = pointLight(corner + Vec3(6, 2, 0), Color(2, 1, 1));
    const Scene both({{floor, lid}, {near, far}, Color::Zero(), nullptr});
    const Scene one({{floor}, {far}, Color::Zero(), nullptr});
    const Ray under = {corner + Vec3(0.2, 1, 0), -Vec3::UnitY()};
    expectColor(directAt(both, under), directAt(one, under), "Did you ask what is in the way?");
    const Scene dark({{floor, lid}, {near}, Color::Zero(), nullptr});
    EXPECT_TRUE((directAt(dark, under) == 0).all()) << "Did you ask what is in the way?";
    for (const Real size : sizes) {
        const SceneObject ball = {std::make_shared<Sphere>(size * corner, size), diffuse(rho), {}, nullptr};
        const Scene scene(
            {{ball}, {pointLight(size * (corner + Vec3(0, 9, 0)), Color::Ones())}, Color::Zero(), nullptr});
        for (int i = 0; i < 300; ++i) {
            const Vec3 from = corner + Vec3(0.9 * std::cos(i), 3, 0.9 * std::sin(2.0 * i));
            ASSERT_GT(directAt(scene, {size * from, (corner - from).normalized()}).minCoeff(), 0)
                << "Does the ball shade itself? From which point are lights asked?";
        }
    }
}

// In a furnace a plane sends out ρ of what comes, however many points of the environment are asked.
TEST(DirectLight, MoreSamplesMeanTheSameLight) {
    const SceneObject floor = {std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), diffuse(rho), {}, nullptr};
    const Color sky(1, 0.4, 2);
    const Scene scene({{floor}, {std::make_shared<ConstantEnvironment>(sky)}, Color::Zero(), nullptr});
    for (const int samples : {1, 4, 64}) {
        Color sum = Color::Zero();
        const int n = 64'000 / samples;
        for (int i = 0; i < n; ++i)
            sum += directAt(scene, {Vec3(0, 1, 0), -Vec3::UnitY()}, {.shadowSamples = samples},
                            independent.start(0, {0, 0}, i));
        // A sample is 4 cos θ or 0: standard deviation 1.3, of the mean of 64,000 of them 0.0051; 5.5 of these.
        EXPECT_LE((sum / n / (rho * sky) - 1).abs().maxCoeff(), 0.0284) << "Is it their mean, or their sum?";
    }
}

// The cells of a 4 × 4 grid that pairs of numbers lie in.
std::set<int> cells(const std::vector<Vec2>& pairs) {
    std::set<int> found;
    for (const Vec2& u : pairs) found.insert(static_cast<int>(4 * u.x()) + 4 * static_cast<int>(4 * u.y()));
    return found;
}

// Every sample of every light, at every vertex, has numbers of its own; a light's samples at a vertex are spread as the
// sampler spreads paths. A light at a point has but one point.
TEST(DirectLight, EverySampleHasNumbersOfItsOwn) {
    const auto shape = std::make_shared<Rectangle>(Vec3(-1, 2, -1), Vec3(2, 0, 0), Vec3(0, 0, 2));
    const auto radiance = std::make_shared<ConstantTexture>(Color::Ones());
    std::vector<std::shared_ptr<test::RecordingLight>> lights;
    for (int i = 0; i < 3; ++i)
        lights.push_back(std::make_shared<test::RecordingLight>(std::make_shared<AreaLight>(shape, radiance)));
    const auto point =
        std::make_shared<test::RecordingLight>(std::make_shared<PointLight>(Vec3(0, 3, 0), Color::Ones()));
    const SceneObject floor = {std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), diffuse(rho), {}, nullptr};
    const Scene scene({{floor}, {lights[0], point, lights[1], lights[2]}, Color::Zero(), nullptr});
    const StratifiedSampler sampler(3, 4);
    std::set<std::pair<Real, Real>> all;
    std::size_t count = 0;
    for (const int vertex : {0, 1, 5}) {
        for (const int index : {0, 7}) {
            directAt(scene, {Vec3(0, 1, 0), -Vec3::UnitY()}, {.shadowSamples = 16}, sampler.start(0, {2, 1}, index),
                     vertex);
            EXPECT_EQ(point->asked().size(), 1U) << "How many points does a light at a point have?";
            point->forget();
            for (const auto& light : lights) {
                EXPECT_EQ(light->asked().size(), 16U) << "How many points of a light are asked?";
                EXPECT_EQ(cells(light->asked()).size(), 16U)
                    << "PathNumbers has two ways to make several of one: which of them spreads samples?";
                for (const Vec2& u : light->asked()) all.insert({u.x(), u.y()});
                count += light->asked().size();
                light->forget();
            }
        }
    }
    EXPECT_EQ(all.size(), count) << "Do two lights, two samples or two vertices share their numbers?";
    for (const int vertex : {0, 3}) {
        const test::RecordingSampler recording;
        directAt(scene, {Vec3(0, 1, 0), -Vec3::UnitY()}, {}, recording.start(0, {2, 1}, 0), vertex);
        for (const auto& asked : recording.asked())
            EXPECT_EQ(asked.dimension, Dimension::vertex(vertex, VertexUse::LightPoint).index)
                << "VertexUse says what numbers are for. Whose vertex is it?";
    }
}

// A lamp hangs in a tinted medium of index 1 that no surface bounds: e^(−σ d) of its light arrives, in each colour.
// Paper around tinted air is lit from both sides: what a shadow ray starts in depends on the side that it goes to.
TEST(DirectLight, IsAbsorbedOnItsWay) {
    const Color sigma(0.7, 0.1, 2);
    SceneObject fog;
    fog.shape = std::make_shared<Box>(Vec3(-9, -1, -9), Vec3(9, 9, 9));
    fog.interior = Interior{1, std::make_shared<AbsorbingMedium>(sigma), 0};
    const SceneObject floor = {std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), diffuse(rho), {}, nullptr};
    const Scene hazy({{floor, fog}, {pointLight(Vec3(0, 1.5, 0), Color::Constant(2.25 * pi))}, Color::Zero(), nullptr});
    expectColor(directAt(hazy, {Vec3(0, 0.5, 0), -Vec3::UnitY()}), rho * (-1.5 * sigma).exp(),
                "What does the shadow ray pass through, from the point to the lamp?");

    const Color through(0.2, 0.3, 0.4);
    SceneObject lantern = {std::make_shared<Box>(Vec3(-1, -1, -1), Vec3(1, 1, 1)),
                           std::make_shared<test::TranslucentMaterial>(through, rho), fog.interior, nullptr};
    for (const bool lampInside : {false, true}) {
        const Vec3 lamp(0, lampInside ? 0.5 : 1.5, 0);
        const Scene scene({{lantern}, {pointLight(lamp, Color::Constant(0.25 * pi))}, Color::Zero(), nullptr});
        for (const bool eyeInside : {false, true}) {
            const Ray ray = {Vec3(0, eyeInside ? 0.3 : 3, 0), eyeInside ? Vec3::UnitY() : Vec3(-Vec3::UnitY())};
            Color expected = lampInside == eyeInside ? rho : through;
            if (lampInside) expected *= (-0.5 * sigma).exp();
            expectColor(directAt(scene, ray), expected,
                        "On which side of the surface does the shadow ray start? What is it in there?");
        }
    }
}

}  // namespace
}  // namespace caustic
