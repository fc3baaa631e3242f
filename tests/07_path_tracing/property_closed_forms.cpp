#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/light_tracer.h"
#include "integrator/path_tracer.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/refraction_material.h"
#include "medium/absorbing_medium.h"
#include "mesh/triangle_mesh.h"
#include "sampling/stratified_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/form_factor.h"
#include "support/path_mean.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
constexpr int pathsPerRound = 32 * 32;
const StratifiedSampler sampler(7, 32);
const BoxFilter box;

std::shared_ptr<const Material> diffuse(Real reflectance) {
    return std::make_shared<DiffuseMaterial>(Color::Constant(reflectance));
}

std::shared_ptr<const Texture> shining(Real radiance) {
    return std::make_shared<ConstantTexture>(Color::Constant(radiance));
}

std::shared_ptr<const Material> glass(Real reflectance) {
    return std::make_shared<RefractionMaterial>(Color::Constant(reflectance), Color::Constant(1 - reflectance));
}

SceneObject floor(Real reflectance) {
    return {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), .material = diffuse(reflectance)};
}

// A single pixel with this field of view.
std::shared_ptr<const Camera> pixel(const Vec3& position, const Vec3& target, Real fieldOfView) {
    const Vec3 up = std::abs((target - position).normalized().y()) > 0.9 ? Vec3::UnitX() : Vec3::UnitY();
    return std::make_shared<PinholeCamera>(position, target, up, fieldOfView, 1, 1);
}

// The methods that can render a scene.
enum Methods : unsigned { chance = 1, direct = 2, mis = 4, light = 8, bidirectional = 16, all = 31 };

constexpr PathLimits longPaths = {.maxLength = 1000, .rouletteStart = 3};

// What the pixel shows must be the expected value, within 5 standard errors of at most 0.1 %.
void expectPixel(const Scene& scene, Real expected, unsigned methods = all, const PathLimits& limits = longPaths) {
    const auto check = [&](unsigned method, const std::string& name, const Integrator& integrator) {
        if ((methods & method) == 0) return;
        const test::PathMean seen = test::meanOfRounds(integrator, pathsPerRound, 0.9e-3 * expected);
        EXPECT_LE(seen.standardError, 1e-3 * expected) << name;
        EXPECT_NEAR(seen.mean, expected, 5 * seen.standardError + 1e-9 * expected) << name;
    };
    check(chance, "path tracing by chance", PathTracer(scene, sampler, box, {limits, Direct::ByChance}));
    check(direct, "path tracing, direct light", PathTracer(scene, sampler, box, {limits, Direct::DirectLight}));
    check(mis, "path tracing, both", PathTracer(scene, sampler, box, {limits, Direct::Mis}));
    check(light, "light tracing", LightTracer(scene, sampler, box, limits));
    check(bidirectional, "bidirectional", BidirectionalPathTracer(scene, sampler, box, limits));
}

// The mean of a radiance over the pixel, by the midpoint rule: what one pixel shows of a plane y = 0.
Real overPixel(const Camera& camera, const std::function<Real(const Vec3& floor)>& radiance) {
    constexpr int side = 400;
    Real sum = 0;
    for (int i = 0; i < side * side; ++i) {
        const Vec2 film((i % side + 0.5) / side, (i / side + 0.5) / side);
        const Ray ray = camera.sampleRay(film, {0.5, 0.5});
        sum += radiance(ray.at(-ray.origin.y() / ray.direction.y()));
    }
    return sum / (side * side);
}

// The unit sphere, seen from inside: an octahedron whose triangles are cut into four again and again.
TriangleMesh hollowSphere(int cuts) {
    std::vector<std::array<Vec3, 3>> faces;
    for (const Real x : {1.0, -1.0}) {
        for (const Real y : {1.0, -1.0}) {
            for (const Real z : {1.0, -1.0}) {
                const Vec3 a(x, 0, 0), b(0, y, 0), c(0, 0, z);
                if (x * y * z > 0) faces.push_back({a, c, b});
                if (x * y * z < 0) faces.push_back({a, b, c});
            }
        }
    }
    for (int cut = 0; cut < cuts; ++cut) {
        std::vector<std::array<Vec3, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const Vec3 ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
            for (const auto& one : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
                finer.push_back(one);
        }
        faces = finer;
    }
    MeshData mesh;
    for (const auto& corners : faces) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return TriangleMesh(mesh);
}

// A closed room in which every point emits 0.5 and reflects half: L = 0.5 + 0.5 L, so L = 1, whichever way one looks.
TEST(ClosedForm, SphereThatShinesSeenFromInside) {
    SceneDescription description;
    description.objects = {
        {.shape = std::make_shared<TriangleMesh>(hollowSphere(3)), .material = diffuse(0.5), .emission = shining(0.5)}};
    description.camera = pixel({0.1, 0.2, 0.3}, {1, 0.5, 0.4}, 2.4);
    expectPixel(Scene(description), 1);
}

// A white ball, and one of glass, in a furnace: both are as bright as everything else.
TEST(ClosedForm, WhiteFurnace) {
    SceneDescription description;
    description.objects = {{.shape = std::make_shared<Sphere>(Vec3::Zero(), 1.0), .material = diffuse(1)}};
    description.lights = {std::make_shared<ConstantEnvironment>(Color::Ones())};
    description.camera = pixel({0, 0, 3}, {0, 0, 0}, 0.7);
    expectPixel(Scene(description), 1);

    description.objects = {{.shape = std::make_shared<Sphere>(Vec3::Zero(), 1.0),
                            .material = glass(0.2),
                            .interior = Interior{1.5, nullptr, 0}}};
    description.lights = {std::make_shared<ConstantEnvironment>(Color::Ones())};
    expectPixel(Scene(description), 1, all & ~light);
}

// E = π L F with the rectangle's form factor F in closed form, and what leaves the floor is ρ E / π.
TEST(ClosedForm, RectanglesFormFactor) {
    SceneDescription description;
    const auto lamp = std::make_shared<Rectangle>(Vec3(-1, 1.5, -0.5), Vec3(2, 0, 0), Vec3(0, 0, 1));  // U × V = −y
    description.objects = {floor(0.5), {.shape = lamp, .emission = shining(7)}};
    description.camera = pixel({0.2, 1, 0.1}, {0.4, 0, 0.3}, 1.2);
    const Real expected = overPixel(*description.camera, [](const Vec3& at) {
        return 0.5 * 7 * test::formFactor(-1 - at.x(), 1 - at.x(), -0.5 - at.z(), 0.5 - at.z(), 1.5);
    });
    expectPixel(Scene(description), expected);
}

// Lambert: E = I cos θ / d², ρ E / π leaves the floor. Only in the cone's light, for a cone.
TEST(ClosedForm, PointAndConeLightOnAPlane) {
    const Real halfAngle = 0.5;
    const Vec3 place(0, 2, 0);
    const auto lambert = [&](const Vec3& at) {
        const Vec3 way = place - at;
        return 0.6 / pi * 5 * way.y() / std::pow(way.norm(), 3);
    };
    SceneDescription description;
    description.objects = {floor(0.6)};
    description.lights = {std::make_shared<PointLight>(place, Color::Constant(5))};
    description.camera = pixel({0.5, 1, 0.5}, {0.3, 0, 0.3}, 1.4);
    const unsigned methods = all & ~chance;
    expectPixel(Scene(description), overPixel(*description.camera, lambert), methods);

    description.lights = {std::make_shared<ConeLight>(place, -Vec3::UnitY(), halfAngle, Color::Constant(5))};
    const auto inCone = [&](const Vec3& at) { return at.norm() < 2 * std::tan(halfAngle) ? lambert(at) : 0; };
    expectPixel(Scene(description), overPixel(*description.camera, inCone), methods);
}

// Two facing mirrors that shine by themselves: L (1 − R^n)/(1 − R), with n segments at most.
TEST(ClosedForm, MirrorCorridor) {
    const Real R = 0.8;
    const auto mirror = std::make_shared<MirrorMaterial>(Color::Constant(R));
    const auto left = std::make_shared<Rectangle>(Vec3(0, -1, -1), Vec3(0, 2, 0), Vec3(0, 0, 2));   // faces +x
    const auto right = std::make_shared<Rectangle>(Vec3(2, -1, -1), Vec3(0, 0, 2), Vec3(0, 2, 0));  // faces −x
    SceneDescription description;
    description.objects = {{.shape = left, .material = mirror, .emission = shining(3)},
                           {.shape = right, .material = mirror, .emission = shining(3)}};
    description.camera = pixel({1, 0, 0}, {2, 0, 0}, 1e-6);
    for (const int length : {1, 2, 6, 31}) {
        expectPixel(Scene(description), 3 * (1 - std::pow(R, length)) / (1 - R), all & ~light,
                    {.maxLength = length, .rouletteStart = 31});
    }
    // And with roulette.
    expectPixel(Scene(description), 3 / (1 - R), mis | bidirectional);
}

// A pane between x = 0 and x = 0.5.
SceneObject pane(Real reflectance, Real sigmaA) {
    return {.shape = std::make_shared<Box>(Vec3(0, -50, -50), Vec3(0.5, 50, 50)),
            .material = glass(reflectance),
            .interior = Interior{1.5, std::make_shared<AbsorbingMedium>(Color::Constant(sigmaA)), 0}};
}

// Beer–Lambert through a pane that reflects nothing: T = e^(−σ d), d by Snell's law.
TEST(ClosedForm, SlabOfAbsorbingGlass) {
    SceneDescription description;
    description.objects = {pane(0, 1.3)};
    for (const Real angle : {0.0, 0.3, 1.0, 1.5}) {
        description.lights = {std::make_shared<ConstantEnvironment>(Color::Ones())};
        description.camera = pixel({-1, 0, 0}, {-1 + std::cos(angle), std::sin(angle), 0}, 1e-6);
        const Real sinInside = std::sin(angle) / 1.5;
        const Real way = 0.5 / std::sqrt(1 - sinInside * sinInside);
        expectPixel(Scene(description), std::exp(-1.3 * way), all & ~light);
    }
}

// All reflections within a slab: with a = e^(−σ d), T = (1 − R)² a / (1 − R² a²).
TEST(ClosedForm, SlabWithAllInternalReflections) {
    const auto lamp = std::make_shared<Rectangle>(Vec3(3, -50, -50), Vec3(0, 0, 100), Vec3(0, 100, 0));  // shines to −x
    for (const Real R : {0.3, 0.5}) {
        SceneDescription description;
        description.objects = {pane(R, 0.2), {.shape = lamp, .emission = shining(1)}};
        description.camera = pixel({-1, 0, 0}, {0, 0, 0}, 1e-6);
        const Real a = std::exp(-0.2 * 0.5);
        expectPixel(Scene(description), (1 - R) * (1 - R) * a / (1 - R * R * a * a), chance | mis | bidirectional);
    }
}

// A cone light in the middle of a ball of absorbing glass: whatever passes the boundary goes on straight, weakened by
// a (1 − R), a = e^(−σ r). Four segments at most, or what the floor sends to the ball comes back to it; light that is
// reflected within comes out on this side after two more only.
TEST(ClosedForm, LightWithinAbsorbingGlass) {
    const Vec3 place(0, 2, 0);
    const Real R = 0.3;
    const Real a = std::exp(-0.7 * 0.5);
    SceneDescription description;
    description.objects = {floor(0.6),
                           {.shape = std::make_shared<Sphere>(place, 0.5),
                            .material = glass(R),
                            .interior = Interior{1.5, std::make_shared<AbsorbingMedium>(Color::Constant(0.7)), 0}}};
    description.lights = {std::make_shared<ConeLight>(place, -Vec3::UnitY(), 0.5, Color::Constant(5))};
    description.camera = pixel({0.1, 0.9, 0.1}, {0, 0, 0}, 1);
    const Real intensity = 5 * a * (1 - R);
    const Real expected = overPixel(*description.camera, [&](const Vec3& at) {
        const Vec3 way = place - at;
        return 0.6 / pi * intensity * way.y() / std::pow(way.norm(), 3);
    });
    expectPixel(Scene(description), expected, light | bidirectional, {.maxLength = 4});
}

// A mirror across from a floor is a second light behind it: the image's, weakened by R. Segments: light, mirror, floor,
// eye.
TEST(ClosedForm, PointLightAndItsImage) {
    const Real R = 0.7;
    SceneDescription description;
    description.objects = {floor(0.6),
                           {.shape = std::make_shared<Plane>(Vec3(0, 3, 0), -Vec3::UnitY()),
                            .material = std::make_shared<MirrorMaterial>(Color::Constant(R))}};
    description.lights = {std::make_shared<PointLight>(Vec3(0, 2, 0), Color::Constant(5))};
    description.camera = pixel({0.5, 1, 0.5}, {0.3, 0, 0.3}, 1.4);
    const Real expected = overPixel(*description.camera, [&](const Vec3& at) {
        const Vec3 one = Vec3(0, 2, 0) - at;
        const Vec3 image = Vec3(0, 4, 0) - at;
        return 0.6 / pi * 5 * (one.y() / std::pow(one.norm(), 3) + R * image.y() / std::pow(image.norm(), 3));
    });
    expectPixel(Scene(description), expected, light | bidirectional, {.maxLength = 3});
}

}  // namespace
}  // namespace caustic
