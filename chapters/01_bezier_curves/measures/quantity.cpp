#include <algorithm>
#include <cmath>
#include <map>

#include "curve/arc_length.h"
#include "curve/curve_bounds.h"
#include "example_curves.h"
#include "figure/quantities.h"
#include "figures.h"
#include "length_methods.h"
#include "measures/evaluation_error.h"
#include "measures/reference_length.h"

namespace caustic {

namespace {

using Points = std::vector<std::pair<Real, Real>>;

// Slope of the straight line that fits best (least squares).
Real slope(const Points& points) {
    Real meanX = 0;
    Real meanY = 0;
    for (const auto& [x, y] : points) {
        meanX += x / Real(points.size());
        meanY += y / Real(points.size());
    }
    Real above = 0;
    Real below = 0;
    for (const auto& [x, y] : points) {
        above += (x - meanX) * (y - meanY);
        below += (x - meanX) * (x - meanX);
    }
    return above / below;
}

Real relativeError(Real length, const Real113& reference) {
    return static_cast<Real>(Real113(abs(Real113(length) - reference) / reference));
}

void addLengths(CsvTable& table, const std::string& name, const BezierCurve& curve, const Real113& reference) {
    Points chords;
    for (int segments = 64; segments <= 4096; segments *= 2) {
        chords.push_back({std::log2(segments), std::log2(relativeError(chordLength(curve, segments), reference))});
    }
    table.addRow("chords", name, slope(chords), "order: slope of log error over log segments", "113-bit; theory -2");

    const LengthEstimate estimate = gaussLength(curve, 1e-12 * static_cast<Real>(reference));
    table.addRow("Gauss-Legendre (adaptive)", name + ": asked for 1e-12", estimate.evaluations, "evaluations",
                 "its bound");
    table.addRow("Gauss-Legendre (adaptive)", name + ": what it got", relativeError(estimate.length, reference),
                 "relative error", "113-bit");
}

// Where the speed is smooth each further point gains digits; a cusp, where it is not, leaves an order only.
void addPlainRule(CsvTable& table, const BezierCurve& arch, const BezierCurve& cusp) {
    const auto error = [](const BezierCurve& curve, const Real113& reference, int points) {
        return relativeError(plainGaussLength(curve, gaussLegendreRule(points)), reference);
    };
    Points digits;
    const Real113 archLength = referenceLength(arch.controlPoints());
    for (int points = 4; points <= 12; ++points) {
        digits.push_back({Real(points), -std::log10(error(arch, archLength, points))});
    }
    table.addRow("Gauss-Legendre (one rule)", "smooth arch", slope(digits), "digits per further evaluation (4 to 12)",
                 "113-bit");
    Points order;
    const Real113 cuspLength = referenceLength(cusp.controlPoints(), {0.375});
    for (int points = 8; points <= 256; ++points) {
        order.push_back({std::log2(points), std::log2(error(cusp, cuspLength, points))});
    }
    table.addRow("Gauss-Legendre (one rule)", "cusp", slope(order),
                 "order: slope of log error over log evaluations (8 to 256)", "113-bit; theory -2");
}

void addSpacing(CsvTable& table) {
    const BezierCurve curve = unevenCurve();
    const auto ratio = [&](const std::vector<Real>& parameters) {
        std::vector<Real> lengths;
        for (std::size_t i = 1; i < parameters.size(); ++i) {
            lengths.push_back(gaussLength(curve, 1e-12, parameters[i - 1], parameters[i]).length);
        }
        const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
        return *longest / *shortest;
    };
    const std::string unit = "longest piece of 24 over the shortest";
    table.addRow("even in t", "curve of arc_length.png", ratio(equalSteps<Real>(24)), unit, "adaptive Gauss-Legendre");
    table.addRow("even in length", "curve of arc_length.png", ratio(evenlySpaced(curve, 24)), unit,
                 "adaptive Gauss-Legendre");
}

void addEvaluation(CsvTable& table, FigureContext& context) {
    std::map<std::string, std::map<int, Real>> errors;
    for (const auto& method : evaluationMethods<Real>()) {
        for (const int degree : {7, 15, 30, 60}) {
            errors[method.name][degree] = worstErrorInUlp(method, degree, {}, context.seed(), context.threads());
        }
    }
    const auto growth = [&](const std::string& method) {
        Points points;
        for (const auto& [degree, error] : errors[method]) points.push_back({Real(degree), std::log(error)});
        return std::exp(slope(points));
    };
    table.addRow("power basis (Horner)", "degrees 7 to 60; double", growth("power basis (Horner)"),
                 "factor of the worst error per degree", "113-bit; theory 3 at most");
    table.addRow("de Casteljau", "degrees 7 to 60; double", growth("de Casteljau"),
                 "factor of the worst error per degree", "113-bit");
    table.addRow("power basis (Horner)", "degree 30; double",
                 errors["power basis (Horner)"][30] / errors["de Casteljau"][30], "worst error over de Casteljau's",
                 "113-bit");
}

void addDrift(CsvTable& table, std::uint64_t seed) {
    Points points;
    for (int steps = 250; steps <= 16000; steps *= 2) {
        const auto parameters = equalSteps<float>(steps);
        std::vector<PointOf<float>> walk(parameters.size());
        Real sum = 0;
        for (std::uint64_t trial = 0; trial < 200; ++trial) {
            Random random(seed, {static_cast<std::uint64_t>(steps), trial});
            const auto controlPoints = randomControlPoints<float>(3, random);
            pointsByForwardDifferences<float>(controlPoints, parameters, walk);
            sum += static_cast<Real>((walk.back() - controlPoints.back()).norm());
        }
        points.push_back({std::log2(steps), std::log2(sum)});
    }
    table.addRow("forward differencing", "cubic in float", slope(points),
                 "order: slope of log error at the end over log steps (250 to 16000)", "last control point");
}

void addBoxes(CsvTable& table, std::uint64_t seed) {
    Real areas = 0;
    constexpr std::uint64_t trials = 1000;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        Random random(seed, {trial});
        const BezierCurve curve(randomControlPoints<Real>(3, random));
        Bounds3 hull;
        for (const Vec3& point : curve.controlPoints()) hull.extend(point);
        areas += hull.sizes().head<2>().prod() / exactBounds(curve).sizes().head<2>().prod() / Real(trials);
    }
    table.addRow("box of the control points", "1000 random cubics", areas, "mean area over the exact box's",
                 "roots of the hodograph");
}

}  // namespace

void tabulateQuantities(FigureContext& context) {
    const BezierCurve arch = archCurve();
    const BezierCurve cusp = cuspidalCubic(0.375, 3, 0);
    writeQuantities(
        {[&](CsvTable& table) { addLengths(table, "smooth arch", arch, referenceLength(arch.controlPoints())); },
         [&](CsvTable& table) { addLengths(table, "cusp", cusp, referenceLength(cusp.controlPoints(), {0.375})); },
         [&](CsvTable& table) { addPlainRule(table, arch, cusp); }, addSpacing,
         [&](CsvTable& table) { addBoxes(table, context.seed()); },
         [&](CsvTable& table) { addDrift(table, context.seed()); },
         [&](CsvTable& table) { addEvaluation(table, context); }},
        context);
}

}  // namespace caustic
