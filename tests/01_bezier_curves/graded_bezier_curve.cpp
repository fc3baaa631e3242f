#include <gtest/gtest.h>

#include "curve/bezier_curve.h"

namespace caustic {
namespace {

// A line's point at t divides it in the proportion t : 1 - t.
TEST(BezierCurve, DegreeOneIsLinearInterpolation) {
    const BezierCurve line({Vec3(0, 0, 0), Vec3(4, -2, 8)});
    EXPECT_TRUE(line.position(0.25).isApprox(Vec3(1, -0.5, 2), 1e-14)) << "Which weight belongs to which end?";
}

}  // namespace
}  // namespace caustic
