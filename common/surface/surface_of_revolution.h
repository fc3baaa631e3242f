#pragma once

#include <vector>

#include "curve/bezier_spline.h"
#include "curve/surface_jet.h"
#include "sampling/discrete_distribution.h"
#include "shape/shape.h"
#include "surface/revolved_segment.h"

namespace caustic {

/// A profile of Bézier curves turned around the y axis: vases, glasses, cups.
///
/// |x| of the profile is the distance from the axis, y the height; z is not used. u runs along the profile, each
/// segment an equal share of [0, 1]; v is the angle in turns: B = (x cos 2πv, y, x sin 2πv). The normal points to the
/// right of the profile's way, so that a profile from the axis at the bottom along the outside to the axis has it
/// outside. A profile that would enclose a negative volume is turned round (u runs the other way), so normals point out
/// of every closed surface whatever way its profile was drawn.
///
/// Intersections are found by RevolvedSegment: none is missed, and none that is not there is reported, lines that touch
/// the surface aside.
class SurfaceOfRevolution final : public Shape {
public:
    /// @param profile  degrees 1 to RevolvedSegment::highestDegree; segments need not meet
    /// @throws InputError when there is none, a degree is another one, all of it lies on the axis, or it is a mere
    /// point
    explicit SurfaceOfRevolution(std::vector<BezierCurve> profile);
    /// The same with a spline's segments.
    explicit SurfaceOfRevolution(const BezierSpline& profile) : SurfaceOfRevolution(profile.segments()) {}

    /// The profile, in the order in which u goes through it.
    const std::vector<BezierCurve>& profile() const { return profile_; }

    /// Point and derivatives at (u, v): u in [0, 1], any v.
    SurfaceJet evaluate(Real u, Real v) const;

    /// The unit normal at (u, v). On the axis, where the derivative by v vanishes, and at cusps it is the limit along
    /// the profile; at the tip of a cone it is the axis' direction.
    Vec3 normal(Real u, Real v) const;

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override { return bounds_; }
    std::optional<AreaSample> sampleArea(const Vec2& u) const override;
    Real pdfA(const SurfacePoint& at) const override;

private:
    struct Place {
        std::size_t segment;
        Real u;  // within the segment
    };

    // The segment that u of the whole surface is on, and where on it.
    Place placeAt(Real u) const;
    Vec3 normalAt(const Place& place, const RevolvedSegment::ProfilePoint& profile, const Vec2& outward) const;
    // Point and derivatives there, x with its sign, by the u of the whole surface (place.u is the segment's own) and
    // by v: any v.
    SurfaceJet jetAt(const Place& place, Real v) const;
    Hit hitAt(const Ray& ray, const Place& place, Real t) const;
    bool canMeet(const Ray& ray) const;

    std::vector<BezierCurve> profile_;
    std::vector<RevolvedSegment> segments_;
    Bounds3 bounds_;
    Real middle_;
    bool rises_;  // whether the profile ends higher than it begins
    Real magnitude_;
    DiscreteDistribution cells_;
};

}  // namespace caustic
