#include <gtest/gtest.h>

#include <cmath>

#include "curve/bezier_curve.h"
#include "measures/evaluation_error.h"

namespace caustic {
namespace {

constexpr std::uint64_t seed = 20;
constexpr int chartDegrees[] = {3, 7, 15, 30, 60};

template <typename Scalar>
EvaluationMethod<Scalar> methodNamed(const std::string& name) {
    for (const auto& method : evaluationMethods<Scalar>()) {
        if (method.name == name) return method;
    }
    throw std::out_of_range(name);
}

template <typename Scalar>
double worstError(const std::string& method, int degree) {
    return worstErrorInUlp(methodNamed<Scalar>(method), degree, {}, seed, 2);
}

// De Casteljau's error is at most about 2 n units of rounding of the largest coordinate (a level adds two roundings
// and never enlarges one: its weights are positive and sum to 1); 100 ulp is what the chart promises to degree 60.
TEST(EvaluationMethods, DeCasteljauAndBernsteinStayWithin100UlpToDegree60) {
    for (const int degree : chartDegrees) {
        for (const std::string method : {"de Casteljau", "Bernstein sum"}) {
            EXPECT_LT(worstError<double>(method, degree), 100) << method << ", double, degree " << degree;
            EXPECT_LT(worstError<float>(method, degree), 100) << method << ", float, degree " << degree;
        }
    }
}

// The power basis has coefficients up to about 3^n times the control points, which cancel near t = 1.
TEST(EvaluationMethods, PowerBasisLosesAMillionTimesMoreThanDeCasteljauAtDegree30) {
    EXPECT_GE(worstError<double>("power basis (Horner)", 30), 1e6 * worstError<double>("de Casteljau", 30));
}

// At low degree nothing has grown yet: all four are the same polynomial, so none may have a mistake in its formula.
TEST(EvaluationMethods, AllFourAgreeAtDegree3) {
    for (const auto& method : evaluationMethods<double>()) {
        EXPECT_LT(worstErrorInUlp(method, 3, {}, seed, 2), 1000) << method.name;
    }
}

// Degree 0 is a point and degree 1 a line: the loops of each method run zero times or once.
TEST(EvaluationMethods, AllFourDrawPointsAndLines) {
    const std::vector<PointOf<double>> line = {{1, 2, 3}, {5, 0, 3}};
    const std::vector<double> parameters = equalSteps<double>(4);
    for (const auto& method : evaluationMethods<double>()) {
        std::vector<PointOf<double>> points(parameters.size());
        method.evaluate(line, parameters, points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3 expected(1 + 4 * parameters[i], 2 - 2 * parameters[i], 3);
            EXPECT_TRUE(points[i].isApprox(expected, 1e-15)) << method.name << " at " << parameters[i];
        }
        method.evaluate(std::span(line).first(1), parameters, points);
        for (const auto& point : points) EXPECT_EQ(point, line.front()) << method.name;
    }
}

// The reference is judged by what it cannot share: a monomial's control points, t^n = B(t) for P_n = 1, others 0.
TEST(EvaluationMethods, ReferenceKnowsMonomialsTo100Bits) {
    for (const int degree : chartDegrees) {
        std::vector<PointOf<double>> controlPoints(static_cast<std::size_t>(degree) + 1, PointOf<double>::Zero());
        controlPoints.back() = {1, 0, 0};
        const double t = 0.7;
        const Real113 expected = pow(Real113(t), degree);
        const Real113 error = abs(referencePosition<double>(controlPoints, t)[0] - expected);
        EXPECT_LT(static_cast<double>(error), std::ldexp(static_cast<double>(expected), -100)) << degree;
    }
}

// A partition of unity: with all control points equal, every point of the curve is that point. In 113 bits the sum of
// the weights shows the reference's whole rounding error.
TEST(EvaluationMethods, ReferenceWeightsSumToOne) {
    Random random(seed, {1});
    for (int trial = 0; trial < 200; ++trial) {
        const std::vector<PointOf<double>> controlPoints(61, PointOf<double>(1, 1, 1));
        const Real113 error = abs(referencePosition<double>(controlPoints, random.uniform())[1] - 1);
        EXPECT_LT(static_cast<double>(error), 240 * std::ldexp(1.0, -113));
    }
}

// What students write in common/curve is what the chart calls de Casteljau.
TEST(EvaluationMethods, LibraryCurveIsAsAccurateAsTheChartsDeCasteljau) {
    Random random(seed, {2});
    for (const int degree : chartDegrees) {
        const auto controlPoints = randomControlPoints<double>(degree, random);
        const BezierCurve curve(controlPoints);
        for (int trial = 0; trial < 100; ++trial) {
            const double t = random.uniform();
            const double error = evaluationError<double>(controlPoints, t, curve.position(t));
            EXPECT_LT(error, 100 * ulpOfLargestCoordinate<double>(controlPoints)) << "degree " << degree << ", t " << t;
        }
    }
}

TEST(EvaluationMethods, WorstErrorsDoNotDependOnThreads) {
    for (const auto& method : evaluationMethods<double>()) {
        EXPECT_EQ(worstErrorInUlp(method, 7, {40, 10}, seed, 1), worstErrorInUlp(method, 7, {40, 10}, seed, 2));
    }
}

}  // namespace
}  // namespace caustic
