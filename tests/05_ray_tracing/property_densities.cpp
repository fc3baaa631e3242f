#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "camera/pinhole_camera.h"
#include "light/area_light.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "sampling/warp.h"
#include "shape/box.h"
#include "shape/instance.h"
#include "shape/rectangle.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"
#include "shape/triangle.h"
#include "support/density_test.h"
#include "texture/constant_texture.h"

// Every sampler of chapter 05 against the density that it states, by chi-square. Places are named by coordinates of the
// tests' own, and what a step of them covers (solid angle, area) is measured by finite differences: no formula of the
// library's is used twice. What spreads light is looked at in property_bsdf.cpp.

namespace caustic {
namespace {

using test::DensityTest;
using test::Place;
using test::PlaceSampling;

constexpr Real pi = std::numbers::pi;
constexpr double falseAlarm = 1e-6;

// So many samples of all configurations of a sampler together show an error of 3 % in one octant.
constexpr int samplesForPower = 1'000'000;

Vec2 uniformPair(Random& random) {
    const Real x = random.uniform();
    return {x, random.uniform()};
}

// All configurations hold, and so do they together; a pdf that is wrong by 3 % in the octant that most samples fall
// into would not.
void expectDensities(const std::vector<PlaceSampling>& configurations, const test::Cells& cells, std::uint64_t seed,
                     int samples = samplesForPower) {
    DensityTest test(cells, samples / static_cast<int>(configurations.size()) + 1, seed);
    for (std::size_t i = 0; i < configurations.size(); ++i)
        EXPECT_GT(test.probability(configurations[i]), falseAlarm) << "configuration " << i;
    EXPECT_GT(test.octantProbability(), falseAlarm);
    EXPECT_LT(test.octantProbability(0.03), falseAlarm) << "the test has lost its power";
    EXPECT_LT(test.octantProbability(-0.03), falseAlarm) << "the test has lost its power";
}

// Directions around +z or an axis: z over an interval, and the angle. Archimedes: steps of either are areas.
struct DirectionPlaces {
    Frame frame;
    Real zFrom = -1;
    Real zTo = 1;

    Place place(const Vec3& direction) const {
        const Vec3 local = frame.toLocal(direction);
        return {(local.z() - zFrom) / (zTo - zFrom), std::atan2(local.y(), local.x()) / (2 * pi) + 0.5, 0, 0};
    }
    Vec3 direction(const Place& place) const {
        const Real z = zFrom + place[0] * (zTo - zFrom);
        const Real angle = 2 * pi * (place[1] - 0.5);
        const Real r = std::sqrt(std::max(Real(0), 1 - z * z));
        return frame.toWorld({r * std::cos(angle), r * std::sin(angle), z});
    }
    // Of all places together.
    Real solidAngle() const { return 2 * pi * std::abs(zTo - zFrom); }
};

// What a step of the coordinates `a` and `a + 1` of a place covers, when a place is the point `at`.
template <typename At>
Vec3 stretch(const At& at, const Place& place, std::size_t a) {
    constexpr Real h = 1e-5;
    const auto derivative = [&](std::size_t axis) -> Vec3 {
        Place before = place;
        Place after = place;
        before[axis] -= h;
        after[axis] += h;
        return (at(after) - at(before)) / (2 * h);
    };
    return derivative(a).cross(derivative(a + 1));
}

// Warps.

PlaceSampling warped(const DirectionPlaces& places, Vec3 (*warp)(const Vec2&, Real), Real argument,
                     Real (*density)(Real z, Real argument)) {
    return {[=](Random& random) { return places.place(warp(uniformPair(random), argument)); },
            [=](const Place& at) { return density(places.direction(at).z(), argument) * places.solidAngle(); }};
}

TEST(Densities, UniformSphere) {
    expectDensities(
        {warped(
            {}, [](const Vec2& u, Real) { return uniformSphere(u); }, 0, [](Real, Real) { return 1 / (4 * pi); })},
        test::planeCells, 1);
}

TEST(Densities, CosineHemisphere) {
    expectDensities({warped(
                        {{}, 0, 1}, [](const Vec2& u, Real) { return cosineHemisphere(u); }, 0,
                        [](Real z, Real) { return z / pi; })},
                    test::planeCells, 2);
}

TEST(Densities, UniformCone) {
    std::vector<PlaceSampling> cones;
    for (const Real cosLimit : {-1.0, -0.7, -0.2, 0.0, 0.3, 0.6, 0.9, 0.99, 0.9999})
        cones.push_back(
            warped({{}, cosLimit, 1}, uniformCone, cosLimit, [](Real, Real c) { return 1 / (2 * pi * (1 - c)); }));
    expectDensities(cones, test::planeCells, 3);
}

TEST(Densities, PowerHemisphere) {
    std::vector<PlaceSampling> powers;
    // From where all but e^-40 of the lobe is on, so that cells are as fine as it is.
    for (const Real exponent : {0.0, 0.5, 1.0, 2.0, 6.0, 20.0, 100.0, 500.0, 10'000.0})
        powers.push_back(warped({{}, std::exp(-40 / (exponent + 1)) < 0.5 ? 0 : std::exp(-40 / (exponent + 1)), 1},
                                powerHemisphere, exponent,
                                [](Real z, Real n) { return (n + 1) / (2 * pi) * std::pow(z, n); }));
    expectDensities(powers, test::planeCells, 4);
}

TEST(Densities, ConcentricDisc) {
    const PlaceSampling disc = {[](Random& random) {
                                    const Vec2 p = concentricDisc(uniformPair(random));
                                    return Place{p.squaredNorm(), std::atan2(p.y(), p.x()) / (2 * pi) + 0.5, 0, 0};
                                },
                                [](const Place&) { return 1; }};
    expectDensities({disc}, test::planeCells, 5);
}

// Surfaces: coordinates a and b (of one of six faces, where there are any), and the point that they name. Where it
// matters, steps of a and b make a right-handed system with the normal.
struct Surface {
    std::shared_ptr<const Shape> shape;
    std::function<Vec3(const Place&)> point;
    std::function<Place(const Vec3& point, const Vec2& uv)> place;
};

Surface sphere(const Vec3& center, Real radius) {
    const DirectionPlaces places = {{}, 1, -1};
    return {std::make_shared<Sphere>(center, radius),
            [=](const Place& at) -> Vec3 { return center + radius * places.direction(at); },
            [=](const Vec3& point, const Vec2&) { return places.place((point - center) / radius); }};
}

Surface rectangle(const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV) {
    return {std::make_shared<Rectangle>(corner, edgeU, edgeV),
            [=](const Place& at) -> Vec3 { return corner + at[0] * edgeU + at[1] * edgeV; },
            [](const Vec3&, const Vec2& uv) {
                return Place{uv.x(), uv.y(), 0, 0};
            }};
}

// How far from a, and how far to c: both are lines through a triangle's corner or along its side.
Surface triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {std::make_shared<Triangle>(a, b, c),
            [=](const Place& at) -> Vec3 { return a + at[0] * ((1 - at[1]) * (b - a) + at[1] * (c - a)); },
            [](const Vec3&, const Vec2& uv) {
                return Place{uv.sum(), uv.y() / uv.sum(), 0, 0};
            }};
}

Surface ring(Real inner, Real outer, Real bottom, Real top) {
    const Real width = outer - inner;
    const Real height = top - bottom;
    const Real around = 2 * (width + height);  // without a hole there is the wall all the same, along the axis
    const auto profile = [=](Real v) -> Vec2 {
        Real way = v * around;
        if (way < width) return {inner + way, bottom};
        way -= width;
        if (way < height) return {outer, bottom + way};
        way -= height;
        if (way < width) return {outer - way, top};
        return {inner, top - (way - width)};
    };
    return {std::make_shared<RingCylinder>(inner, outer, bottom, top),
            [=](const Place& at) -> Vec3 {
                const Vec2 across = profile(at[1]);
                return {across.x() * std::cos(2 * pi * at[0]), across.y(), -across.x() * std::sin(2 * pi * at[0])};
            },
            [](const Vec3&, const Vec2& uv) {
                return Place{uv.x(), uv.y(), 0, 0};
            }};
}

// The first coordinate is the face, the other two run along it.
Surface box(const Vec3& low, const Vec3& high) {
    const Vec3 size = high - low;
    return {std::make_shared<Box>(low, high),
            [=](const Place& at) -> Vec3 {
                const int face = static_cast<int>(at[0] * 6);
                Vec3 share;
                share[face / 2] = face % 2;
                share[(face / 2 + 1) % 3] = at[1];
                share[(face / 2 + 2) % 3] = at[2];
                return low + share.cwiseProduct(size);
            },
            [=](const Vec3& point, const Vec2&) {
                const Vec3 share = (point - low).cwiseQuotient(size);
                int axis = 0;
                const Real nearest = share.cwiseMin(Vec3::Ones() - share).cwiseAbs().minCoeff(&axis);
                EXPECT_LT(nearest, 1e-9);
                const int face = 2 * axis + (share[axis] > 0.5 ? 1 : 0);
                return Place{(face + 0.5) / 6, share[(axis + 1) % 3], share[(axis + 2) % 3], 0};
            }};
}

std::vector<Transform> someTransforms() {
    Mat3 sheared;
    sheared << 1, 0.4, -0.3, 0, 0.7, 0.5, 0.2, 0, 1.9;
    return {Transform(),
            Transform::rotation({1, 2, 3}, 0.8),
            Transform::scaling({2.5, 2.5, 2.5}),
            Transform::scaling({0.3, 2, 1}),
            Transform::scaling({1, -1, 4}),
            Transform(sheared, {3, -2, 1})};
}

// The sampler of a surface, in its place and moved, stretched, mirrored and sheared.
std::vector<PlaceSampling> areaSamplers(const Surface& surface, std::size_t along = 0) {
    std::vector<PlaceSampling> samplings;
    for (const Transform& toWorld : someTransforms()) {
        const auto instance = std::make_shared<Instance>(surface.shape, toWorld);
        const Transform toLocal = toWorld.inverse();
        samplings.push_back({[=](Random& random) {
                                 const auto sample = instance->sampleArea(uniformPair(random));
                                 return surface.place(toLocal.point(sample->at.point), sample->at.uv);
                             },
                             [=](const Place& place) {
                                 const auto world = [&](const Place& at) { return toWorld.point(surface.point(at)); };
                                 const Vec3 area = stretch(world, place, along);
                                 if (area.isZero(0)) return Real(0);
                                 SurfacePoint at;
                                 at.point = world(place);
                                 at.ng = area.normalized();
                                 return instance->pdfA(at) * area.norm() * (along > 0 ? 6 : 1);
                             }});
    }
    return samplings;
}

template <typename... More>
std::vector<PlaceSampling> together(std::vector<PlaceSampling> all, const More&... more) {
    (all.insert(all.end(), more.begin(), more.end()), ...);
    return all;
}

TEST(Densities, AreaOfSpheres) {
    expectDensities(together(areaSamplers(sphere({0, 0, 0}, 1)), areaSamplers(sphere({1, -2, 3}, 0.2))),
                    test::planeCells, 6);
}

TEST(Densities, AreaOfRectangles) {
    expectDensities(together(areaSamplers(rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})),
                             areaSamplers(rectangle({1, 2, 3}, {0.1, 0.2, 0}, {-4, 2, 3}))),
                    test::planeCells, 7);
}

TEST(Densities, AreaOfTriangles) {
    expectDensities(together(areaSamplers(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})),
                             areaSamplers(triangle({1, 0, 2}, {4, 1, 2.5}, {-1, 0.2, 2}))),
                    test::planeCells, 8);
}

TEST(Densities, AreaOfRingCylinders) {
    expectDensities(together(areaSamplers(ring(0, 1, 0, 2)), areaSamplers(ring(0.5, 1, -1, 0.5)),
                             areaSamplers(ring(0.9, 1, -0.02, 0.02))),
                    test::planeCells, 9);
}

TEST(Densities, AreaOfBoxes) {
    expectDensities(together(areaSamplers(box({0, 0, 0}, {1, 1, 1}), 1), areaSamplers(box({-1, 2, 0}, {2, 2.1, 7}), 1)),
                    test::faceCells, 10);
}

// Lights: the direction from a point, in coordinates of the light's surface.

std::shared_ptr<const AreaLight> shining(const Surface& surface) {
    return std::make_shared<AreaLight>(surface.shape, std::make_shared<ConstantTexture>(Color::Ones()));
}

PlaceSampling directSampler(const Surface& surface, const Vec3& from) {
    const auto light = shining(surface);
    return {[=](Random& random) -> std::optional<Place> {
                SurfacePoint start;
                start.point = from;
                const auto sample = light->sampleDirect(start, uniformPair(random));
                if (!sample) return std::nullopt;
                const auto hit = surface.shape->intersect({from, sample->wi});
                if (!hit) return std::nullopt;  // by rounding, at an edge
                return surface.place(hit->point, hit->uv);
            },
            [=](const Place& place) {
                const auto direction = [&](const Place& at) { return (surface.point(at) - from).normalized(); };
                const Place& at = place;
                SurfacePoint on;
                on.point = surface.point(at);
                on.ng = stretch(surface.point, at, 0).normalized();
                return light->pdfW(from, on) * stretch(direction, at, 0).norm();
            }};
}

TEST(Densities, DirectLightFromRectangles) {
    std::vector<PlaceSampling> samplings;
    const Surface lamps[] = {rectangle({-1, 0, -1}, {2, 0, 0}, {0, 0, -2}),  // shines up
                             rectangle({0, 0, 0}, {0, 0, 0.01}, {3, 0, 0}), rectangle({1, 0, 1}, {0, 0, 1}, {1, 0, 0})};
    for (const Surface& lamp : lamps) {
        for (const Vec3& from : {Vec3(0, 1, 0), Vec3(0.3, 0.2, 0.5), Vec3(0.5, 0.6, 0.2), Vec3(5, 0.5, 0),
                                 Vec3(-2, 30, 4), Vec3(100, 100, 50), Vec3(1.5, 2, -7), Vec3(0.1, 3, 0)})
            samplings.push_back(directSampler(lamp, from));
    }
    expectDensities(samplings, test::planeCells, 11);
}

// Half of a sphere or more turns its back to any point: samples on it fail. Coordinates from the point's own pole to
// where its view ends.
TEST(Densities, DirectLightFromSpheres) {
    std::vector<PlaceSampling> samplings;
    const Vec3 center(1, 2, 3);
    for (const Real radius : {0.01, 0.5, 4.0}) {
        for (const Real distance : {1.001, 1.01, 1.2, 2.0, 5.0, 30.0, 1000.0}) {
            const Vec3 axis = Vec3(0.3, -0.5, 0.8).normalized();
            const DirectionPlaces seen = {Frame::around(axis), 1, 1 / distance};
            const Surface surface = {
                std::make_shared<Sphere>(center, radius),
                [=](const Place& at) -> Vec3 { return center + radius * seen.direction(at); },
                [=](const Vec3& point, const Vec2&) { return seen.place((point - center) / radius); }};
            samplings.push_back(directSampler(surface, center + distance * radius * axis));
        }
    }
    expectDensities(samplings, test::planeCells, 12, 4 * samplesForPower);
}

TEST(Densities, DirectLightFromTheEnvironment) {
    std::vector<PlaceSampling> samplings;
    for (const Vec3& from : {Vec3(0, 0, 0), Vec3(3, -1, 2)}) {
        const auto light = std::make_shared<ConstantEnvironment>(Color::Ones());
        const DirectionPlaces places;
        samplings.push_back({[=](Random& random) {
                                 SurfacePoint start;
                                 start.point = from;
                                 return places.place(light->sampleDirect(start, uniformPair(random))->wi);
                             },
                             [=](const Place& at) { return light->pdfW(from, places.direction(at)) * 4 * pi; }});
    }
    expectDensities(samplings, test::planeCells, 13);
}

// Emission: place and direction together.

// Cells of the square of the cosine: a direction's coordinates in which light that falls with the cosine is even.
struct CosinePlaces {
    Frame frame;

    void set(const Vec3& direction, Place& place) const {
        const Vec3 local = frame.toLocal(direction);
        place[2] = local.z() * std::abs(local.z());
        place[3] = std::atan2(local.y(), local.x()) / (2 * pi) + 0.5;
    }
    Vec3 direction(const Place& place) const {
        const Real angle = 2 * pi * (place[3] - 0.5);
        const Real r = std::sqrt(1 - place[2]);
        return frame.toWorld({r * std::cos(angle), r * std::sin(angle), std::sqrt(place[2])});
    }
};

PlaceSampling emissionSampler(const Surface& surface) {
    const auto light = shining(surface);
    return {[=](Random& random) {
                const Vec2 uPlace = uniformPair(random);
                const auto sample = light->sampleEmission(uPlace, uniformPair(random));
                // The ray starts beside the surface; there and back it meets the point.
                const auto hit = surface.shape->intersect({sample->ray.origin + sample->ng, -sample->ng});
                Place place = surface.place(hit->point, hit->uv);
                CosinePlaces{Frame::around(sample->ng)}.set(sample->ray.direction, place);
                return place;
            },
            [=](const Place& place) {
                const Vec3 area = stretch(surface.point, place, 0);
                SurfacePoint at;
                at.point = surface.point(place);
                at.ng = area.normalized();
                const CosinePlaces around = {Frame::around(at.ng)};
                const auto direction = [&](const Place& to) { return around.direction(to); };
                const EmissionPdf pdf = light->pdfEmission(at, direction(place));
                return pdf.pdfA * area.norm() * pdf.pdfW * stretch(direction, place, 2).norm();
            }};
}

TEST(Densities, EmissionOfRectangles) {
    std::vector<PlaceSampling> samplings;
    for (const Real width : {0.01, 1.0, 30.0}) {
        for (const Real turn : {0.0, 0.7, 2.0}) {
            const Mat3 turned = Eigen::AngleAxis<Real>(turn, Vec3(1, 2, 2) / 3).toRotationMatrix();
            samplings.push_back(emissionSampler(rectangle({1, 2, 3}, turned.col(0) * width, turned.col(1))));
        }
    }
    expectDensities(samplings, test::rayCells, 14);
}

TEST(Densities, EmissionOfSpheres) {
    std::vector<PlaceSampling> samplings;
    for (const Real radius : {0.01, 0.3, 2.0, 50.0}) {
        for (const Vec3& center : {Vec3(0, 0, 0), Vec3(3, -2, 1)})
            samplings.push_back(emissionSampler(sphere(center, radius)));
    }
    expectDensities(samplings, test::rayCells, 15);
}

PlaceSampling pointEmissionSampler(const std::shared_ptr<const Light>& light, const DirectionPlaces& places) {
    return {[=](Random& random) {
                const Vec2 uPlace = uniformPair(random);
                return places.place(light->sampleEmission(uPlace, uniformPair(random))->ray.direction);
            },
            [=](const Place& at) { return light->pdfEmission({}, places.direction(at)).pdfW * places.solidAngle(); }};
}

TEST(Densities, EmissionOfPoints) {
    std::vector<PlaceSampling> samplings;
    for (const Vec3& position : {Vec3(0, 0, 0), Vec3(1, 2, 3)})
        samplings.push_back(pointEmissionSampler(std::make_shared<PointLight>(position, Color::Ones()), {}));
    expectDensities(samplings, test::planeCells, 16);
}

TEST(Densities, EmissionOfCones) {
    std::vector<PlaceSampling> samplings;
    for (const Real halfAngle : {0.01, 0.1, 0.3, 0.8, 1.2, pi / 2, 2.0, 2.9, pi}) {
        for (const Vec3& axis : {Vec3(0, -1, 0), Vec3(0, 0, -1), Vec3(3, 1, -2)}) {
            const DirectionPlaces places = {Frame::around(axis.normalized()), std::cos(halfAngle) + 1e-15, 1};
            const auto light = std::make_shared<ConeLight>(Vec3(1, 2, 3), axis, halfAngle, Color::Ones());
            samplings.push_back(pointEmissionSampler(light, places));
        }
    }
    expectDensities(samplings, test::planeCells, 17);
}

// A direction, and a point of the disc before the scene that faces it, with polar coordinates.
TEST(Densities, EmissionOfTheEnvironment) {
    std::vector<PlaceSampling> samplings;
    for (const Bounds3& scene : {Bounds3(Vec3(-1, -1, -1), Vec3(1, 1, 1)), Bounds3(Vec3(0, 0, 0), Vec3(0.01, 0.01, 0)),
                                 Bounds3(Vec3(-5, 0, 2), Vec3(80, 3, 9)), Bounds3()}) {
        const auto light = std::make_shared<ConstantEnvironment>(Color::Ones());
        light->prepare(scene);
        const Vec3 center = scene.isEmpty() ? Vec3(0, 0, 0) : scene.center();
        const Real radius = scene.isEmpty() ? 1 : scene.diagonal().norm() / 2;
        const DirectionPlaces sky;
        samplings.push_back({[=](Random& random) {
                                 const Vec2 uPlace = uniformPair(random);
                                 const auto sample = light->sampleEmission(uPlace, uniformPair(random));
                                 const Vec3 there =
                                     Frame::around(sample->ray.direction).toLocal(sample->ray.origin - center) / radius;
                                 EXPECT_NEAR(there.z(), -1, 1e-9);
                                 Place place = sky.place(sample->ray.direction);
                                 place[2] = there.head<2>().squaredNorm();
                                 place[3] = std::atan2(there.y(), there.x()) / (2 * pi) + 0.5;
                                 return place;
                             },
                             [=](const Place& at) {
                                 const EmissionPdf pdf = light->pdfEmission({}, sky.direction(at));
                                 return pdf.pdfW * 4 * pi * pdf.pdfA * pi * radius * radius;
                             }});
    }
    expectDensities(samplings, test::rayCells, 18);
}

// Cameras: the direction of a uniform point of the film, in coordinates of the plane before the pinhole.
TEST(Densities, PinholeCameras) {
    std::vector<PlaceSampling> samplings;
    struct Pose {
        Vec3 position, target, up;
    };
    const Pose poses[] = {{Vec3(0, 0, 0), Vec3(0, 0, -1), Vec3(0, 1, 0)},
                          {Vec3(1, 2, 3), Vec3(0, 0.5, -1), Vec3(0, 1, 0)},
                          {Vec3(-4, 9, 0), Vec3(-4, -7, 0.1), Vec3(1, 0, 1)}};
    for (const Pose& pose : poses) {
        for (const Real fieldOfView : {0.05, 0.5, 1.0, 1.6, 2.2, 2.8}) {
            for (const Vec2& size : {Vec2(64, 64), Vec2(160, 90), Vec2(20, 300), Vec2(1, 1)}) {
                const auto camera =
                    std::make_shared<PinholeCamera>(pose.position, pose.target, pose.up, fieldOfView,
                                                    static_cast<int>(size.x()), static_cast<int>(size.y()));
                const Vec3 forward = (pose.target - pose.position).normalized();
                const Vec3 right = forward.cross(pose.up).normalized();
                const Frame view = {right, right.cross(forward), forward};
                const Real halfHeight = std::tan(fieldOfView / 2);
                const Real halfWidth = halfHeight * size.x() / size.y();
                samplings.push_back({[=](Random& random) {
                                         const Vec2 film = uniformPair(random).cwiseProduct(size);
                                         const Vec3 local = view.toLocal(camera->sampleRay(film, {0.5, 0.5}).direction);
                                         return Place{(local.x() / local.z() / halfWidth + 1) / 2,
                                                      (local.y() / local.z() / halfHeight + 1) / 2, 0, 0};
                                     },
                                     [=](const Place& place) {
                                         const auto direction = [&](const Place& at) -> Vec3 {
                                             const Vec3 local((2 * at[0] - 1) * halfWidth, (2 * at[1] - 1) * halfHeight,
                                                              1);
                                             return view.toWorld(local.normalized());
                                         };
                                         return camera->pdf({pose.position, direction(place)}).pdfW *
                                                stretch(direction, place, 0).norm();
                                     }});
            }
        }
    }
    expectDensities(samplings, test::planeCells, 19);
}

// The kit itself: a density that is too large everywhere is wrong, and so is one that forgets what fails.
TEST(Densities, ClaimsMustAddUp) {
    const PlaceSampling tooLarge = {[](Random& random) {
                                        const Vec2 u = uniformPair(random);
                                        return Place{u.x(), u.y(), 0, 0};
                                    },
                                    [](const Place&) { return 1.001; }};
    EXPECT_EQ(DensityTest(test::planeCells, 1000, 20).probability(tooLarge), 0);
    const PlaceSampling failing = {[](Random& random) -> std::optional<Place> {
                                       const Vec2 u = uniformPair(random);
                                       if (u.x() < 0.1) return std::nullopt;
                                       return Place{u.x(), u.y(), 0, 0};
                                   },
                                   [](const Place&) { return 1; }};
    EXPECT_EQ(DensityTest(test::planeCells, 10'000, 21).probability(failing), 0);
}

}  // namespace
}  // namespace caustic
