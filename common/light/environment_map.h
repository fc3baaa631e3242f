#pragma once

#include <memory>

#include "image/image.h"
#include "light/light.h"
#include "math/frame.h"
#include "texture/image_distribution.h"

namespace caustic {

/// Light from everywhere beyond the scene, as a panorama has it: a sky, a room, a sun of one pixel. The image is
/// equirectangular (spherical_map.h) and looked up bilinearly; directions are sampled in proportion to its brightness.
/// Source: PBR, 4th ed., 12.5.2, with cells between the pixels' centres, where the look-up is bilinear.
class EnvironmentMap final : public Light {
public:
    /// @param radiance  at each pixel, W/(m²·sr)
    /// @param axes      how the panorama stands in the world: n points to the zenith, s to what the middle column
    ///                  shows; orthonormal, s × t = n
    /// @throws InputError when a value is negative, not finite, or all are 0
    explicit EnvironmentMap(Image radiance, const Frame& axes = {});

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

    /// The mean radiance over all directions, W/(m²·sr); exact.
    const Color& mean() const { return mean_; }

private:
    struct Direction {
        Vec3 to;
        Real pdfW;
    };

    Color radianceFrom(const Vec3& direction) const;
    Direction sampleDirection(const Vec2& u) const;
    Real pdfW(const Vec3& direction) const;

    Image radiance_;
    Frame axes_;
    ImageDistribution distribution_;
    Color mean_;
    Vec3 center_ = Vec3::Zero();
    Real radius_ = 1;
};

/// The light of a panorama. One of a single colour is a ConstantEnvironment: there is nothing to choose.
/// @throws InputError as EnvironmentMap does
std::shared_ptr<Light> environmentLight(Image radiance, const Frame& axes = {});

}  // namespace caustic
