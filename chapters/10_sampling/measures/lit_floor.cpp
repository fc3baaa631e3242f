#include "measures/lit_floor.h"

#include <cmath>
#include <numbers>

#include "camera/pinhole_camera.h"
#include "curve/gauss_legendre.h"
#include "modeler/objects.h"

namespace caustic {

namespace {

const Color reflectance(0.8, 0.5, 0.3);
const Color radiance(4, 5, 7);

// The lamp's normal, U × V, points to the floor's lit part.
SceneDescription floorScene(const std::array<Vec3, 4>& lamp, std::shared_ptr<const Camera> camera) {
    SceneDescription scene;
    scene.objects = {diffuseRectangle({-9, 0, -9}, {0, 0, 18}, {18, 0, 0}, reflectance),
                     rectangleLamp(lamp[0], lamp[1] - lamp[0], lamp[3] - lamp[0], radiance)};
    scene.camera = std::move(camera);
    return scene;
}

// Irradiance over radiance at a point of the floor: Lambert 1760, the sum over the polygon's edges of the angle that
// each subtends times the cosine between the floor's normal and that of the edge's plane, halved.
Real irradiance(const std::array<Vec3, 4>& lamp, const Vec3& point) {
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

LitFloor::LitFloor(const Corners& lamp, std::shared_ptr<const Camera> camera)
    : lamp_(lamp), scene_(floorScene(lamp, std::move(camera))) {}

LitFloor LitFloor::under(int width) {
    return {
        {Vec3(-0.7, 1.4, -0.9), Vec3(0.6, 1.4, -0.9), Vec3(0.6, 1.4, 0.3), Vec3(-0.7, 1.4, 0.3)},
        std::make_shared<PinholeCamera>(Vec3(0.3, 1.2, 1.1), Vec3(-0.1, 0, -0.3), Vec3::UnitY(), 0.8, width, width)};
}

LitFloor LitFloor::beside(int width) {
    return {{Vec3(-1, 1e-6, -1.2), Vec3(-1, 0.8, -1.2), Vec3(-1, 0.8, 0.9), Vec3(-1, 1e-6, 0.9)},
            std::make_shared<PinholeCamera>(Vec3(0.52, 3, 0), Vec3(0.52, 0, 0), -Vec3::UnitZ(), 0.92, width, width)};
}

Image LitFloor::truth() const {
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
                    mean += rule.weights[i] * rule.weights[j] / 4 * irradiance(lamp_, point);
                }
            }
            truth.set(x, y, mean / std::numbers::pi * reflectance * radiance);
        }
    }
    return truth;
}

}  // namespace caustic
