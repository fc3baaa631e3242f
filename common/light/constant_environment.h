#pragma once

#include "light/light.h"

namespace caustic {

/// The same radiance from everywhere beyond the scene: an overcast sky all around, or the inside of a furnace.
class ConstantEnvironment final : public Light {
public:
    /// @param radiance  W/(m²·sr)
    /// @throws InputError unless finite and at least 0
    explicit ConstantEnvironment(const Color& radiance);

    void prepare(const Bounds3& scene) override;
    bool infinite() const override { return true; }
    std::optional<DirectSample> sampleDirect(const SurfacePoint& from, const Vec2& u) const override;
    Real pdfW(const Vec3& from, const Vec3& wi) const override;
    using Light::pdfW;

    /// Rays that meet the sphere around the scene: a direction, then a point of the disc that faces it.
    std::optional<EmissionSample> sampleEmission(const Vec2& uPlace, const Vec2& uDirection) const override;
    EmissionPdf pdfEmission(const SurfacePoint& at, const Vec3& direction) const override;
    Color Le(const Ray& escaped) const override;
    using Light::Le;

    /// What enters the sphere around the scene, W.
    Color power() const override;

private:
    Color radiance_;
    Vec3 center_ = Vec3::Zero();
    Real radius_ = 1;
};

}  // namespace caustic
