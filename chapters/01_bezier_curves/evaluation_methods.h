#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace caustic {

/// A point in the precision that is judged.
///
/// Below are four ways to find the points of a Bézier curve, each written as a user would, in one precision throughout.
/// They share one signature, so that the charts can exchange them: control points in, the curve's points at the given
/// parameters out. What a method has to prepare (binomials, the power basis, differences) it prepares in the call.
/// The library's own BezierCurve is not used: it knows doubles only.
template <typename Scalar>
using PointOf = Eigen::Matrix<Scalar, 3, 1>;

/// Highest degree that the methods here take; their scratch space is on the stack, so that no timing includes a heap.
inline constexpr int highestDegree = 60;

namespace detail {

template <typename Scalar>
using Scratch = std::array<PointOf<Scalar>, highestDegree + 1>;

// C(n, 0) ... C(n, n) by C(n, i) = C(n, i-1) (n-i+1) / i, rounded at each step once they pass 1 / epsilon.
template <typename Scalar>
std::array<Scalar, highestDegree + 1> binomialRow(int n) {
    std::array<Scalar, highestDegree + 1> row{};
    row[0] = 1;
    for (int i = 1; i <= n; ++i) {
        row[static_cast<std::size_t>(i)] =
            row[static_cast<std::size_t>(i - 1)] * static_cast<Scalar>(n - i + 1) / static_cast<Scalar>(i);
    }
    return row;
}

// Coefficients of 1, t, t^2 ...: a_j = C(n, j) (j-th forward difference of the control points at the first).
template <typename Scalar>
Scratch<Scalar> powerBasis(std::span<const PointOf<Scalar>> controlPoints) {
    const auto count = controlPoints.size();
    const auto binomials = binomialRow<Scalar>(static_cast<int>(count) - 1);
    Scratch<Scalar> coefficients;
    std::copy(controlPoints.begin(), controlPoints.end(), coefficients.begin());
    for (std::size_t order = 1; order < count; ++order) {
        for (std::size_t i = count - 1; i >= order; --i) coefficients[i] -= coefficients[i - 1];
    }
    for (std::size_t j = 0; j < count; ++j) coefficients[j] *= binomials[j];
    return coefficients;
}

}  // namespace detail

/// De Casteljau's algorithm: n (n+1) / 2 linear interpolations a point.
template <typename Scalar>
void pointsByDeCasteljau(std::span<const PointOf<Scalar>> controlPoints, std::span<const Scalar> parameters,
                         std::span<PointOf<Scalar>> points) {
    detail::Scratch<Scalar> level;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const Scalar t = parameters[k];
        const Scalar s = 1 - t;
        std::copy(controlPoints.begin(), controlPoints.end(), level.begin());
        for (std::size_t left = controlPoints.size() - 1; left > 0; --left) {
            for (std::size_t i = 0; i < left; ++i) level[i] = s * level[i] + t * level[i + 1];
        }
        points[k] = level[0];
    }
}

/// The sum of C(n,i) (1-t)^(n-i) t^i P_i, nested so that each power costs one product: about 4 n operations a point
/// and coordinate. Source: Farin, Curves and Surfaces for CAGD, 5th ed. (2002), ch. 5 (his program "hornbez").
template <typename Scalar>
void pointsByBernstein(std::span<const PointOf<Scalar>> controlPoints, std::span<const Scalar> parameters,
                       std::span<PointOf<Scalar>> points) {
    const std::size_t n = controlPoints.size() - 1;
    const auto binomials = detail::binomialRow<Scalar>(static_cast<int>(n));
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const Scalar t = parameters[k];
        const Scalar s = 1 - t;
        Scalar power = 1;
        PointOf<Scalar> sum = controlPoints[0];
        for (std::size_t i = 1; i <= n; ++i) {
            power *= t;
            sum = s * sum + (power * binomials[i]) * controlPoints[i];
        }
        points[k] = sum;
    }
}

/// Horner's scheme on a_0 + a_1 t + a_2 t^2 + ...: n products and n sums a point and coordinate, the fewest of all.
/// The coefficients are found in the same precision, which is where most of the error comes from.
template <typename Scalar>
void pointsByPowerBasis(std::span<const PointOf<Scalar>> controlPoints, std::span<const Scalar> parameters,
                        std::span<PointOf<Scalar>> points) {
    const auto coefficients = detail::powerBasis(controlPoints);
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const Scalar t = parameters[k];
        PointOf<Scalar> sum = coefficients[controlPoints.size() - 1];
        for (std::size_t j = controlPoints.size() - 1; j > 0; --j) sum = sum * t + coefficients[j - 1];
        points[k] = sum;
    }
}

/// Forward differencing: the points at 0, h, 2h ... 1 by n sums each and no product. `parameters` only say how many
/// points are asked for; they must be i / (count - 1), for at least two points.
///
/// The differences at 0 come from the power basis in units of the step (Newton's form by synthetic division), the way
/// that loses least. Source: Foley, van Dam, Feiner, Hughes, Computer Graphics, 2nd ed., section 11.2.9.
template <typename Scalar>
void pointsByForwardDifferences(std::span<const PointOf<Scalar>> controlPoints, std::span<const Scalar> parameters,
                                std::span<PointOf<Scalar>> points) {
    const std::size_t n = controlPoints.size() - 1;
    const Scalar step = 1 / static_cast<Scalar>(parameters.size() - 1);
    auto differences = detail::powerBasis(controlPoints);
    Scalar scale = 1;
    for (std::size_t j = 1; j <= n; ++j) {
        scale *= step;
        differences[j] *= scale;
    }
    for (std::size_t node = 1; node < n; ++node) {
        for (std::size_t j = n; j > node; --j) differences[j - 1] += static_cast<Scalar>(node) * differences[j];
    }
    // Times j!, factor by factor: 35! overflows a float, although the difference that it belongs to is tiny.
    for (std::size_t factor = 2; factor <= n; ++factor) {
        for (std::size_t j = factor; j <= n; ++j) differences[j] *= static_cast<Scalar>(factor);
    }

    for (auto& point : points) {
        point = differences[0];
        for (std::size_t j = 0; j < n; ++j) differences[j] += differences[j + 1];
    }
}

}  // namespace caustic
