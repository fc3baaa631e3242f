#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "core/csv_table.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "core/text.h"
#include "core/timing.h"
#include "figures.h"
#include "leaving.h"
#include "math/frame.h"
#include "reference_113bit.h"
#include "shape/ball.h"
#include "sphere_methods.h"

namespace caustic {

namespace {

constexpr int smallestExponent = 0;
constexpr int largestExponent = 7;
constexpr std::size_t raysPerBatch = 1024;

template <typename Scalar>
struct SphereMethod {
    std::string name;
    BasicInterval<Scalar> (*interval)(const VectorOf<Scalar>&, const VectorOf<Scalar>&, Scalar);
};

template <typename Scalar>
std::vector<SphereMethod<Scalar>> sphereMethods() {
    return {{"textbook quadratic", textbookQuadratic<Scalar>},
            {"projection by Pythagoras", pythagorasProjection<Scalar>},
            {"projection", ballInterval<Scalar, 3>},
            {"stable quadratic", stableQuadratic<Scalar>}};
}

// A ray as seen from its origin, and the sphere of radius 1 that it is aimed at.
template <typename Scalar>
struct SphereCase {
    VectorOf<Scalar> toCenter;
    VectorOf<Scalar> direction;
};

// Aimed at a point of the disc of 0.9 radii that faces the ray's origin, `distance` radii from the surface.
template <typename Scalar>
std::vector<SphereCase<Scalar>> sphereCases(double distance, std::size_t count, std::uint64_t seed) {
    std::vector<SphereCase<Scalar>> cases;
    for (std::size_t i = 0; i < count; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(distance), i});
        const Frame frame = Frame::around(randomDirection(random));
        const double aside = 0.9 * std::sqrt(random.uniform());
        const double angle = 2 * std::numbers::pi * random.uniform();
        const Vec3 toCenter = (distance + 1) * frame.n;
        const Vec3 target = toCenter + aside * (std::cos(angle) * frame.s + std::sin(angle) * frame.t);
        cases.push_back({toCenter.cast<Scalar>(), target.normalized().cast<Scalar>()});
    }
    return cases;
}

// Root mean square of the relative error in the nearer t; a hit that is lost counts as 1. In fixed order.
template <typename Scalar>
double errorOf(const SphereMethod<Scalar>& method, double distance, FigureContext& context) {
    const auto cases = sphereCases<Scalar>(distance, context.byQuality(1000, 10'000), context.seed());
    std::vector<double> squares(cases.size());
    parallelFor(static_cast<std::int64_t>(cases.size()), context.threads(), [&](std::int64_t i) {
        const auto& [toCenter, direction] = cases[static_cast<std::size_t>(i)];
        const auto found = method.interval(toCenter, direction, Scalar(1));
        double& square = squares[static_cast<std::size_t>(i)];
        square = 1;
        if (found.empty()) return;
        const Real113 truth = nearerRoot113<Scalar>(toCenter, direction, Scalar(1));
        const double relative = static_cast<double>((Real113(found.lower) - truth) / truth);
        square = relative * relative;
    });
    double sum = 0;
    for (const double square : squares) sum += square;
    return std::sqrt(sum / static_cast<double>(squares.size()));
}

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
            plan.errors.push_back(errorOf(method, distance, context));
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
    context.chart("speed_accuracy.gp", "speed_accuracy.png");
}

}  // namespace caustic
