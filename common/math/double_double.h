#pragma once

#include <cmath>

#include "math/real.h"

namespace caustic {

/// A number as the unevaluated sum of two: twice the digits of a Real, some 32 decimal ones, for the rare place where a
/// sign must be right. Overflow and underflow aside; needs strict IEEE arithmetic (no contraction, no fast-math).
/// Source: Dekker 1971; Hida, Li, Bailey 2001, Algorithms for Quad-Double Precision Floating Point Arithmetic.
struct DoubleDouble {
    Real high = 0;  ///< the sum, rounded
    Real low = 0;   ///< what rounding lost

    /// a + b and a - b, exactly.
    static DoubleDouble sum(Real a, Real b) {
        const Real s = a + b;
        const Real ofB = s - a;
        return {s, (a - (s - ofB)) + (b - ofB)};
    }
    static DoubleDouble difference(Real a, Real b) { return sum(a, -b); }

    /// Rounded to twice the precision of a Real.
    friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
        const DoubleDouble s = sum(a.high, b.high);
        const DoubleDouble t = sum(a.low, b.low);
        const DoubleDouble u = sum(s.high, s.low + t.high);
        return sum(u.high, u.low + t.low);
    }
    friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
        return a + DoubleDouble{-b.high, -b.low};
    }
    friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
        const Real p = a.high * b.high;
        return sum(p, std::fma(a.high, b.high, -p) + (a.high * b.low + a.low * b.high));
    }
};

}  // namespace caustic
