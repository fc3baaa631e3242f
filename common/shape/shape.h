#pragma once

#include <optional>

#include "math/bounds.h"
#include "math/hit.h"
#include "math/ray.h"
#include "shape/area_sample.h"

namespace caustic {

/// A surface that rays can meet. Shapes know geometry only: what a surface is made of, a scene looks up by the Hit's
/// object id.
///
/// A shape never changes once it is made, so any number of threads may use it, and groups and instances may share it.
/// Tests: tests/02_intersections/property_shapes.cpp runs every shape through this contract.
class Shape {
public:
    virtual ~Shape() = default;

    /// The nearest hit with tMin < t < tMax, from either side of the surface.
    virtual std::optional<Hit> intersect(const Ray& ray) const = 0;

    /// Whether anything is hit with tMin < t < tMax. Agrees with intersect, and costs less.
    virtual bool occluded(const Ray& ray) const = 0;

    /// A box around the surface; all of space for an unbounded one.
    virtual Bounds3 bounds() const = 0;

    /// Whether the box is finite. What isn't stays out of trees and out of a scene's radius.
    virtual bool bounded() const { return true; }

    /// Picks a point of the surface.
    /// @param u  two uniform numbers in [0, 1)
    /// @return nothing when the surface can't be sampled: an infinite plane; a group, whose members can
    virtual std::optional<AreaSample> sampleArea(const Vec2& u) const = 0;

    /// The density with which sampleArea picks this point of the surface, 1/m²; zero when it never does.
    virtual Real pdfA(const SurfacePoint& at) const = 0;
};

}  // namespace caustic
