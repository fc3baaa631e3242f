#pragma once

#include "shape/shape.h"

namespace caustic {

/// A sphere. Seen with y up: u is the angle around y, counterclockwise from +x, v rises from the south pole to the
/// north pole; both over [0, 1]. point = centre + radius · (sin πv · cos 2πu, −cos πv, −sin πv · sin 2πu).
class Sphere final : public Shape {
public:
    /// @throws InputError unless the centre is finite and the radius finite and positive
    Sphere(const Vec3& center, Real radius);

    /// Centre and radius as they were given.
    const Vec3& center() const { return center_; }
    Real radius() const { return radius_; }

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override;
    std::optional<AreaSample> sampleArea(const Vec2& u) const override;
    Real pdfA(const SurfacePoint& at) const override;

private:
    std::optional<Real> nearestT(const Ray& ray) const;
    SurfacePoint surfacePoint(const Vec3& outward) const;

    Vec3 center_;
    Real radius_;
    Real magnitude_;
};

}  // namespace caustic
