#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/random.h"
#include "curve/bernstein.h"
#include "support/reference_curve.h"

namespace caustic {
namespace {

using test::Quad;

constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;

BernsteinPolynomial randomPolynomial(Random& random, int degree) {
    std::vector<Real> coefficients;
    for (int i = 0; i <= degree; ++i) coefficients.push_back(random.uniform(-1, 1));
    return BernsteinPolynomial(coefficients);
}

// p(t) with 113 bits: the polynomial as the x coordinate of a curve.
Quad exactValue(const BernsteinPolynomial& p, const Quad& t) {
    std::vector<Vec3> points;
    for (const Real c : p.coefficients()) points.emplace_back(c, 0, 0);
    return test::ReferenceCurve(BezierCurve(points)).position(t)[0];
}

// Coefficients of p(t) (b (1-t) + e t), from those of p.
std::vector<Quad> timesLine(const std::vector<Quad>& p, const Quad& b, const Quad& e) {
    const std::size_t n = p.size();  // the product's degree
    std::vector<Quad> product(n + 1, Quad(0));
    for (std::size_t i = 0; i < n; ++i) {
        product[i] += Quad(n - i) / n * b * p[i];
        product[i + 1] += Quad(i + 1) / n * e * p[i];
    }
    return product;
}

// A polynomial with given roots, and the bound of what rounding its coefficients to double changed.
struct KnownRoots {
    BernsteinPolynomial p;
    Real error;
};

KnownRoots withRoots(const std::vector<Real>& roots) {
    std::vector<Quad> product = {Quad(1)};
    for (const Real root : roots) product = timesLine(product, -Quad(root), 1 - Quad(root));
    std::vector<Real> rounded;
    for (const Quad& c : product) rounded.push_back(static_cast<Real>(c));
    const BernsteinPolynomial p(rounded);
    return {p, unitRoundoff * p.magnitude()};
}

Real spuriousBound(const BernsteinPolynomial& p, Real error) {
    const int n = p.degree();
    return 4 * (n + 2) * (n + 2) * unitRoundoff * p.magnitude() + 2 * error;
}

TEST(BernsteinProperty, EvaluationStaysWithinTheStatedRounding) {
    Random random(1, {1});
    for (int degree = 0; degree <= 60; ++degree) {
        const BernsteinPolynomial p = randomPolynomial(random, degree);
        for (int i = 0; i < 20; ++i) {
            const Real t = i < 2 ? i : random.uniform();
            const Quad error = abs(exactValue(p, t) - p.evaluate(t));
            EXPECT_LE(static_cast<Real>(error), (4 * degree + 4) * unitRoundoff * p.magnitude())
                << "degree " << degree << ", t = " << t;
        }
    }
}

TEST(BernsteinProperty, PartsAreTheSamePolynomial) {
    Random random(1, {2});
    for (int degree = 0; degree <= 20; ++degree) {
        const BernsteinPolynomial p = randomPolynomial(random, degree);
        const Real from = random.uniform();
        const Real to = random.uniform(from, 1);
        const auto [left, right] = p.split(from);
        const BernsteinPolynomial part = p.restricted(from, to);
        for (const Real s : {0.0, 0.25, 0.7, 1.0}) {
            const Real rounding = 20 * (degree + 1) * unitRoundoff;
            EXPECT_NEAR(left.evaluate(s), p.evaluate(from * s), rounding);
            EXPECT_NEAR(right.evaluate(s), p.evaluate(from + (1 - from) * s), rounding);
            EXPECT_NEAR(part.evaluate(s), p.evaluate(from + (to - from) * s), rounding);
        }
    }
}

// Misses nothing: each root that went in lies in a bracket that comes out, also roots near each other and near the
// ends.
TEST(BernsteinProperty, FindsEveryRootThatWentIn) {
    Random random(1, {3});
    for (int i = 0; i < 3000; ++i) {
        std::vector<Real> roots;
        const int degree = 1 + i % 12;
        for (int k = 0; k < degree; ++k) {
            const Real kind = random.uniform();
            Real root = random.uniform(-0.5, 1.5);
            if (kind < 0.1) root = 0;
            if (kind > 0.9) root = 1;
            if (k > 0 && kind > 0.2 && kind < 0.35) root = roots.back();
            if (k > 0 && kind > 0.35 && kind < 0.5) root = roots.back() + std::pow(10, random.uniform(-12, -2));
            roots.push_back(root);
        }
        const auto [p, error] = withRoots(roots);
        const BernsteinRoots found = findRoots(p, error);
        ASSERT_FALSE(found.identicallyZero) << "polynomial " << i;
        for (const Real root : roots) {
            if (root < 0 || root > 1) continue;
            const bool held = std::any_of(found.roots.begin(), found.roots.end(),
                                          [&](const BernsteinRoot& r) { return r.low <= root && root <= r.high; });
            EXPECT_TRUE(held) << "polynomial " << i << ": root " << root << " is in no bracket";
        }
    }
}

// What comes back is in order, inside [0, 1], and no false alarm.
TEST(BernsteinProperty, ReportsOnlyWhatIsZeroUpToRounding) {
    Random random(1, {4});
    for (int i = 0; i < 2000; ++i) {
        const BernsteinPolynomial p = randomPolynomial(random, 1 + i % 12);
        const BernsteinRoots found = findRoots(p);
        Real before = 0;
        for (const BernsteinRoot& root : found.roots) {
            EXPECT_GE(root.low, before) << "polynomial " << i;
            EXPECT_LE(root.low, root.t) << "polynomial " << i;
            EXPECT_LE(root.t, root.high) << "polynomial " << i;
            EXPECT_LE(root.high, 1) << "polynomial " << i;
            before = root.high;
            EXPECT_LE(static_cast<Real>(abs(exactValue(p, root.t))), spuriousBound(p, 0)) << "polynomial " << i;
        }
    }
}

// Signs: between one root and the next p has the sign that both report, and a crossing changes it.
TEST(BernsteinProperty, SignsBetweenRootsAreThePolynomials) {
    Random random(1, {5});
    int crossings = 0;
    for (int i = 0; i < 2000; ++i) {
        const BernsteinPolynomial p = randomPolynomial(random, 1 + i % 12);
        const std::vector<BernsteinRoot> roots = findRoots(p).roots;
        for (std::size_t k = 0; k <= roots.size(); ++k) {
            const Real low = k == 0 ? 0 : roots[k - 1].high;
            const Real high = k == roots.size() ? 1 : roots[k].low;
            if (low == high) continue;
            const int sign = exactValue(p, (Quad(low) + high) / 2) > 0 ? 1 : -1;
            if (k > 0) {
                EXPECT_EQ(roots[k - 1].after, sign) << "polynomial " << i;
            }
            if (k < roots.size()) {
                EXPECT_EQ(roots[k].before, sign) << "polynomial " << i;
            }
        }
        crossings +=
            static_cast<int>(std::count_if(roots.begin(), roots.end(), [](const auto& r) { return r.crossing(); }));
        const Real ends = p.coefficients().front() * p.coefficients().back();
        const auto odd = std::count_if(roots.begin(), roots.end(), [](const auto& r) { return r.crossing(); }) % 2;
        EXPECT_EQ(odd == 1, ends < 0) << "polynomial " << i << ": opposite signs at the ends need an odd number";
    }
    EXPECT_GT(crossings, 1000);
}

// Simple roots that are 0.05 apart or more come back to within some ulp, each with a narrow bracket.
TEST(BernsteinProperty, SeparatedRootsAreAccurate) {
    Random random(1, {6});
    for (int i = 0; i < 1000; ++i) {
        std::vector<Real> roots;
        for (int k = 0; k < 1 + i % 6; ++k) roots.push_back(0.05 + 0.15 * k + random.uniform(0, 0.1));
        const std::vector<BernsteinRoot> found = findRoots(withRoots(roots).p).roots;
        ASSERT_EQ(found.size(), roots.size()) << "polynomial " << i;
        for (std::size_t k = 0; k < roots.size(); ++k) {
            EXPECT_NEAR(found[k].t, roots[k], 1e-11) << "polynomial " << i;
            EXPECT_LT(found[k].high - found[k].low, 1e-10) << "polynomial " << i;
            EXPECT_TRUE(found[k].crossing()) << "polynomial " << i;
        }
    }
}

}  // namespace
}  // namespace caustic
