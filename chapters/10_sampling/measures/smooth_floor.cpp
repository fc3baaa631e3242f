#include "measures/smooth_floor.h"

#include <array>
#include <cmath>
#include <numbers>

#include "camera/pinhole_camera.h"
#include "curve/gauss_legendre.h"
#include "modeler/objects.h"

namespace caustic {

namespace {

const Color reflectance(0.8, 0.5, 0.3);
const Color radiance(4, 5, 7);
// In the order in which the lamp's normal, U × V, points downwards.
const std::array<Vec3, 4> lamp = {Vec3(-0.7, 1.4, -0.9), Vec3(0.6, 1.4, -0.9), Vec3(0.6, 1.4, 0.3),
                                  Vec3(-0.7, 1.4, 0.3)};

SceneDescription floorScene(int width) {
    SceneDescription scene;
    scene.objects = {diffuseRectangle({-9, 0, -9}, {0, 0, 18}, {18, 0, 0}, reflectance),
                     rectangleLamp(lamp[0], lamp[1] - lamp[0], lamp[3] - lamp[0], radiance)};
    scene.camera = std::make_shared<PinholeCamera>(Vec3(0.3, 1.2, 1.1), Vec3(-0.1, 0, -0.3), Vec3::UnitY(), 0.8, width,
                                                   width);
    return scene;
}

// Irradiance over radiance at a point of the floor: Lambert 1760, the sum over the polygon's edges of the angle that each
// subtends times the cosine between the floor's normal and that of the edge's plane, halved.
Real irradiance(const Vec3& point) {
    Real sum = 0;
    for (std::size_t i = 0; i < lamp.size(); ++i) {
        const Vec3 a = (lamp[i] - point).normalized();
        const Vec3 b = (lamp[(i + 1) % lamp.size()] - point).normalized();
        const Vec3 across = a.cross(b);
        sum += std::atan2(across.norm(), a.dot(b)) * across.normalized().y();
    }
    return std::abs(sum) / 2;
}

}  // namespace

SmoothFloor::SmoothFloor(int width) : scene_(floorScene(width)) {}

Image SmoothFloor::truth() const {
    static const GaussRule rule = gaussLegendreRule(5);
    const Camera& camera = scene_.camera();
    Image truth(camera.width(), camera.height());
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) {
            Real mean = 0;
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
                    const Vec2 film(x + 0.5 + rule.nodes[i] / 2, y + 0.5 + rule.nodes[j] / 2);
                    const Ray ray = camera.sampleRay(film, {0.5, 0.5});
                    const Vec3 point = ray.origin - ray.origin.y() / ray.direction.y() * ray.direction;
                    mean += rule.weights[i] * rule.weights[j] / 4 * irradiance(point);
                }
            }
            truth.set(x, y, mean / std::numbers::pi * reflectance * radiance);
        }
    }
    return truth;
}

}  // namespace caustic
