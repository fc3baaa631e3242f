#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "figures.h"
#include "measures/sphere_accuracy.h"

namespace caustic {

namespace {

constexpr int smallestExponent = 0;
constexpr int largestExponent = 7;
constexpr std::size_t raysPerBatch = 1024;

template <typename Scalar>
std::function<void()> batchOf(const SphereMethod<Scalar>& method, double distance, std::uint64_t seed) {
    return [interval = method.interval, cases = sphereCases<Scalar>(distance, raysPerBatch, seed)] {
        Scalar sum = 0;
        for (const auto& [toCenter, direction] : cases) {
            const BasicInterval<Scalar> found = interval(toCenter, direction, Scalar(1));
            if (!found.empty()) sum += found.lower;
        }
        keep(sum);
    };
}

struct Plan {
    std::vector<std::string> methods;
    std::vector<std::string> settings;
    std::vector<double> errors;
    std::vector<std::function<void()>> pieces;
};

template <typename Scalar>
void addMethods(Plan& plan, const std::string& scalar, FigureContext& context) {
    for (const auto& method : sphereMethods<Scalar>()) {
        for (int exponent = smallestExponent; exponent <= largestExponent; ++exponent) {
            const double distance = std::pow(10, exponent);
            plan.methods.push_back(method.name);
            plan.settings.push_back("distance=" + std::to_string(std::lround(distance)) + ";scalar=" + scalar);
            const auto cases = sphereCases<Scalar>(distance, chartedRays, context.seed());
            plan.errors.push_back(sphereError(method, cases, context.threads()));
            plan.pieces.push_back(batchOf(method, distance, context.seed()));
            context.progress().advance();
        }
    }
}

}  // namespace

void chartSpeedAccuracy(FigureContext& context) {
    context.progress().expect(2 * 4 * (largestExponent + 1) + 1);
    Plan plan;
    addMethods<float>(plan, "float", context);
    addMethods<double>(plan, "double", context);
    const auto nanoseconds = medianNanoseconds(plan.pieces, {context.byQuality(7, 31), context.byQuality(5e-4, 2e-3)});

    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (std::size_t i = 0; i < plan.methods.size(); ++i) {
        table.addRow(plan.methods[i], plan.settings[i], nanoseconds[i] / static_cast<double>(raysPerBatch),
                     "ns per test", plan.errors[i], "relative error in t (rms)");
    }
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
}

}  // namespace caustic
