#include "core/progress.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "figures.h"
#include "measures/evaluation_error.h"

namespace caustic {

namespace {

constexpr int degrees[] = {3, 7, 15, 30, highestDegree};

struct Measurement {
    std::string method;
    std::string setting;
    double error;  // ulp of the largest control coordinate
};

// What is measured and the work to time for it, in step.
struct Plan {
    std::vector<Measurement> measurements;
    std::vector<std::function<void()>> pieces;
};

// Draws a whole curve, preparation included, and so asks of every method what forward differencing can do.
template <typename Scalar>
std::function<void()> walkAlong(const EvaluationMethod<Scalar>& method, int degree, std::uint64_t seed) {
    Random random(seed, {static_cast<std::uint64_t>(degree)});
    const auto parameters = equalSteps<Scalar>(walkSteps);
    return [evaluate = method.evaluate, controlPoints = randomControlPoints<Scalar>(degree, random), parameters,
            points = std::vector<PointOf<Scalar>>(parameters.size())]() mutable {
        evaluate(controlPoints, parameters, points);
        keep(points.front());
    };
}

template <typename Scalar>
void addMeasurements(Plan& plan, const std::string& scalar, FigureContext& context) {
    for (const auto& method : evaluationMethods<Scalar>()) {
        for (const int degree : degrees) {
            const double error = worstErrorInUlp(method, degree, {}, context.seed(), context.threads());
            plan.measurements.push_back({method.name, "degree=" + std::to_string(degree) + ";scalar=" + scalar, error});
            plan.pieces.push_back(walkAlong(method, degree, context.seed()));
            context.progress().advance();
        }
    }
}

}  // namespace

void chartSpeedAccuracy(FigureContext& context) {
    context.progress().expect(41);
    Plan plan;
    addMeasurements<float>(plan, "float", context);
    addMeasurements<double>(plan, "double", context);
    const auto nanoseconds = medianNanoseconds(plan.pieces, {context.byQuality(7, 31), context.byQuality(5e-4, 2e-3)});

    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (std::size_t i = 0; i < plan.measurements.size(); ++i) {
        const auto& [method, setting, error] = plan.measurements[i];
        table.addRow(method, setting, nanoseconds[i] / (walkSteps + 1), "ns per point", error,
                     "ulp of the largest control coordinate");
    }
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
}

}  // namespace caustic
