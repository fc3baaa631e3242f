#pragma once

#include <array>
#include <optional>

#include "core/random.h"
#include "curve/surface_jet.h"
#include "math/ray.h"

namespace caustic {

/// A surface that is a function of two parameters in [0, 1], and goes on outside.
class ParametricSurface {
public:
    virtual ~ParametricSurface() = default;

    /// Point and derivatives at (u, v).
    virtual SurfaceJet evaluate(Real u, Real v) const = 0;

    /// Whether v = 0 and v = 1 are the same place, so that v may run beyond.
    virtual bool closedInV() const = 0;
};

/// Where Newton's method starts, and where it ends: L(t) = B(u, v).
struct NewtonPoint {
    Real t;  ///< in lengths of the ray's direction
    Real u;
    Real v;
};

/// When Newton's method gives up; the report's values.
struct NewtonLimits {
    Real stray = 0.3;        ///< how far u and v may go outside of [0, 1]
    int iterations = 10;     ///< steps, at most
    Real tolerance = 1e-10;  ///< distance between L(t) and B(u, v) at which they have met, in the surface's unit
};

/// Solves F(t, u, v) = L(t) - B(u, v) = 0 by Newton's method, the report's way. The gap |L - B| is looked at before
/// each step and after the last one: within limits.tolerance the two have met. Gives up when a step takes u or v
/// farther than limits.stray out of [0, 1] (v only if the surface isn't closed in it) or t below 0, when it makes
/// one of them no number or infinite (the determinant is 0), or after limits.iterations steps. The ray's tMin and
/// tMax play no part.
/// @return a meeting with u in [0, 1], and v too unless the surface is closed in v: then v is what came out, not
///         brought back into [0, 1]; nothing when it gave up or met the surface outside of its domain
std::optional<NewtonPoint> newtonMeeting(const ParametricSurface& surface, const Ray& ray, const NewtonPoint& start,
                                         const NewtonLimits& limits = {});

/// Starting points; a fixed number, so that none of them costs an allocation.
struct NewtonStarts {
    std::array<NewtonPoint, 64> start;  ///< the first `count` of them
    std::size_t count = 0;              ///< how many there are

    /// Appends one; when full, does nothing.
    void add(const NewtonPoint& point) {
        if (count < start.size()) start[count++] = point;
    }
};

/// The starting point at (u, v) with t where the ray passes nearest to B(u, v).
NewtonPoint startAt(const ParametricSurface& surface, const Ray& ray, Real u, Real v);

/// So many random starts; at most 64 count.
NewtonStarts randomStarts(const ParametricSurface& surface, const Ray& ray, int count, Random& random);

/// The report's second remedy: the centres of 4 × 4 cells of the domain.
NewtonStarts gridStarts(const ParametricSurface& surface, const Ray& ray);

/// The nearest meeting with tMin < t < tMax that Newton's method finds from any of the starts.
std::optional<NewtonPoint> nearestByNewton(const ParametricSurface& surface, const Ray& ray, const NewtonStarts& starts,
                                           const NewtonLimits& limits = {});

}  // namespace caustic
