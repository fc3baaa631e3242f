#include <cstdio>

#include "core/progress.h"
#include "curve/arc_length.h"
#include "example_curves.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "figures.h"
#include "length_methods.h"
#include "measures/reference_length.h"

namespace caustic {

namespace {

struct TestCurve {
    std::string name;
    BezierCurve curve;
    Real113 length;
};

std::vector<TestCurve> testCurves() {
    const BezierCurve arch = archCurve();
    const BezierCurve cusp = cuspidalCubic(0.375, 3, 0);
    return {{"smooth", arch, referenceLength(arch.controlPoints())},
            {"cusp", cusp, referenceLength(cusp.controlPoints(), {0.375})}};
}

struct Measurement {
    std::string method;
    std::string setting;
    Real error;  // relative to the length
};

struct Plan {
    std::vector<Measurement> measurements;
    std::vector<std::function<void()>> pieces;

    void add(const TestCurve& test, const std::string& method, const std::string& setting,
             const std::function<Real()>& length) {
        const Real113 error = abs(Real113(length()) - test.length) / test.length;
        measurements.push_back({method, "curve=" + test.name + ";" + setting, static_cast<Real>(error)});
        pieces.push_back([length] { keep(length()); });
    }
};

std::string threeDigits(Real value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2e", value);
    return text;
}

void addMeasurements(Plan& plan, const TestCurve& test) {
    for (int segments = 1; segments <= 16384; segments *= 4) {
        plan.add(test, "chords", "evaluations=" + std::to_string(segments + 1),
                 [curve = test.curve, segments] { return chordLength(curve, segments); });
    }
    for (const int points : {2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64}) {
        plan.add(test, "Gauss-Legendre (one rule)", "evaluations=" + std::to_string(points),
                 [curve = test.curve, rule = gaussLegendreRule(points)] { return plainGaussLength(curve, rule); });
    }
    int before = 0;
    for (Real tolerance = 0.1; tolerance > 1e-14; tolerance /= 10) {
        const Real asked = tolerance * static_cast<Real>(test.length);
        const LengthEstimate estimate = gaussLength(test.curve, asked);
        if (estimate.evaluations == before) continue;  // the same pieces, so the same result
        before = estimate.evaluations;
        const Real bound = estimate.error / static_cast<Real>(test.length);
        plan.add(test, "Gauss-Legendre (adaptive)",
                 "evaluations=" + std::to_string(estimate.evaluations) + ";bound=" + threeDigits(bound),
                 [curve = test.curve, asked] { return gaussLength(curve, asked).length; });
    }
}

}  // namespace

void chartLength(FigureContext& context) {
    Plan plan;
    for (const TestCurve& test : testCurves()) addMeasurements(plan, test);
    const auto nanoseconds = medianNanoseconds(plan.pieces, {context.byQuality(5, 21), context.byQuality(5e-4, 2e-3)});

    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (std::size_t i = 0; i < plan.measurements.size(); ++i) {
        const auto& [method, setting, error] = plan.measurements[i];
        table.addRow(method, setting, nanoseconds[i], "ns per length", error, "relative to the length");
    }
    table.save(context.output("length.csv"));
    context.chart("measures/length.gp", "length.png");
}

}  // namespace caustic
