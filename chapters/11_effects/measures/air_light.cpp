#include "measures/air_light.h"

#include <cmath>
#include <numbers>

#include "camera/pinhole_camera.h"
#include "curve/gauss_legendre.h"
#include "light/point_light.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "shape/sphere.h"

namespace caustic {

SceneDescription AirLight::scene(int width, int height) const {
    const auto fog = std::make_shared<HomogeneousMedium>(sigmaA, sigmaS, std::make_shared<HenyeyGreenstein>(g));
    SceneDescription scene;
    scene.objects = {{.shape = std::make_shared<Sphere>(Vec3::Zero(), size), .interior = Interior{1, fog, 0}}};
    scene.lights = {std::make_shared<PointLight>(lamp, intensity)};
    scene.camera = std::make_shared<PinholeCamera>(eye, lamp, Vec3::UnitZ(), 0.6, width, height);
    return scene;
}

Color AirLight::scatteredOnce(const Vec3& direction) const {
    static const GaussRule rule = gaussLegendreRule(24);
    constexpr int pieces = 8;
    const Real middle = -eye.dot(direction);
    const Real tEnd = middle + std::sqrt(size * size - (eye + middle * direction).squaredNorm());
    const Real foot = (lamp - eye).dot(direction);
    const Real beside = (lamp - eye - foot * direction).norm();
    const Real from = std::atan(-foot / beside);
    const Real half = (std::atan((tEnd - foot) / beside) - from) / (2 * pieces);
    Color sum = Color::Zero();
    for (int piece = 0; piece < pieces; ++piece) {
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const Real angle = from + half * (2 * piece + 1 + rule.nodes[i]);
            const Real t = foot + beside * std::tan(angle);
            const Real d = beside / std::cos(angle);
            // Where the lamp lies ahead of the place, its light goes nearly straight on to the eye.
            const Real cosine = (foot - t) / d;
            const Real phase = (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
            sum += rule.weights[i] * phase * (-(sigmaA + sigmaS) * (t + d)).exp();
        }
    }
    // dt = d² dθ / beside, and the lamp's light falls off as 1/d².
    return sum * sigmaS * intensity * (half / beside);
}

}  // namespace caustic
