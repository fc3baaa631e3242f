#pragma once

#include "math/frame.h"
#include "shape/shape.h"

namespace caustic {

/// An infinite plane. u and v are lengths along two axes within it, counted from its point.
class Plane final : public Shape {
public:
    /// @param point   any point of it
    /// @param normal  of any length but zero
    /// @throws InputError when a coordinate is not finite or the normal is zero
    Plane(const Vec3& point, const Vec3& normal);

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override;
    bool bounded() const override { return false; }
    std::optional<AreaSample> sampleArea(const Vec2&) const override { return std::nullopt; }
    Real pdfA(const SurfacePoint&) const override { return 0; }

private:
    Real crossing(const Ray& ray) const;

    Vec3 point_;
    Frame frame_;
};

}  // namespace caustic
