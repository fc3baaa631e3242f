#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/reference_curve.h"
#include "surface/revolved_segment.h"
#include "surface/surface_of_revolution.h"
#include "turned_profiles.h"

namespace caustic {
namespace {

using test::Quad;

constexpr Real turn = 2 * std::numbers::pi;

// Three segments of different shape and degree, of which the second crosses the axis twice.
std::vector<BezierCurve> unevenProfile(Real size, Real height) {
    const auto at = [&](Real x, Real y) { return Vec3(size * x, size * y + height, 0); };
    return {BezierCurve({at(0.3, -2), at(0.6, -1)}), test::cubicProfile({0.6, -1.9, -0.2, 0.8}, size, height),
            BezierCurve({at(0.8, 1), at(1.7, 1.5), at(0.9, 2)})};
}

// What u and v mean: u runs over all segments, an equal share each; v counts turns, from x towards z.
struct Place {
    Place(const SurfaceOfRevolution& surface, Real u, Real v)
        : segments(static_cast<Real>(surface.profile().size())), c(std::cos(turn * v)), s(std::sin(turn * v)) {
        const auto segment = static_cast<std::size_t>(u * segments);
        const BezierCurve& curve = surface.profile()[segment];
        point = curve.position(u * segments - static_cast<Real>(segment));
        slope = segments * curve.derivative(u * segments - static_cast<Real>(segment));
    }

    Real segments;
    Real c;
    Real s;
    Vec3 point;
    Vec3 slope;
};

TEST(SurfaceOfRevolution, PointsAreTheProfileTurned) {
    for (const auto& [size, height] : {std::pair(1.0, 0.0), std::pair(1e-6, 0.0), std::pair(1e3, 1e6)}) {
        const SurfaceOfRevolution surface(unevenProfile(size, height));
        for (const Real u : {0.0, 0.1, 0.4, 0.5, 0.6, 0.8, 0.99}) {
            for (const Real v : {0.0, 0.1, 0.25, 0.6, 0.97, 1.3}) {
                const Place place(surface, u, v);
                const Vec3& p = place.point;
                const Vec3 expected(p.x() * place.c, p.y(), p.x() * place.s);
                EXPECT_LE((surface.evaluate(u, v).point - expected).norm(), 1e-14 * (size + height))
                    << "u = " << u << ", v = " << v
                    << ": which segment is it on, is v counted in turns, from x towards z, and may x be negative?";
            }
        }
    }
}

// Those of (x cos 2πv, y, x sin 2πv), also where the surface stands far from the origin.
TEST(SurfaceOfRevolution, DerivativesAreTheTurnedProfiles) {
    for (const auto& [size, height] : {std::pair(1.0, 0.0), std::pair(1e-6, 0.0), std::pair(1e3, 1e6)}) {
        const SurfaceOfRevolution surface(unevenProfile(size, height));
        for (const Real u : {0.0, 0.1, 0.4, 0.5, 0.6, 0.8, 0.99}) {
            for (const Real v : {0.0, 0.1, 0.25, 0.6, 0.97, 1.3}) {
                const SurfaceJet jet = surface.evaluate(u, v);
                const Place place(surface, u, v);
                const Vec3& d = place.slope;
                const Vec3 du(d.x() * place.c, d.y(), d.x() * place.s);
                const Vec3 dv = turn * place.point.x() * Vec3(-place.s, 0, place.c);
                EXPECT_LE((jet.du - du).norm(), 1e-13 * (size + height))
                    << "u = " << u << ", v = " << v << ": does u run over all segments from 0 to 1?";
                EXPECT_LE((jet.dv - dv).norm(), 1e-13 * size)
                    << "u = " << u << ", v = " << v << ": how long is the circle that v runs through once?";
            }
        }
    }
}

// A profile and a line, in twice the precision: the coefficients of f and the sum of its terms' magnitudes.
struct ExactEquation {
    ExactEquation(const BezierCurve& profile, const AxisRay& ray) {
        const auto n = static_cast<std::size_t>(profile.degree());
        const auto& points = profile.controlPoints();
        Real x = 0;
        Real h = 0;
        for (const Vec3& point : points) {
            x = std::max(x, std::abs(point.x()));
            h = std::max(h, std::abs(point.y() - ray.baseHeight));
        }
        terms = ray.flatSquare * h * h + 2 * std::abs(ray.drift * ray.rise) * h +
                ray.rise * ray.rise * (x * x + ray.near * ray.near);
        for (std::size_t k = 0; k <= 2 * n; ++k) {
            Quad sum = 0;
            for (std::size_t i = k > n ? k - n : 0; i <= std::min(k, n); ++i) {
                sum += binomial(n, i) * binomial(n, k - i) * mixed(ray, points[i], points[k - i]);
            }
            coefficient.push_back(sum / binomial(2 * n, k));
        }
    }

    static Quad binomial(std::size_t n, std::size_t k) {
        Quad value = 1;
        for (std::size_t i = 1; i <= k; ++i) value = value * Quad(n - k + i) / Quad(i);
        return value;
    }

    // f is a square form in the profile: with two control points in place of one it makes its Bernstein coefficients.
    static Quad mixed(const AxisRay& ray, const Vec3& a, const Vec3& b) {
        const Quad rise(ray.rise);
        const Quad near(ray.near);
        const Quad ha = Quad(a.y()) - Quad(ray.baseHeight);
        const Quad hb = Quad(b.y()) - Quad(ray.baseHeight);
        return rise * rise * (near * near - Quad(a.x()) * Quad(b.x())) + Quad(ray.drift) * rise * (ha + hb) +
               Quad(ray.flatSquare) * ha * hb;
    }

    Real offOf(const RevolvedSegment::Equation& f, std::size_t k) const {
        return std::abs(static_cast<Real>(Quad(f.coefficient[k]) - coefficient[k]));
    }

    std::vector<Quad> coefficient;
    Real terms;
};

// Profiles of any degree, size and height, whole ones and short pieces; lines that lean, rise, and pass far outside.
struct EquationCase {
    explicit EquationCase(std::uint64_t i) {
        Random random(21, {i});
        const Real size = std::pow(10, random.uniform(-30, 30));
        const Real height = size * (i % 3 == 0 ? 0 : random.uniform(-100, 100));
        std::vector<Vec3> points;
        for (std::uint64_t k = 0; k <= 1 + i % 6; ++k)
            points.push_back(size * test::inCube(random) + Vec3(0, height, 0));
        BezierCurve curve(points);
        for (std::uint64_t k = 0; k < i % 4 * 5; ++k) curve = curve.split(random.uniform(0.3, 0.7)).first;
        profile = curve.controlPoints();
        const Real far = i % 5 == 0 ? 100 : 2;
        const Vec3 from = far * test::inCube(random);
        Vec3 direction = test::inCube(random) - from;
        if (i % 7 == 0) direction.y() *= 1e-5;
        if (i % 7 == 1) direction = Vec3(1e-5 * direction.x(), direction.y(), 1e-5 * direction.z());
        ray = {size * from + Vec3(0, height, 0), direction};
        middle = i % 2 == 0 ? height : 0;
    }

    std::vector<Vec3> profile;
    Ray ray;
    Real middle;
};

TEST(RevolvedSegment, EquationIsTheLinesDistanceAgainstTheProfiles) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const EquationCase one(i);
        const BezierCurve profile(one.profile);
        const AxisRay ray(one.ray, one.middle);
        const RevolvedSegment::Equation f = RevolvedSegment(profile).equation(ray);
        ASSERT_EQ(f.degree, 2 * profile.degree());
        const ExactEquation exact(profile, ray);
        for (std::size_t k = 0; k < exact.coefficient.size(); ++k) {
            ASSERT_LE(exact.offOf(f, k), 1e-13 * exact.terms)
                << "Line " << i << ", coefficient " << k
                << ": are the segment's heights counted from its middle, the line's from its base, and is each of the "
                   "five terms there?";
        }
    }
}

// A wrong coefficient is what the test above looks for; here it is whether a right one's error is told.
TEST(RevolvedSegment, EquationsErrorIsBoundedAndSmall) {
    constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const EquationCase one(i);
        const BezierCurve profile(one.profile);
        const AxisRay ray(one.ray, one.middle);
        const RevolvedSegment::Equation f = RevolvedSegment(profile).equation(ray);
        const ExactEquation exact(profile, ray);
        for (std::size_t k = 0; k < exact.coefficient.size(); ++k) {
            const Real off = exact.offOf(f, k);
            if (off > 1e-13 * exact.terms) continue;
            ASSERT_LE(off, f.error) << "Line " << i << ", coefficient " << k
                                    << ": which terms can be larger than their sum, and are they all in the bound?";
        }
        ASSERT_LE(f.error, 100 * (profile.degree() + 1) * unitRoundoff * exact.terms)
            << "Line " << i << ": does the bound grow with the terms, or is it a guess?";
    }
}

}  // namespace
}  // namespace caustic
