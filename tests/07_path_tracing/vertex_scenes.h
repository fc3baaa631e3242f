#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "material/diffuse_material.h"
#include "medium/absorbing_medium.h"
#include "medium/phase_function.h"
#include "sampling/independent_sampler.h"
#include "sampling/warp.h"
#include "scene/scene.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "support/leaning_mesh.h"
#include "support/translucent.h"

namespace caustic::test {

/// Sizes of scenes, m.
inline constexpr Real sizes[] = {1e-6, 1, 1e6};
/// Numbers of all paths.
inline const IndependentSampler independent(1);
/// A colour of surfaces: no two channels alike.
inline const Color rho(0.8, 0.5, 0.3);
/// What tinted air absorbs, 1/m.
inline const Color sigma(0.7, 0.1, 2);

/// A diffuse material.
inline std::shared_ptr<const Material> diffuse(const Color& reflectance) {
    return std::make_shared<DiffuseMaterial>(reflectance);
}

/// The plane y = height, which faces up.
inline SceneObject floorAt(Real height, const Color& reflectance) {
    return {std::make_shared<Plane>(Vec3(0, height, 0), Vec3::UnitY()), diffuse(reflectance), {}, nullptr};
}

/// Tinted air that no surface bounds.
inline SceneObject tintedAir(const Vec3& low, const Vec3& high, const Color& sigmaA = sigma) {
    SceneObject air;
    air.shape = std::make_shared<Box>(low, high);
    air.interior = Interior{1, std::make_shared<AbsorbingMedium>(sigmaA), 0};
    return air;
}

/// Paper around tinted air: a box from (−1, −1, −1) to (1, 1, 1).
inline SceneObject lantern(const Color& through, const Color& back) {
    SceneObject box = tintedAir({-1, -1, -1}, {1, 1, 1});
    box.material = std::make_shared<TranslucentMaterial>(through, back);
    return box;
}

/// Where a ray meets a surface.
inline Interaction meet(const Scene& scene, const Vec3& from, const Vec3& towards) {
    MediumStack media = scene.mediaAt(from);
    Color passed;
    RayCounts counts;
    return *scene.follow({from, (towards - from).normalized()}, media, passed, counts);
}

/// Scatters more of the light on, the more straight on it goes: 1/(4π) (1 − wo · wi / 2).
class ForwardPhase final : public PhaseFunction {
public:
    Real p(const Vec3& wo, const Vec3& wi) const override { return (1 - wo.dot(wi) / 2) / (4 * std::numbers::pi); }
    PhaseSample sample(const Vec3& wo, const Vec2& u) const override {
        const Vec3 wi = uniformSphere(u);
        return {wi, p(wo, wi), pdfW(wo, wi)};
    }
    Real pdfW(const Vec3&, const Vec3&) const override { return 1 / (4 * std::numbers::pi); }
};

/// Equal to 1e-9 of each channel; the question is what leads to the mistake.
inline void expectColor(const Color& found, const Color& expected, const std::string& question) {
    const Color scale = (expected == 0).select(expected.maxCoeff(), expected);
    EXPECT_LE(((found - expected) / scale).abs().maxCoeff(), 1e-9)
        << question << "\nfound " << found.transpose() << ", expected " << expected.transpose();
}

}  // namespace caustic::test
