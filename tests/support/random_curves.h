#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/random.h"
#include "curve/bezier_curve.h"

namespace caustic::test {

/// Control points uniform in the cube [-1, 1]³.
BezierCurve randomCurve(Random& random, int degree);

/// A curve whose velocity vanishes, but for rounding, at a random parameter in (0.1, 0.9): B' = (t - c) g(t), g random.
/// For degree 2 a line that is walked back. @param degree at least 2
BezierCurve randomCusp(Random& random, int degree);

/// A curve that ends where it starts. @param degree at least 2
BezierCurve randomLoop(Random& random, int degree);

/// A curve with runs of equal control points, at the ends more often than not.
BezierCurve randomCoincident(Random& random, int degree);

/// A curve whose control points lie on one line, in any order.
BezierCurve randomCollinear(Random& random, int degree);

/// A curve with what it is, for messages: "cusp, degree 5".
struct NamedCurve {
    std::string name;
    BezierCurve curve;
};

/// `count` curves of all the kinds above in turn, degrees 1 to 12 each.
std::vector<NamedCurve> randomCurves(std::uint64_t seed, int count);

}  // namespace caustic::test
