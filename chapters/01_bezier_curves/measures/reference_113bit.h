#pragma once

#include <Eigen/Core>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>
#include <span>
#include <vector>

namespace caustic {

/// A number with a fraction of 113 bits, as in IEEE 754's binary128: 60 bits more than a double.
using Real113 = boost::multiprecision::cpp_bin_float_quad;
using Point113 = std::array<Real113, 3>;

/// The judge of every evaluation: the definition B(t) = sum of C(n,i) (1-t)^(n-i) t^i P_i, term by term, in 113 bits.
///
/// It shares no code with what it judges. Degrees to 60, whose binomials are exact in 57 bits. In [0, 1] its error is
/// below 4 n 2^-113 of the largest control coordinate (all terms have one sign but for P_i's): some 10^-31.
template <typename Scalar>
Point113 referencePosition(std::span<const Eigen::Matrix<Scalar, 3, 1>> controlPoints, const Real113& t) {
    const std::size_t n = controlPoints.size() - 1;
    std::vector<Real113> powersOfT(n + 1, 1);
    std::vector<Real113> powersOfS(n + 1, 1);
    for (std::size_t i = 1; i <= n; ++i) {
        powersOfT[i] = powersOfT[i - 1] * t;
        powersOfS[i] = powersOfS[i - 1] * (1 - t);
    }
    Point113 sum = {0, 0, 0};
    std::uint64_t binomial = 1;
    for (std::size_t i = 0; i <= n; ++i) {
        const Real113 weight = binomial * powersOfT[i] * powersOfS[n - i];
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += weight * controlPoints[i][static_cast<int>(axis)];
        // C(60, 30) * 30 is just below 2^62: no product overflows.
        binomial = binomial * (n - i) / (i + 1);
    }
    return sum;
}

}  // namespace caustic
