#pragma once

#include "shape/shape.h"

namespace caustic {

/// A flat rectangle. (u, v) run over [0, 1] along its two edges; the normal points along edgeU × edgeV.
class Rectangle final : public Shape {
public:
    /// @param corner  where u = v = 0
    /// @param edgeU   from there to u = 1
    /// @param edgeV   from there to v = 1, perpendicular to edgeU
    /// @throws InputError when a coordinate is not finite, an edge has no length, or the edges aren't perpendicular (to
    ///         1e-9)
    Rectangle(const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV);

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override;
    std::optional<AreaSample> sampleArea(const Vec2& u) const override;
    Real pdfA(const SurfacePoint& at) const override;

private:
    struct Found {
        Real t;
        Vec2 uv;
    };
    std::optional<Found> find(const Ray& ray) const;
    SurfacePoint surfacePoint(const Vec2& uv) const;

    Vec3 corner_;
    Vec3 edgeU_;
    Vec3 edgeV_;
    Vec3 perU_;  // edgeU over its squared length: its product with a way along the edge is how far u goes
    Vec3 perV_;
    Vec3 ng_;
    Real area_;
    Real magnitude_;
};

}  // namespace caustic
