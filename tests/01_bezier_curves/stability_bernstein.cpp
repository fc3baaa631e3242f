#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "curve/bernstein.h"

namespace caustic {
namespace {

// Coefficients of (t - root)^m: products of its values at the ends. Exact for the short fractions used here.
BernsteinPolynomial power(Real root, int m) {
    std::vector<Real> coefficients;
    for (int i = 0; i <= m; ++i) coefficients.push_back(std::pow(-root, m - i) * std::pow(1 - root, i));
    return BernsteinPolynomial(coefficients);
}

// One root of multiplicity m comes once, at its place, and crosses if m is odd.
TEST(BernsteinStability, AMultipleRootComesOnce) {
    for (const Real place : {0.25, 0.375, 0.5, 0.8125}) {
        for (int m = 1; m <= 8; ++m) {
            const std::vector<BernsteinRoot> roots = findRoots(power(place, m)).roots;
            ASSERT_EQ(roots.size(), 1U) << "multiplicity " << m << " at " << place;
            EXPECT_NEAR(roots[0].t, place, m <= 2 ? 1e-15 : 1e-6) << "multiplicity " << m;
            EXPECT_LE(roots[0].low, place) << "multiplicity " << m;
            EXPECT_GE(roots[0].high, place) << "multiplicity " << m;
            EXPECT_EQ(roots[0].crossing(), m % 2 == 1) << "multiplicity " << m;
        }
    }
}

// A double root's place is known as well as a simple one's, though p is flat there.
TEST(BernsteinStability, ADoubleRootIsAccurate) {
    Random random(1, {1});
    for (int i = 0; i < 1000; ++i) {
        const Real place = random.uniform(0.01, 0.99);
        const std::vector<BernsteinRoot> roots = findRoots(power(place, 2), 0x1p-52).roots;
        ASSERT_EQ(roots.size(), 1U) << "root " << place;
        EXPECT_NEAR(roots[0].t, place, 1e-14);
        EXPECT_LT(roots[0].high - roots[0].low, 1e-6);
        EXPECT_FALSE(roots[0].crossing());
    }
}

TEST(BernsteinStability, RootsAtTheEndsAreThere) {
    for (int m = 1; m <= 6; ++m) {
        const std::vector<BernsteinRoot> start = findRoots(power(0, m)).roots;
        ASSERT_EQ(start.size(), 1U) << "multiplicity " << m;
        EXPECT_EQ(start[0].t, 0);
        EXPECT_EQ(start[0].low, 0);
        EXPECT_EQ(start[0].before, 0);
        EXPECT_EQ(start[0].after, 1);

        const std::vector<BernsteinRoot> end = findRoots(power(1, m)).roots;
        ASSERT_EQ(end.size(), 1U) << "multiplicity " << m;
        EXPECT_EQ(end[0].t, 1);
        EXPECT_EQ(end[0].high, 1);
        EXPECT_EQ(end[0].after, 0);
    }
    const std::vector<BernsteinRoot> both = findRoots(BernsteinPolynomial({0, 1, 0})).roots;
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[0].t, 0);
    EXPECT_EQ(both[1].t, 1);
}

TEST(BernsteinStability, RootsOutsideDontComeBack) {
    EXPECT_TRUE(findRoots(power(-0.001, 1)).roots.empty());
    EXPECT_TRUE(findRoots(power(1.001, 3)).roots.empty());
    EXPECT_TRUE(findRoots(power(-1e-9, 1)).roots.empty());
    EXPECT_TRUE(findRoots(BernsteinPolynomial({1})).roots.empty());
    EXPECT_TRUE(findRoots(BernsteinPolynomial({1, -0.999, 1})).roots.empty());
}

TEST(BernsteinStability, ZeroEverywhereIsSaidSo) {
    for (const std::size_t count : {1U, 2U, 7U}) {
        const BernsteinRoots zero = findRoots(BernsteinPolynomial(std::vector<Real>(count, 0)));
        EXPECT_TRUE(zero.identicallyZero);
        EXPECT_TRUE(zero.roots.empty());
    }
    EXPECT_TRUE(findRoots(BernsteinPolynomial({1e-17, -1e-17, 1e-18}), 1e-16).identicallyZero);
    EXPECT_FALSE(findRoots(BernsteinPolynomial({1e-17, -1e-17, 1e-18})).identicallyZero);
    EXPECT_FALSE(findRoots(BernsteinPolynomial({0, 0, 0x1p-1000})).identicallyZero);
}

// (t - 1/2)² + gap/4: touches as long as rounding can't tell, misses beyond, crosses twice on the other side.
TEST(BernsteinStability, NearlyTouchingIsDecidedAtRoundingsSize) {
    const auto lifted = [](Real gap) { return BernsteinPolynomial({1 + gap, -1 + gap, 1 + gap}); };
    for (const Real gap : {1e-3, 1e-8, 1e-13}) {
        EXPECT_TRUE(findRoots(lifted(gap)).roots.empty()) << gap;
        const std::vector<BernsteinRoot> two = findRoots(lifted(-gap)).roots;
        ASSERT_EQ(two.size(), 2U) << gap;
        EXPECT_NEAR(two[1].t - two[0].t, std::sqrt(gap / 2) * std::sqrt(2), 1e-3 * std::sqrt(gap)) << gap;
        EXPECT_TRUE(two[0].crossing() && two[1].crossing()) << gap;
    }
    const std::vector<BernsteinRoot> one = findRoots(lifted(0)).roots;
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].t, 0.5);
}

// The answer depends on ratios alone, down to where the coefficients lose digits.
TEST(BernsteinStability, ScaleDoesNotMatter) {
    for (const int exponent : {-900, -500, 500, 900}) {
        std::vector<Real> coefficients = {1, -3, 2, 0.5, -1};
        const std::vector<BernsteinRoot> expected = findRoots(BernsteinPolynomial(coefficients)).roots;
        for (Real& c : coefficients) c = std::ldexp(c, exponent);
        const std::vector<BernsteinRoot> roots = findRoots(BernsteinPolynomial(coefficients)).roots;
        ASSERT_EQ(roots.size(), expected.size());
        for (std::size_t i = 0; i < roots.size(); ++i) EXPECT_EQ(roots[i].t, expected[i].t) << "2^" << exponent;
    }
}

// Chebyshev's polynomial of degree 20 on [0, 1]: 20 roots (1 - cos((2k+1) pi/40)) / 2, close together at the ends.
TEST(BernsteinStability, FindsAllTwentyRootsOfAChebyshevPolynomial) {
    // T_n(2t-1) has Bernstein coefficients (-1)^(n-i) C(2n,2i) / C(n,i).
    constexpr int n = 20;
    std::vector<Real> coefficients;
    for (int i = 0; i <= n; ++i) {
        const Real logarithm = std::lgamma(2 * n + 1) - std::lgamma(2 * i + 1) - std::lgamma(2 * (n - i) + 1) -
                               std::lgamma(n + 1) + std::lgamma(i + 1) + std::lgamma(n - i + 1);
        coefficients.push_back(((n - i) % 2 == 0 ? 1 : -1) * std::exp(logarithm));
    }
    const std::vector<BernsteinRoot> roots = findRoots(BernsteinPolynomial(coefficients)).roots;
    ASSERT_EQ(roots.size(), 20U);
    for (int k = 0; k < n; ++k) {
        const Real expected = (1 - std::cos((2 * k + 1) * std::acos(Real(-1)) / (2 * n))) / 2;
        EXPECT_NEAR(roots[static_cast<std::size_t>(k)].t, expected, 1e-6);  // coefficients to 1e-14 of up to 1e8
    }
}

TEST(BernsteinStability, Degree60EndsInReasonableTime) {
    Random random(1, {3});
    for (int i = 0; i < 20; ++i) {
        std::vector<Real> coefficients;
        for (int k = 0; k <= 60; ++k) coefficients.push_back(random.uniform(-1, 1));
        const BernsteinPolynomial p(coefficients);
        for (const BernsteinRoot& root : findRoots(p).roots) EXPECT_NEAR(p.evaluate(root.t), 0, 1e-12);
    }
    // All but one coefficient zero: flat at both ends.
    std::vector<Real> spike(61, 0);
    spike[30] = 1;
    const std::vector<BernsteinRoot> roots = findRoots(BernsteinPolynomial(spike)).roots;
    ASSERT_EQ(roots.size(), 2U);
    EXPECT_EQ(roots[0].low, 0);
    EXPECT_EQ(roots[1].high, 1);
}

TEST(BernsteinStability, RefusesWhatIsNoPolynomial) {
    EXPECT_THROW(BernsteinPolynomial({}), InputError);
    EXPECT_THROW(BernsteinPolynomial({1, std::numeric_limits<Real>::quiet_NaN()}), InputError);
    EXPECT_THROW(findRoots(BernsteinPolynomial({1, -1}), -1), InputError);
    EXPECT_THROW(findRoots(BernsteinPolynomial({1, -1}), std::numeric_limits<Real>::quiet_NaN()), InputError);
}

}  // namespace
}  // namespace caustic
