#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"
#include "evaluation_methods.h"
#include "measures/reference_113bit.h"

namespace caustic {

/// One of the four methods of evaluation_methods.h, with the name that charts and tables give it.
template <typename Scalar>
struct EvaluationMethod {
    std::string name;
    void (*evaluate)(std::span<const PointOf<Scalar>> controlPoints, std::span<const Scalar> parameters,
                     std::span<PointOf<Scalar>> points);
    bool needsEqualSteps;  ///< whether it can only walk along the curve from 0 to 1
};

/// All four, de Casteljau's first.
template <typename Scalar>
std::vector<EvaluationMethod<Scalar>> evaluationMethods() {
    return {{"de Casteljau", pointsByDeCasteljau<Scalar>, false},
            {"Bernstein sum", pointsByBernstein<Scalar>, false},
            {"power basis (Horner)", pointsByPowerBasis<Scalar>, false},
            {"forward differencing", pointsByForwardDifferences<Scalar>, true}};
}

/// Steps of a walk along the curve. Not a power of two: i / 200 has to be rounded, as a user's step would be.
inline constexpr int walkSteps = 200;

/// 0, 1/steps ... 1.
template <typename Scalar>
std::vector<Scalar> equalSteps(int steps) {
    std::vector<Scalar> parameters;
    for (int i = 0; i <= steps; ++i) parameters.push_back(static_cast<Scalar>(i) / static_cast<Scalar>(steps));
    return parameters;
}

/// Control points that are uniform in the cube [-1, 1]^3.
template <typename Scalar>
std::vector<PointOf<Scalar>> randomControlPoints(int degree, Random& random) {
    std::vector<PointOf<Scalar>> controlPoints(static_cast<std::size_t>(degree) + 1);
    for (auto& point : controlPoints) {
        for (Scalar& coordinate : point) coordinate = static_cast<Scalar>(random.uniform(-1, 1));
    }
    return controlPoints;
}

/// The distance between neighbouring numbers at the largest coordinate of the control points: the natural unit of a
/// rounding error, as every method has to add control points up.
template <typename Scalar>
double ulpOfLargestCoordinate(std::span<const PointOf<Scalar>> controlPoints) {
    Scalar largest = 0;
    for (const auto& point : controlPoints) largest = std::max(largest, point.cwiseAbs().maxCoeff());
    return std::ldexp(1.0, std::ilogb(largest) + 1 - std::numeric_limits<Scalar>::digits);
}

/// Largest difference in a coordinate between `point` and the 113-bit reference at t; infinite for a point that is not
/// finite.
template <typename Scalar>
double evaluationError(std::span<const PointOf<Scalar>> controlPoints, Scalar t, const PointOf<Scalar>& point) {
    if (!point.allFinite()) return std::numeric_limits<double>::infinity();
    const Point113 reference = referencePosition<Scalar>(controlPoints, Real113(t));
    Real113 worst = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        worst = std::max<Real113>(worst, abs(reference[axis] - Real113(point[static_cast<int>(axis)])));
    }
    return static_cast<double>(worst);
}

/// How many random curves a worst error is the worst of, and how many parameters on each.
struct ErrorSample {
    int curves = 100;
    int parameters = 50;
};

/// Worst error of the method over random curves, in ulp of each curve's largest control coordinate.
///
/// The parameters are random in [0, 1]; for a method that needs equal steps, every fourth point of its walk. The result
/// is the same for any number of threads.
template <typename Scalar>
double worstErrorInUlp(const EvaluationMethod<Scalar>& method, int degree, const ErrorSample& sample,
                       std::uint64_t seed, int threads) {
    std::vector<double> worst(static_cast<std::size_t>(sample.curves));
    parallelFor(sample.curves, threads, [&](std::int64_t curve) {
        Random random(seed, {static_cast<std::uint64_t>(degree), static_cast<std::uint64_t>(curve)});
        const auto controlPoints = randomControlPoints<Scalar>(degree, random);
        auto parameters = equalSteps<Scalar>(walkSteps);
        if (!method.needsEqualSteps) {
            parameters.resize(static_cast<std::size_t>(sample.parameters));
            for (Scalar& t : parameters) t = static_cast<Scalar>(random.uniform());
        }

        std::vector<PointOf<Scalar>> points(parameters.size());
        method.evaluate(controlPoints, parameters, points);
        const double ulp = ulpOfLargestCoordinate<Scalar>(controlPoints);
        double& error = worst[static_cast<std::size_t>(curve)];
        for (std::size_t i = 0; i < points.size(); i += method.needsEqualSteps ? 4 : 1) {
            error = std::max(error, evaluationError<Scalar>(controlPoints, parameters[i], points[i]) / ulp);
        }
    });
    return *std::max_element(worst.begin(), worst.end());
}

}  // namespace caustic
