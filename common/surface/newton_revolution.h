#pragma once

#include <optional>
#include <vector>

#include "core/random.h"
#include "shape/ring_cylinder.h"
#include "surface/revolved_curve.h"

namespace caustic {

/// Where the report lets Newton's method start on each revolved segment.
enum class NewtonStartRule {
    Random,     ///< so many random points
    Grid,       ///< 4 × 4 points, the nearest result counts
    Bracketing  ///< before and behind each meeting that samples of the profile betray
};

/// A surface of revolution intersected the report's way: each segment bounded by a ring cylinder, Newton's method from
/// the rule's starts. It may lose meetings; SurfaceOfRevolution does not.
class NewtonRevolution {
public:
    /// @param samples  pieces of each segment for bracketing starts, or the number of random ones; 1 to 64, pieces 1 to
    /// 32
    /// @throws InputError for another number
    NewtonRevolution(const std::vector<BezierCurve>& profile, NewtonStartRule rule, int samples = 8);

    /// t of the nearest meeting found with tMin < t < tMax.
    /// @param random  for random starts; other rules don't use it
    std::optional<Real> intersect(const Ray& ray, Random& random) const;

private:
    struct Segment {
        RevolvedCurve curve;
        RingCylinder ring;
    };

    NewtonStarts startsOn(const Segment& segment, const Ray& ray, Random& random) const;

    std::vector<Segment> segments_;
    NewtonStartRule rule_;
    int samples_;
};

}  // namespace caustic
