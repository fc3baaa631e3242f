#pragma once

#include <memory>

#include "camera/box_filter.h"
#include "integrator/ray_tracer.h"
#include "material/diffuse_material.h"
#include "material/refraction_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/plane.h"
#include "texture/constant_texture.h"

namespace caustic::test {

/// Numbers of all scenes.
inline const IndependentSampler independent(1);
/// The filter of all pictures.
inline const BoxFilter box;

/// A material of that reflectance.
inline std::shared_ptr<const Material> diffuse(Real reflectance) {
    return std::make_shared<DiffuseMaterial>(Color::Constant(reflectance));
}

/// That radiance everywhere.
inline std::shared_ptr<const Texture> shining(Real radiance) {
    return std::make_shared<ConstantTexture>(Color::Constant(radiance));
}

/// The plane y = 0.
inline SceneObject floor(Real reflectance) {
    return {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), .material = diffuse(reflectance)};
}

/// A pane between x = 0 and x = thickness.
inline SceneObject pane(Real thickness, Real reflectance, Real ior, const Color& sigmaA) {
    SceneObject glass;
    glass.shape = std::make_shared<Box>(Vec3(0, -50, -50), Vec3(thickness, 50, 50));
    glass.material =
        std::make_shared<RefractionMaterial>(Color::Constant(reflectance), Color::Constant(1 - reflectance));
    glass.interior = Interior{ior, std::make_shared<AbsorbingMedium>(sigmaA), 0};
    return glass;
}

/// What ray tracing sees along a ray.
inline Color radiance(const Scene& scene, const Ray& ray, const RayTracerSettings& settings = {},
                      RayCounts* counts = nullptr, const Sampler& sampler = independent, std::int64_t index = 0) {
    RayCounts own;
    const RayTracer tracer(scene, sampler, box, settings);
    return tracer.Li(ray, scene.mediaAt(ray.origin), sampler.start(0, {0, 0}, index), counts ? *counts : own);
}

}  // namespace caustic::test
