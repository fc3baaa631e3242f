#pragma once

#include "curve/bezier_patch.h"
#include "sampling/discrete_distribution.h"
#include "shape/shape.h"
#include "surface/patch_roots.h"

namespace caustic {

/// A Bézier patch on [0, 1]² as a shape. Its normal points to ∂u × ∂v; where one of the two vanishes (a collapsed edge)
/// it is the limit from inside the patch, to six digits.
class PatchSurface final : public Shape {
public:
    /// @throws InputError when a degree is above PlaneNet::highestDegree or the patch has no area
    explicit PatchSurface(BezierPatch patch);

    /// What it was made from.
    const BezierPatch& patch() const { return patch_; }

    /// The unit normal at (u, v) in [0, 1]².
    Vec3 normal(Real u, Real v) const;

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override { return bounds_; }
    std::optional<AreaSample> sampleArea(const Vec2& u) const override;
    Real pdfA(const SurfacePoint& at) const override;

private:
    std::vector<PatchRoot> rootsAlong(const Ray& ray) const;

    BezierPatch patch_;
    Bounds3 bounds_;
    Real magnitude_;
    DiscreteDistribution cells_;
};

}  // namespace caustic
