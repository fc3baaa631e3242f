#pragma once

#include "shape/shape.h"
#include "shape/triangle_hit.h"

namespace caustic {

/// One triangle, tested watertight. (u, v) are the barycentric coordinates of b and c; the normal points to where a, b,
/// c run counterclockwise. For many triangles use a mesh (chapter 04).
class Triangle final : public Shape {
public:
    /// @throws InputError when a coordinate is not finite or the triangle has no area
    Triangle(const Vec3& a, const Vec3& b, const Vec3& c);

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override;
    std::optional<AreaSample> sampleArea(const Vec2& u) const override;
    Real pdfA(const SurfacePoint& at) const override;

private:
    SurfacePoint surfacePoint(const Vec2& uv) const;

    Vec3 a_;
    Vec3 b_;
    Vec3 c_;
    Vec3 ng_;
    Real area_;
    Real magnitude_;
};

}  // namespace caustic
