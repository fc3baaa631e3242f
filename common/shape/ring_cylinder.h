#pragma once

#include <array>

#include "shape/shape.h"

namespace caustic {

/// A solid ring around the y axis: a cylinder with a coaxial hole, or without one.
///
/// u is the angle around y, counterclockwise from +x seen from above: point = (r cos 2πu, y, −r sin 2πu). v runs over
/// [0, 1] around the cross-section, by length: bottom from the inside out, outer wall up, top from the outside in,
/// inner wall down. The report bounds each segment of a surface of revolution by such a ring; chapter 03 does.
class RingCylinder final : public Shape {
public:
    /// The parts of its surface, in the order of v.
    enum class Part { Bottom, OuterWall, Top, InnerWall };

    /// Where a line enters or leaves the solid.
    struct Crossing {
        Real t;
        Part part;
    };

    /// A piece of a line within the solid.
    struct Span {
        Crossing enter;
        Crossing leave;
    };

    /// At most two, in the order of t and apart from each other.
    struct Spans {
        std::array<Span, 2> span;
        int count = 0;

        /// For range-based loops over those that are there.
        const Span* begin() const { return span.data(); }
        const Span* end() const { return span.data() + count; }
    };

    /// @param innerRadius  of the hole, at least 0; 0 for no hole
    /// @param outerRadius  greater than the inner one
    /// @param bottom       lowest y
    /// @param top          highest y, above `bottom`
    /// @throws InputError otherwise
    RingCylinder(Real innerRadius, Real outerRadius, Real bottom, Real top);

    /// The pieces of the ray's whole line, tMin and tMax aside, that are within the solid. Bottom, top and outer
    /// wall belong to it, the inner wall to the hole: a line along that is in the hole. t counts in lengths of the
    /// direction.
    Spans spans(const Ray& ray) const;

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override;
    std::optional<AreaSample> sampleArea(const Vec2& u) const override;
    Real pdfA(const SurfacePoint& at) const override;

private:
    std::optional<Span> convexSpan(const Ray& ray) const;
    std::optional<Crossing> nearest(const Ray& ray) const;
    SurfacePoint surfacePoint(Part part, const Vec3& near) const;
    Real area(Part part) const;
    Real width() const { return outerRadius_ - innerRadius_; }
    Real height() const { return top_ - bottom_; }
    Real perimeter() const { return 2 * (width() + height()); }

    Real innerRadius_;
    Real outerRadius_;
    Real bottom_;
    Real top_;
    Real magnitude_;
};

}  // namespace caustic
