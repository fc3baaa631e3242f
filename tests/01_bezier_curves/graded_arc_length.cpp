#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "curve/arc_length.h"
#include "support/known_curves.h"
#include "support/random_curves.h"
#include "support/reference_curve.h"
#include "support/refusal.h"

namespace caustic {
namespace {

// The parabola, larger or smaller, turned upright and away from the origin.
BezierCurve parabolaOfSize(Real size) {
    const auto at = [&](Real x, Real y) { return Vec3(3 * size, size * (y - 7), size * (2 - x)); };
    return BezierCurve({at(0, 0), at(0.5, 0), at(1, 1)});
}

// A straight line is its own chord. Its ends are 7 apart: 2² + 3² + 6² = 7². It passes through several octants.
TEST(ChordLength, IsExactForALineInSpace) {
    const BezierCurve line({Vec3(1, -2, 3), Vec3(-1, 1, -3)});
    for (const int segments : {1, 2, 7}) {
        EXPECT_NEAR(chordLength(line, segments), 7, 1e-13)
            << segments << " segments: are all of them there, and all three coordinates in each?";
        for (const Real size : {1e-200, 1e200}) {
            const BezierCurve scaled({size * Vec3(1, -2, 3), size * Vec3(-1, 1, -3)});
            EXPECT_NEAR(chordLength(scaled, segments) / size, 7, 1e-13)
                << "size " << size << ": whose square is ∞, or 0?";
        }
    }
}

// The polygon through (t, t²) at t = 0, 1/n ... 1.
TEST(ChordLength, IsThePolygonsThroughEvenlySpacedParameters) {
    for (const int segments : {1, 2, 5, 16}) {
        Real expected = 0;
        for (int i = 0; i < segments; ++i) {
            const Real a = Real(i) / segments;
            const Real b = Real(i + 1) / segments;
            expected += std::hypot(b - a, b * b - a * a);
        }
        EXPECT_NEAR(chordLength(test::parabola(), segments), expected, 1e-13)
            << segments << " segments: at which parameters do they begin and end? They join points of the curve.";
    }
    for (const int none : {0, -1}) {
        EXPECT_TRUE(test::refuses([&] { chordLength(test::parabola(), none); }, "segments", std::to_string(none)))
            << "Into what is the curve cut?";
    }
}

// What the error is for: it holds the truth even when the tolerance is generous.
TEST(GaussLength, ReachesTheToleranceAndBoundsItsError) {
    // The speed |B'| has a kink at the cusp. No rule on the whole interval gets over it.
    for (const Real cusp : {0.11, 0.3, 0.77}) {
        const Real length = gaussLength(test::semicubicalParabola(cusp), 1e-9).length;
        EXPECT_NEAR(length, test::semicubicalParabolaLength(cusp, 1), 1e-9)
            << "cusp at " << cusp << ": are the pieces halved until the error is small enough?";
    }
    constexpr Real tolerance = 0.05;
    for (const Real cusp : {0.11, 0.23, 0.3, 0.45, 0.77}) {
        const LengthEstimate estimate = gaussLength(test::semicubicalParabola(cusp), tolerance);
        const Real truth = test::semicubicalParabolaLength(cusp, 1);
        EXPECT_LE(std::abs(estimate.length - truth), estimate.error)
            << "cusp at " << cusp << ": do the errors of all pieces enter the result's error?";
        EXPECT_LE(estimate.error, tolerance);
    }
    for (const auto& [name, curve] : test::randomCurves(5, 30)) {
        const auto truth = static_cast<Real>(test::ReferenceCurve(curve).length());
        for (const Real wanted : {1e-1, 1e-4, 1e-9, 1e-30}) {
            const LengthEstimate estimate = gaussLength(curve, wanted);
            EXPECT_LE(std::abs(estimate.length - truth), estimate.error + 1e-16 * truth)
                << name << ", tolerance " << wanted << ": is rounding in the error, too?";
            EXPECT_LE(estimate.error, std::max(wanted, 1e-11)) << name << ": what ends the halving?";
            EXPECT_GT(estimate.evaluations, 0) << "How often was the speed asked for?";
        }
    }
}

// A generous tolerance takes little work, a strict one is kept as far as rounding allows: to twice what the error is at
// its smallest. Degrees up to 40, whose speed 16 points no longer follow.
TEST(GaussLength, DoesWhatTheToleranceAsksAndNotMore) {
    for (const Real cusp : {0.11, 0.3, 0.77}) {
        const BezierCurve curve = test::semicubicalParabola(cusp);
        EXPECT_LT(gaussLength(curve, 0.01).evaluations, 3000)
            << "cusp at " << cusp
            << ": is the sum of the errors kept up when a piece is halved, and does it end there?";
        EXPECT_GT(gaussLength(curve, 1e-12).evaluations, gaussLength(curve, 0.01).evaluations)
            << "cusp at " << cusp << ": what is the tolerance for?";
        EXPECT_GT(gaussLength(curve, 0.01).evaluations, 16) << "How often was the speed asked for, in all pieces?";
    }
    for (std::uint64_t i = 0; i < 24; ++i) {
        Random random(45, {i});
        const int degree = i % 3 == 0 ? 40 : 1 + static_cast<int>(i) / 2;
        const BezierCurve curve = i % 4 < 2 || degree < 2 ? test::randomCurve(random, degree)
                                                          : test::randomCusp(random, std::min(degree, 12));
        const auto truth = static_cast<Real>(test::ReferenceCurve(curve).length());
        const Real smallest = gaussLength(curve, 1e-300).error;
        for (Real wanted = 2 * smallest; wanted < 2e4 * smallest; wanted *= 1.31) {
            const LengthEstimate estimate = gaussLength(curve, wanted);
            ASSERT_LE(estimate.error, wanted) << "curve " << i << ": is rounding part of what must not exceed it?";
            ASSERT_LE(std::abs(estimate.length - truth), estimate.error + 1e-16 * truth)
                << "curve " << i << " of degree " << degree << ": does the rule have enough points for it?";
        }
    }
}

// z = x², a parabola's closed form: (2 sqrt(5) + asinh 2) / 4. Between two parameters: the ratio of its differences.
// What is no range is refused.
TEST(GaussLength, MeasuresTheParabolaAndAPartOfIt) {
    const BezierCurve parabola({Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(1, 0, 1)});
    EXPECT_NEAR(gaussLength(parabola, 1e-10).length, test::parabolaLength(1), 1e-10)
        << "Is the sum scaled by half the interval's width, and the speed the norm of all three coordinates?";
    for (const Real middle : {0.1, 0.5, 0.6}) {
        const Real first = gaussLength(test::parabola(), 1e-9, 0, middle).length;
        const Real second = gaussLength(test::parabola(), 1e-9, middle, 1).length;
        EXPECT_NEAR(first / second,
                    test::parabolaLength(middle) / (test::parabolaLength(1) - test::parabolaLength(middle)), 1e-7)
            << "Where do `from` = 0, `to` = " << middle << " enter?";
    }
    EXPECT_THROW(gaussLength(test::parabola(), 1e-9, 0.6, 0.4), InputError) << "Which end comes first?";
    EXPECT_THROW(gaussLength(test::parabola(), 1e-9, 0, 1.1), InputError) << "Where does the curve end?";
    EXPECT_THROW(gaussLength(test::parabola(), 1e-9, -0.1, 1), InputError) << "Where does the curve begin?";
    EXPECT_THROW(gaussLength(test::parabola(), 0), InputError) << "When would it be exact enough?";
    for (const Real place : {0.0, 0.3, 1.0}) {
        const LengthEstimate none = gaussLength(test::parabola(), 1e-9, place, place);
        EXPECT_EQ(none.length, 0) << "From " << place << " to " << place;
        EXPECT_EQ(none.error, 0);
    }
    for (const Real size : {1e-200, 1e-6, 1e6, 1e200}) {
        const LengthEstimate scaled = gaussLength(parabolaOfSize(size), 1e-9 * size);
        EXPECT_NEAR(scaled.length / size, test::parabolaLength(1), 1e-9) << "size " << size << ": whose square is 0?";
        EXPECT_LE(scaled.error / size, 1e-9) << "size " << size;
    }
}

// The closed form again, as a function of t. Pieces agree to 1e-9 of the curve's length, whatever its unit.
TEST(EvenlySpaced, CutsTheParabolaIntoEqualLengths) {
    for (const Real size : {1.0, 1e-6, 1e6}) {
        for (const int count : {1, 5, 150}) {
            const std::vector<Real> cuts = evenlySpaced(parabolaOfSize(size), count);
            ASSERT_EQ(cuts.size(), static_cast<std::size_t>(count + 1)) << "So many pieces have how many ends?";
            EXPECT_EQ(cuts.front(), 0);
            EXPECT_EQ(cuts.back(), 1);
            for (std::size_t i = 1; i < cuts.size(); ++i) {
                EXPECT_NEAR(test::parabolaLength(cuts[i]) - test::parabolaLength(cuts[i - 1]),
                            test::parabolaLength(1) / count, 1e-9 * test::parabolaLength(1))
                    << "size " << size << ", piece " << i << " of " << count
                    << ": is it the length that is cut evenly, and is what remains held against the curve's length?";
            }
        }
    }
    EXPECT_TRUE(test::refuses([] { evenlySpaced(test::parabola(), 0); }, "count", "0")) << "How many pieces?";
}

// |B'| over a part of the curve, by the definition and bisection: the judge of the pieces.
Real lengthOf(const std::vector<Vec3>& points, Real from, Real to) {
    const auto speed = [&](Real t) {
        std::vector<Vec3> level = points;
        for (std::size_t left = level.size(); left > 2; --left) {
            for (std::size_t i = 0; i + 1 < left; ++i) level[i] += t * (level[i + 1] - level[i]);
        }
        return static_cast<Real>(points.size() - 1) * (level[1] - level[0]).norm();
    };
    const std::function<Real(Real, Real, int)> integral = [&](Real a, Real b, int depth) -> Real {
        // Boole's rule, and twice Simpson's, whose difference is the error's size.
        const Real h = (b - a) / 4;
        const std::array<Real, 5> f = {speed(a), speed(a + h), speed(a + 2 * h), speed(a + 3 * h), speed(b)};
        const Real boole = 2 * h / 45 * (7 * f[0] + 32 * f[1] + 12 * f[2] + 32 * f[3] + 7 * f[4]);
        const Real simpson = h / 3 * (f[0] + 4 * f[1] + 2 * f[2] + 4 * f[3] + f[4]);
        if (std::abs(boole - simpson) < 1e-12 || depth > 40) return boole;
        return integral(a, a + 2 * h, depth + 1) + integral(a + 2 * h, b, depth + 1);
    };
    return integral(from, to, 0);
}

// Cusps, loops, lines that are walked back, control points that fall together: what no closed form tells.
TEST(EvenlySpaced, CutsCurvesOfAllKinds) {
    for (const auto& [name, curve] : test::randomCurves(31, 120)) {
        const std::vector<Vec3>& points = curve.controlPoints();
        const Real length = lengthOf(points, 0, 1);
        if (length < 1e-3) continue;
        for (const int count : {2, 7}) {
            const std::vector<Real> cuts = evenlySpaced(curve, count);
            ASSERT_EQ(cuts.size(), static_cast<std::size_t>(count + 1));
            for (std::size_t i = 1; i < cuts.size(); ++i) {
                ASSERT_NEAR(lengthOf(points, cuts[i - 1], cuts[i]), length / count, 1e-9 * length + 1e-10)
                    << name << ", piece " << i << " of " << count
                    << ": does the bracket shrink in each step, whichever way Newton goes?";
            }
        }
    }
}

// Near the cusp the curve hardly moves: Newton's step, remaining length / speed, goes far astray. With the cusp at 0.5
// a cut falls right on it. Large and small, off the origin: pieces agree to 1e-9 of the length all the same.
TEST(EvenlySpaced, GetsPastACusp) {
    for (const Real size : {1.0, 1e-6, 1e6}) {
        for (const Real cusp : {0.11, 0.3, 0.5, 0.77}) {
            std::vector<Vec3> points = test::semicubicalParabola(cusp).controlPoints();
            for (Vec3& point : points) point = size * Vec3(-point.y(), 0.4, point.x());
            for (const int count : {2, 40}) {
                const std::vector<Real> cuts = evenlySpaced(BezierCurve(points), count);
                ASSERT_EQ(cuts.size(), static_cast<std::size_t>(count + 1));
                const Real length = test::semicubicalParabolaLength(cusp, 1);
                for (std::size_t i = 1; i < cuts.size(); ++i) {
                    ASSERT_GT(cuts[i], cuts[i - 1]) << "cut " << i << ", cusp at " << cusp;
                    const Real piece = test::semicubicalParabolaLength(cusp, cuts[i]) -
                                       test::semicubicalParabolaLength(cusp, cuts[i - 1]);
                    ASSERT_NEAR(piece, length / count, 1e-9 * length)
                        << "piece " << i << " of " << count << ", size " << size << ", cusp at " << cusp
                        << ": what stops a step from leaving the bracket, and is each part measured well enough?";
                }
            }
        }
    }
}

// All lengths are 0, and 0 / 0 is no parameter.
TEST(EvenlySpaced, SpacesTheParametersOfACurveWithoutLength) {
    const std::vector<Real> cuts = evenlySpaced(BezierCurve(std::vector<Vec3>(4, Vec3(1, 2, 3))), 4);
    ASSERT_EQ(cuts.size(), 5U) << "So many pieces have how many ends?";
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        EXPECT_NEAR(cuts[i], static_cast<Real>(i) / 4, 1e-15) << "What is divided by the length?";
    }
}

}  // namespace
}  // namespace caustic
