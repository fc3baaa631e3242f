#include <algorithm>
#include <cmath>
#include <numbers>

#include "curve/arc_length.h"
#include "curve/curve_bounds.h"
#include "curve_with_turns.h"
#include "figures.h"
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

// What becomes of a case by each method: all make it of the same numbers.
template <bool (*... fails)(Random&)>
std::vector<bool> judged(Random& random) {
    return {[random]() mutable { return !fails(random); }()...};
}

}  // namespace

std::vector<FailureRow> failureRows(const FailureTrials& trials) {
    return countFailures(
        {{"degree 30: a point off by more than 1e-9",
          {{"power basis (Horner)"}, {"Bernstein sum", true}, {"de Casteljau", true}},
          judged<losesDigits<pointsByPowerBasis<double>>, losesDigits<pointsByBernstein<double>>,
                 losesDigits<pointsByDeCasteljau<double>>>},
         {"cubic in float with 10000 steps: the end missed by half a pixel of 10000",
          {{"forward differencing"}, {"de Casteljau", true}},
          judged<missesItsEnd<pointsByForwardDifferences<float>>, missesItsEnd<pointsByDeCasteljau<float>>>},
         {"two turns between samples: box too small by more than 1e-9",
          {{"ternary search among 9 samples"}, {"roots of the hodograph", true}},
          judged<cutsTheCurve<nineSamples>, cutsTheCurve<exactBounds>>},
         {"coincident control points: tangent off by more than 1e-6",
          {{"derivative normalised"}, {"limit of the tangent", true}},
          judged<losesTheTangent<derivativeNormalised>, losesTheTangent<limitTangent>>},
         {"t beyond an end by up to 0.3: the point lies outside the box",
          {{"box of the control points"}, {"box after a split beyond the ends", true}},
          judged<leavesTheBox<hullBox>, leavesTheBox<hullBoxOfWiderPart>>},
         {"a cusp: length off by more than 1e-6",
          {{"64 chords"}, {"Gauss-Legendre (one rule of 64)"}, {"Gauss-Legendre (adaptive)", true}},
          judged<missesTheCusp<manyChords>, missesTheCusp<oneRule>, missesTheCusp<adaptive>>}},
        trials);
}

void chartFailures(FigureContext& context) { drawFailureBars(failureRows(FailureTrials::of(context, 2000)), context); }

}  // namespace caustic
