#include "support/reference_curve.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace caustic::test {

namespace {

// C(n,i) (1-t)^(n-i) t^i for i = 0 ... n. C(60,30) < 2^57, so the binomials are exact integers.
template <typename Number>
std::vector<Number> bernsteinBasis(std::size_t n, const Number& t) {
    std::vector<Number> basis = {Number(1)};
    for (std::size_t i = 1; i <= n; ++i) basis.push_back(basis.back() * t);
    Number power = 1;  // of 1 - t
    std::uint64_t binomial = 1;
    for (std::size_t i = n + 1; i-- > 0;) {
        basis[i] *= power * Number(binomial);
        power *= 1 - t;
        // C(n,i-1) = C(n,i) i / (n-i+1): divided first by what they share, the product stays below 2^64.
        const std::uint64_t common = std::gcd(binomial, n - i + 1);
        binomial = binomial / common * (i / ((n - i + 1) / common));
    }
    return basis;
}

template <typename Number>
Number weightedSum(const std::vector<Number>& basis, const std::vector<Number>& coefficients) {
    return std::inner_product(basis.begin(), basis.end(), coefficients.begin(), Number(0));
}

QuadPoint bernsteinSum(const std::array<std::vector<Quad>, 3>& coefficients, const Quad& t) {
    const std::vector<Quad> basis = bernsteinBasis(coefficients[0].size() - 1, t);
    return {weightedSum(basis, coefficients[0]), weightedSum(basis, coefficients[1]),
            weightedSum(basis, coefficients[2])};
}

// Where `value` is smallest in [low, high], by golden sections, if it has one minimum there.
template <typename Function>
Quad minimumPlace(const Function& value, Quad low, Quad high) {
    const Quad golden = (sqrt(Quad(5)) - 1) / 2;
    Quad left = high - golden * (high - low);
    Quad right = low + golden * (high - low);
    Quad atLeft = value(left);
    Quad atRight = value(right);
    for (int step = 0; step < 50; ++step) {
        if (atLeft < atRight) {
            high = right;
            right = left;
            atRight = atLeft;
            left = high - golden * (high - low);
            atLeft = value(left);
        } else {
            low = left;
            left = right;
            atLeft = atRight;
            right = low + golden * (high - low);
            atRight = value(right);
        }
    }
    return (low + high) / 2;
}

Quad dot(const QuadPoint& a, const QuadPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// |v| to 1e-31: Newton's method for 1/sqrt, from double. Boost's sqrt goes bit by bit and took a third of the time.
Quad norm(const QuadPoint& v) {
    const Quad square = dot(v, v);
    const double start = 1 / std::sqrt(static_cast<double>(square));
    if (!(start > 1e-100 && start < 1e100)) return sqrt(square);
    Quad inverse = start;
    for (int step = 0; step < 2; ++step) inverse *= Quad(1.5) - Quad(0.5) * square * inverse * inverse;
    return square * inverse;
}

// Replaces the coefficients by those of the left half and returns those of the right half.
std::array<std::vector<Quad>, 3> splitRightHalf(std::array<std::vector<Quad>, 3>& coefficients) {
    const Quad half = 0.5;
    std::array<std::vector<Quad>, 3> right = coefficients;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<Quad>& c = right[axis];
        for (std::size_t last = c.size(), i = 0; last > 0; --last, ++i) {
            coefficients[axis][i] = c.front();
            for (std::size_t k = 0; k + 1 < last; ++k) c[k] = half * (c[k] + c[k + 1]);
        }
    }
    return right;
}

QuadPoint controlVector(const std::array<std::vector<Quad>, 3>& coefficients, std::size_t i) {
    return {coefficients[0][i], coefficients[1][i], coefficients[2][i]};
}

// Whether all control vectors lie well to the side of their mean: then the speed is smooth.
bool isSmooth(const std::array<std::vector<Quad>, 3>& velocity) {
    const auto count = velocity[0].size();
    QuadPoint mean{0, 0, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        mean[axis] = std::accumulate(velocity[axis].begin(), velocity[axis].end(), Quad(0)) / count;
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (4 * dot(controlVector(velocity, i), mean) < dot(mean, mean)) return false;
    }
    return true;
}

// Integral of |velocity| over an interval of that width. Halves it until it holds no cusp: only then the agreement of
// two rules means anything (on a fold that no node sees, all rules agree and all are wrong). A part that is shorter
// than `negligible` whatever it does is left.
Quad speedIntegral(std::array<std::vector<Quad>, 3> velocity, const Quad& width, const Quad& negligible) {
    Quad fastest = 0;
    for (std::size_t i = 0; i < velocity[0].size(); ++i) {
        fastest = std::max(fastest, norm(controlVector(velocity, i)));
    }
    if (fastest * width <= negligible) return fastest * width / 2;

    if (isSmooth(velocity)) {
        const auto speed = [&](const Quad& t) { return norm(bernsteinSum(velocity, t)); };
        const Quad coarse = boost::math::quadrature::gauss<Quad, 10>::integrate(speed, Quad(0), Quad(1));
        const Quad fine = boost::math::quadrature::gauss<Quad, 20>::integrate(speed, Quad(0), Quad(1));
        // Twice the points square the error.
        if (abs(coarse - fine) <= Quad(1e-9) * fine) return fine * width;
    }
    const std::array<std::vector<Quad>, 3> right = splitRightHalf(velocity);
    return speedIntegral(velocity, width / 2, negligible) + speedIntegral(right, width / 2, negligible);
}

}  // namespace

ReferenceCurve::ReferenceCurve(const BezierCurve& curve) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<Quad>& c = coordinates_[axis];
        for (const Vec3& point : curve.controlPoints()) c.emplace_back(point[static_cast<Eigen::Index>(axis)]);
        for (std::size_t i = 0; i + 1 < c.size(); ++i) differences_[axis].push_back(curve.degree() * (c[i + 1] - c[i]));
        if (c.size() == 1) differences_[axis].push_back(Quad(0));
    }
}

QuadPoint ReferenceCurve::position(const Quad& t) const { return bernsteinSum(coordinates_, t); }

QuadPoint ReferenceCurve::velocity(const Quad& t) const { return bernsteinSum(differences_, t); }

Quad ReferenceCurve::length() const {
    Quad polygon = 0;
    for (std::size_t i = 0; i < differences_[0].size(); ++i) {
        polygon += norm(controlVector(differences_, i)) / differences_[0].size();
    }
    return speedIntegral(differences_, 1, Quad(1e-19) * polygon);
}

ReferenceCurve::Range ReferenceCurve::range(int axis) const {
    const std::vector<Quad>& c = coordinates_[static_cast<std::size_t>(axis)];
    constexpr int samples = 1024;
    std::vector<double> rounded;
    for (const Quad& coordinate : c) rounded.push_back(static_cast<double>(coordinate));
    std::vector<double> values;  // good enough to see where it turns
    for (int i = 0; i <= samples; ++i) {
        values.push_back(weightedSum(bernsteinBasis(c.size() - 1, static_cast<double>(i) / samples), rounded));
    }
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    const double spread = *highest - *lowest;

    Range range{std::min(c.front(), c.back()), std::max(c.front(), c.back())};
    for (std::size_t i = 0; i <= samples; ++i) {
        const std::size_t before = i == 0 ? 0 : i - 1;
        const std::size_t after = i == samples ? samples : i + 1;
        for (const int sign : {-1, 1}) {
            // The least values of sign × coordinate; between samples it gains far less than a hundredth of its extent.
            if (sign * values[i] > sign * values[before] || sign * values[i] > sign * values[after]) continue;
            const double best = sign > 0 ? *lowest : -*highest;
            if (spread == 0 || sign * values[i] > best + spread / 100) continue;
            const auto height = [&](const Quad& t) {
                return Quad(sign * weightedSum(bernsteinBasis(c.size() - 1, t), c));
            };
            const Quad value = sign * height(minimumPlace(height, Quad(before) / samples, Quad(after) / samples));
            range.low = std::min(range.low, value);
            range.high = std::max(range.high, value);
        }
    }
    return range;
}

}  // namespace caustic::test
