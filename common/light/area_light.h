#pragma once

#include <memory>

#include "light/light.h"
#include "shape/shape.h"
#include "texture/texture.h"

namespace caustic {

/// A shape that shines: each point of it sends the same radiance into all directions on the side that ng points to.
/// With a Rectangle it is the report's rectangle light.
class AreaLight final : public Light {
public:
    /// @param radiance  over the shape's u and v, W/(m²·sr)
    /// @throws InputError when the shape or the texture is missing, or the shape can't be sampled
    AreaLight(std::shared_ptr<const Shape> shape, std::shared_ptr<const Texture> radiance);

    /// Picks a point of the shape, as its sampleArea does. Nothing when that point shows its back or its edge, or is
    /// `from` itself. The ray leaves both surfaces as spawnRayTo says.
    std::optional<DirectSample> sampleDirect(const SurfacePoint& from, const Vec2& u) const override;
    Real pdfW(const Vec3& from, const SurfacePoint& on) const override;
    using Light::pdfW;
    std::optional<EmissionSample> sampleEmission(const Vec2& uPlace, const Vec2& uDirection) const override;
    EmissionPdf pdfEmission(const SurfacePoint& at, const Vec3& direction) const override;
    Color Le(const SurfacePoint& on, const Vec3& wo) const override;
    using Light::Le;

    /// π · area · mean radiance; exact when the texture is constant or the shape's u and v keep areas alike.
    Color power() const override;

private:
    std::shared_ptr<const Shape> shape_;
    std::shared_ptr<const Texture> radiance_;
    Real area_;
};

}  // namespace caustic
