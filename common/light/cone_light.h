#pragma once

#include "light/light.h"
#include "math/frame.h"

namespace caustic {

/// Light from one point into a cone, the same into all directions of it: a spotlight with a sharp edge.
class ConeLight final : public Light {
public:
    /// @param axis       direction of the cone, of any length but 0
    /// @param halfAngle  between the axis and the edge, radians, in (0, π]
    /// @param intensity  within the cone, W/sr
    /// @throws InputError for values outside, or not finite
    ConeLight(const Vec3& position, const Vec3& axis, Real halfAngle, const Color& intensity);

    bool deltaPlace() const override { return true; }
    std::optional<DirectSample> sampleDirect(const SurfacePoint& from, const Vec2& u) const override;
    std::optional<EmissionSample> sampleEmission(const Vec2& uPlace, const Vec2& uDirection) const override;
    EmissionPdf pdfEmission(const SurfacePoint& at, const Vec3& direction) const override;
    Color power() const override;

private:
    bool lights(const Vec3& direction) const { return direction.dot(frame_.n) >= cosLimit_; }
    Real solidAngle() const;

    Vec3 position_;
    Frame frame_;
    Real cosLimit_;
    Color intensity_;
};

}  // namespace caustic
