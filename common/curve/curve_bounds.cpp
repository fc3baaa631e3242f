#include "curve/curve_bounds.h"

#include <algorithm>
#include <limits>
#include <string>

#include "core/check.h"
#include "core/not_implemented.h"
#include "curve/bernstein.h"

namespace caustic {

namespace {

constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;

// One coordinate of the curve as a polynomial.
BernsteinPolynomial coordinate(const BezierCurve& curve, int axis) {
    std::vector<Real> coefficients;
    for (const Vec3& point : curve.controlPoints()) coefficients.push_back(point[axis]);
    return BernsteinPolynomial(std::move(coefficients));
}

}  // namespace

Bounds3 sampledBounds(const BezierCurve& curve, int samples) {
    //! [ex-01.7]
    checkArgument(samples >= 2, "samples", std::to_string(samples), "must be at least 2");
    const auto parameter = [&](int i) { return static_cast<Real>(std::clamp(i, 0, samples - 1)) / (samples - 1); };
    const auto highest = [&](const auto& height) {
        Real best = std::max(height(0), height(1));
        for (int i = 0; i < samples; ++i) {
            Real low = parameter(i - 1);
            Real high = parameter(i + 1);
            // Only where the samples turn is there a maximum between the neighbours.
            if (height(parameter(i)) < height(low) || height(parameter(i)) < height(high)) continue;
            for (int step = 0; step < 100; ++step) {
                const Real third = (high - low) / 3;
                if (height(low + third) < height(high - third)) {
                    low += third;
                } else {
                    high -= third;
                }
            }
            best = std::max({best, height(parameter(i)), height(low), height(high)});
        }
        return best;
    };

    Bounds3 box;
    for (int axis = 0; axis < 3; ++axis) {
        const BernsteinPolynomial x = coordinate(curve, axis);
        box.max()[axis] = highest([&](Real t) { return x.evaluate(t); });
        box.min()[axis] = -highest([&](Real t) { return -x.evaluate(t); });
    }
    return box;
    //! [ex-01.7]
}

Bounds3 exactBounds(const BezierCurve& curve) {
    //! [ex-01.8]
    Bounds3 box;
    for (int axis = 0; axis < 3; ++axis) {
        const BernsteinPolynomial x = coordinate(curve, axis);
        const BernsteinPolynomial slope = x.derivative();
        Real low = std::min(x.coefficients().front(), x.coefficients().back());
        Real high = std::max(x.coefficients().front(), x.coefficients().back());
        for (const BernsteinRoot& root : findRoots(slope, 2 * unitRoundoff * slope.magnitude()).roots) {
            // Between the roots x is monotone; at a root it stays within the hull of its coefficients there.
            const BernsteinPolynomial turn = x.restricted(root.low, root.high);
            for (const Real c : turn.coefficients()) {
                low = std::min(low, c);
                high = std::max(high, c);
            }
        }
        const Real padding = 12 * (curve.degree() + 1) * unitRoundoff * x.magnitude();
        box.min()[axis] = low - padding;
        box.max()[axis] = high + padding;
    }
    return box;
    //! [ex-01.8]
}

}  // namespace caustic
