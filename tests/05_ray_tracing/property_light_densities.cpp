#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <vector>

#include "camera/pinhole_camera.h"
#include "density_places.h"
#include "light/area_light.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "shape/box.h"
#include "shape/instance.h"
#include "shape/rectangle.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"
#include "shape/triangle.h"
#include "support/density_test.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

using namespace test;

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

}  // namespace
}  // namespace caustic
