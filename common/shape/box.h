#pragma once

#include "shape/shape.h"

namespace caustic {

/// A box with edges along the axes (turn it by an Instance). Each face has u and v over [0, 1].
class Box final : public Shape {
public:
    /// @throws InputError unless both corners are finite and `low` is below `high` on every axis
    Box(const Vec3& low, const Vec3& high);

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override { return box_; }
    std::optional<AreaSample> sampleArea(const Vec2& u) const override;
    Real pdfA(const SurfacePoint& at) const override;

private:
    struct Face {
        int axis;
        bool high;
    };
    std::optional<Real> nearestT(const Ray& ray) const;
    Face faceAt(const Ray& ray, Real t) const;
    SurfacePoint surfacePoint(Face face, const Vec3& point) const;
    Real faceArea(int axis) const;

    Bounds3 box_;
    Real magnitude_;
};

}  // namespace caustic
