#include "failures/failure_cases.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "core/parallel.h"
#include "curve/arc_length.h"
#include "curve/curve_bounds.h"
#include "curve_with_turns.h"
#include "length_methods.h"
#include "measures/evaluation_error.h"

namespace caustic {

namespace {

// Degree 30: one point of a curve with random control points, judged in 113 bits.
template <auto evaluate>
bool losesDigits(Random& random) {
    const auto controlPoints = randomControlPoints<double>(30, random);
    const double t = random.uniform();
    PointOf<double> point;
    evaluate(controlPoints, std::span(&t, 1), std::span(&point, 1));
    return !(evaluationError<double>(controlPoints, t, point) <= 1e-9);
}

// A cubic in float, drawn in 10,000 steps: B(1) is the last control point, so no reference is needed. The curve is at
// most 2 wide; shown 10,000 pixels wide, a step a pixel, half a pixel is 1/10000.
template <auto evaluate>
bool missesItsEnd(Random& random) {
    const auto controlPoints = randomControlPoints<float>(3, random);
    const auto parameters = equalSteps<float>(10000);
    std::vector<PointOf<float>> points(parameters.size());
    evaluate(controlPoints, parameters, points);
    return !((points.back() - controlPoints.back()).cwiseAbs().maxCoeff() <= 1.0f / 10000);
}

// x turns twice between two of nine samples, and its maximum is the first of these turns.
template <auto bounds>
bool cutsTheCurve(Random& random) {
    const Real cell = static_cast<Real>(random.below(8));
    Real highest = (cell + random.uniform()) / 8;
    Real lowest = (cell + random.uniform()) / 8;
    if (highest > lowest) std::swap(highest, lowest);
    // As the cubic x' is symmetric for even turns, the maximum at a third turn nearer than `highest` is the lower one.
    const Real other = lowest + random.uniform() * (lowest - highest);
    const BezierCurve curve = curveWithTurns({highest, lowest, other});
    const Bounds3 box = bounds(curve);
    const Real maximum = static_cast<Real>(referencePosition<Real>(curve.controlPoints(), highest)[0]);
    return box.max().x() < maximum - 1e-9 * box.diagonal().norm();
}

// Some of the first control points lie in one place: the tangent at 0 leads from there to the first other one.
template <auto tangent>
bool losesTheTangent(Random& random) {
    const int degree = 3 + static_cast<int>(random.below(5));
    auto controlPoints = randomControlPoints<double>(degree, random);
    const auto together = 2 + random.below(static_cast<std::uint64_t>(degree) - 1);
    std::fill_n(controlPoints.begin() + 1, together - 1, controlPoints.front());
    const Vec3 limit = (controlPoints[together] - controlPoints.front()).normalized();
    return !((tangent(BezierCurve(controlPoints)) - limit).norm() <= 1e-6);
}

// Newton's method in chapter 03 strays by up to 0.3 from [0, 1]; the curve must be found in the box there as well.
template <auto box>
bool leavesTheBox(Random& random) {
    const BezierCurve curve(randomControlPoints<double>(3 + static_cast<int>(random.below(5)), random));
    const Real t = random.uniform() < 0.5 ? random.uniform(-0.3, 0) : random.uniform(1, 1.3);
    const Bounds3 bounds = box(curve);
    return !(bounds.squaredExteriorDistance(curve.position(t)) <= 1e-18 * bounds.diagonal().squaredNorm());
}

// A cubic that stops and turns back; its length is known in closed form.
template <auto length>
bool missesTheCusp(Random& random) {
    const Real cusp = random.uniform(0.05, 0.95);
    const BezierCurve curve = cuspidalCubic(cusp, 3, random.uniform(0, 2 * std::numbers::pi));
    const Real exact = cuspidalCubicLength(cusp, 3);
    return !(std::abs(length(curve) - exact) <= 1e-6 * exact);
}

constexpr auto nineSamples = [](const BezierCurve& curve) { return sampledBounds(curve, 9); };

constexpr auto derivativeNormalised = [](const BezierCurve& curve) {
    const Vec3 derivative = curve.derivative(0);
    return Vec3(derivative / derivative.norm());
};
constexpr auto limitTangent = [](const BezierCurve& curve) { return curve.tangent(0).value_or(Vec3::Zero()); };

constexpr auto hullBox = [](const BezierCurve& curve) {
    Bounds3 box;
    for (const Vec3& point : curve.controlPoints()) box.extend(point);
    return box;
};
// Control points of the part from -0.3 to 1.3: its hull holds what the hull of [0, 1] does not.
constexpr auto hullBoxOfWiderPart = [](const BezierCurve& curve) {
    const BezierCurve upTo = curve.split(1.3).first;
    return hullBox(upTo.split(-0.3 / 1.3).second);
};

constexpr auto manyChords = [](const BezierCurve& curve) { return chordLength(curve, 64); };
constexpr auto oneRule = [](const BezierCurve& curve) { return plainGaussLength(curve, gaussLegendreRule(64)); };
constexpr auto adaptive = [](const BezierCurve& curve) { return gaussLength(curve, 1e-7).length; };

// A number that all probes of a kind share, so that they draw the same cases.
std::uint64_t kindNumber(const std::string& name) {
    return std::accumulate(name.begin(), name.end(), std::uint64_t{0},
                           [](std::uint64_t sum, char c) { return 31 * sum + static_cast<unsigned char>(c); });
}

}  // namespace

std::vector<FailureProbe> failureProbes() {
    const std::string degree30 = "degree 30: a point off by more than 1e-9";
    const std::string drift = "cubic in float with 10000 steps: the end missed by half a pixel of 10000";
    const std::string turns = "two turns between samples: box too small by more than 1e-9";
    const std::string coincident = "coincident control points: tangent off by more than 1e-6";
    const std::string outside = "t beyond an end by up to 0.3: the point lies outside the box";
    const std::string cusp = "a cusp: length off by more than 1e-6";
    return {
        {"power basis (Horner)", degree30, losesDigits<pointsByPowerBasis<double>>, false},
        {"Bernstein sum", degree30, losesDigits<pointsByBernstein<double>>, true},
        {"de Casteljau", degree30, losesDigits<pointsByDeCasteljau<double>>, true},
        {"forward differencing", drift, missesItsEnd<pointsByForwardDifferences<float>>, false},
        {"de Casteljau", drift, missesItsEnd<pointsByDeCasteljau<float>>, true},
        {"ternary search among 9 samples", turns, cutsTheCurve<nineSamples>, false},
        {"roots of the hodograph", turns, cutsTheCurve<exactBounds>, true},
        {"derivative normalised", coincident, losesTheTangent<derivativeNormalised>, false},
        {"limit of the tangent", coincident, losesTheTangent<limitTangent>, true},
        {"box of the control points", outside, leavesTheBox<hullBox>, false},
        {"box after a split beyond the ends", outside, leavesTheBox<hullBoxOfWiderPart>, true},
        {"64 chords", cusp, missesTheCusp<manyChords>, false},
        {"Gauss-Legendre (one rule of 64)", cusp, missesTheCusp<oneRule>, false},
        {"Gauss-Legendre (adaptive)", cusp, missesTheCusp<adaptive>, true},
    };
}

int countFailures(const FailureProbe& probe, std::uint64_t seed, int threads) {
    std::vector<int> failed(failureTrials);
    parallelFor(failureTrials, threads, [&](std::int64_t trial) {
        Random random(seed, {kindNumber(probe.name), static_cast<std::uint64_t>(trial)});
        failed[static_cast<std::size_t>(trial)] = probe.fails(random) ? 1 : 0;
    });
    return std::accumulate(failed.begin(), failed.end(), 0);
}

}  // namespace caustic
