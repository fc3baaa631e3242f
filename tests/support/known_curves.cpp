#include "support/known_curves.h"

#include <cmath>

namespace caustic::test {

BezierCurve parabola() { return BezierCurve({Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(1, 1, 0)}); }

Real parabolaLength(Real t) { return (2 * t * std::sqrt(1 + 4 * t * t) + std::asinh(2 * t)) / 4; }

BezierCurve semicubicalParabola(Real c) {
    // Control point i is the polar form at (3-i) times the left end and i times the right end.
    const Real left = -c;
    const Real right = 1 - c;
    const auto control = [](Real a, Real b, Real d) { return Vec3((a * b + b * d + d * a) / 3, a * b * d, 0); };
    return BezierCurve({control(left, left, left), control(left, left, right), control(left, right, right),
                        control(right, right, right)});
}

Real semicubicalParabolaLength(Real c, Real t) {
    const auto fromCusp = [](Real s) { return (std::pow(4 + 9 * s * s, Real(1.5)) - 8) / 27; };
    return t < c ? fromCusp(c) - fromCusp(t - c) : fromCusp(c) + fromCusp(t - c);
}

BezierCurve wave() {
    const auto point = [](Real w) { return Vec3(w, 1 - w, 5 + 2 * w); };
    return BezierCurve({point(0), point(3), point(-3), point(0)});
}

BezierCurve twoHumps(Real a, Real w) {
    // y = -s⁴/4 + 0.3 w s³/3 + 1.3 w² s²/2; its polar form from the elementary symmetric functions of four values of s.
    std::vector<Vec3> points;
    for (int i = 0; i <= 4; ++i) {
        const Real p = -a;
        const Real q = 1 - a;
        const int n = 4 - i;  // n times p, i times q
        const Real pairs = n * (n - 1) / 2 * p * p + n * i * p * q + i * (i - 1) / 2 * q * q;
        const Real triples = n * (n - 1) * (n - 2) / 6 * p * p * p + n * (n - 1) / 2 * i * p * p * q +
                             n * i * (i - 1) / 2 * p * q * q + i * (i - 1) * (i - 2) / 6 * q * q * q;
        const Real four = std::pow(p, n) * std::pow(q, i);
        const Real y = -four / 4 + w / 10 * triples / 4 + Real(0.65) * w * w * pairs / 6;
        points.emplace_back(Real(i) / 4, y, 0);
    }
    return BezierCurve(points);
}

}  // namespace caustic::test
