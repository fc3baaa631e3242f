#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "material/ggx.h"
#include "support/sphere_integral.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;

Real integral(const std::function<Real(const Vec3&)>& integrand) { return test::hemisphereIntegral(integrand, 0); }

// The distribution in another form: by the tangent and the angle of the normal. Source: Walter 2007, eq. 33.
Real byTangent(const Vec3& wm, Real alphaX, Real alphaY) {
    const Real cosine = wm.z();
    const Real tangentSquared = (1 - cosine * cosine) / (cosine * cosine);
    const Real angle = std::atan2(wm.y(), wm.x());
    const Real along = std::cos(angle) / alphaX;
    const Real across = std::sin(angle) / alphaY;
    const Real steep = 1 + tangentSquared * (along * along + across * across);
    return 1 / (pi * alphaX * alphaY * std::pow(cosine, 4) * steep * steep);
}

Vec3 direction(Real cosine, Real angle) {
    const Real r = std::sqrt(1 - cosine * cosine);
    return {r * std::cos(angle), r * std::sin(angle), cosine};
}

// Seen from far above, the facets cover the surface, whatever their roughness: ∫ D(wm) wm.z dwm = 1.
TEST(Ggx, FacetsCoverTheSurface) {
    for (const auto& [x, y] : {std::pair(0.3, 0.3), std::pair(0.2, 0.9), std::pair(1.0, 0.4)}) {
        const Ggx facets(x, y);
        EXPECT_NEAR(integral([&](const Vec3& wm) { return facets.D(wm) * wm.z(); }), 1, 1e-5)
            << "Which factor keeps the area when facets are stretched along x and along y?";
    }
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(Ggx(0.5, 0.2).D(direction(-i / 20.0, i)), 0) << "No facet faces down, and none aside.";
}

// How steep facets are along x, compared to how steep they are along y: as a ratio, so that no factor counts.
TEST(Ggx, EachTangentHasItsRoughness) {
    const Ggx facets(0.1, 0.5);
    for (const Real cosine : {0.95, 0.7, 0.2}) {
        const Vec3 alongX = direction(cosine, 0);
        const Vec3 alongY = direction(cosine, pi / 2);
        const Real expected = byTangent(alongX, 0.1, 0.5) / byTangent(alongY, 0.1, 0.5);
        EXPECT_NEAR(facets.D(alongX) / facets.D(alongY), expected, 1e-9 * expected)
            << "Which roughness belongs to which tangent?";
        for (int i = 0; i < 24; ++i) {
            const Vec3 wm = direction(cosine, i);
            const Real turned = byTangent(wm, 0.1, 0.5) / byTangent(alongY, 0.1, 0.5);
            EXPECT_NEAR(facets.D(wm) / facets.D(alongY), turned, 1e-9 * turned) << "And between the tangents?";
        }
    }
}

// What is seen of the facets fills the view: G1(w) ∫ D(wm) (w · wm)⁺ dwm = w.z. Source: Heitz 2014, eq. 14.
TEST(Ggx, WhatIsSeenFillsTheView) {
    for (const Real alpha : {0.3, 1.0}) {
        const Ggx facets(alpha, alpha);
        EXPECT_NEAR(facets.lambda(Vec3::UnitZ()), 0, 1e-15) << "From above, everything is seen.";
        for (const Real cosine : {0.9, 0.5, 0.1}) {
            const Vec3 w = direction(cosine, 0.7);
            const Real facing =
                integral([&](const Vec3& wm) { return byTangent(wm, alpha, alpha) * std::max(Real(0), w.dot(wm)); });
            EXPECT_NEAR(facing / (1 + facets.lambda(w)), cosine, 1e-4) << "How much hides behind other facets?";
            // Λ (Λ + 1) = (α tan θ / 2)², of one roughness.
            const Real lambda = facets.lambda(w);
            const Real tangent = std::sqrt(1 - cosine * cosine) / cosine;
            EXPECT_NEAR(lambda * (lambda + 1) / std::pow(alpha * tangent / 2, 2), 1, 1e-12)
                << "How much hides behind other facets, to the last digits?";
        }
        EXPECT_EQ(facets.lambda(Vec3::UnitX()), std::numeric_limits<Real>::infinity()) << "And along the surface?";
    }
}

// Seen along y, only the slopes along y count; and from below as much is hidden as from above.
TEST(Ggx, HidesByTheRoughnessAlongTheView) {
    const Ggx facets(0.2, 0.8);
    for (const Real cosine : {0.9, 0.5, 0.1}) {
        EXPECT_NEAR(facets.lambda(direction(cosine, 0)), Ggx(0.2, 0.2).lambda(direction(cosine, 2)), 1e-12);
        EXPECT_NEAR(facets.lambda(direction(cosine, pi / 2)), Ggx(0.8, 0.8).lambda(direction(cosine, 2)), 1e-12)
            << "Along y, alphaY?";
        EXPECT_NEAR(facets.lambda(direction(-cosine, 1)), facets.lambda(direction(cosine, 1)), 1e-12) << "From below?";
        for (int i = 0; i < 24; ++i) {
            const Real alpha = std::hypot(0.2 * std::cos(i), 0.8 * std::sin(i));
            EXPECT_NEAR(facets.lambda(direction(cosine, i)), Ggx(alpha, alpha).lambda(direction(cosine, 2)), 1e-12)
                << "And between the tangents?";
        }
    }
}

// Visible normals have the density D(wm) (wo · wm)⁺ up to a factor: means of functions of wm, sampled and by
// quadrature, within 5.5 standard errors. Each is unit, faces up and is seen, whatever the numbers.
TEST(Ggx, VisibleFacetsTiltTowardsTheEye) {
    constexpr int n = 40'000;
    const std::function<Real(const Vec3&)> functions[] = {
        [](const Vec3& wm) { return wm.x(); },          [](const Vec3& wm) { return wm.y(); },
        [](const Vec3& wm) { return wm.x() * wm.x(); }, [](const Vec3& wm) { return wm.y() * wm.y(); },
        [](const Vec3& wm) { return wm.x() * wm.y(); }, [](const Vec3& wm) { return wm.z(); }};
    for (const auto& [x, y] : {std::pair(0.4, 0.4), std::pair(0.2, 0.8)}) {
        const Ggx facets(x, y);
        for (const Vec3& wo : {direction(1, 0.5), direction(0.6, 0.5), direction(0.15, 2.5), direction(0.4, -1)}) {
            const auto weight = [&, ax = x, ay = y](const Vec3& wm) {
                return byTangent(wm, ax, ay) * std::max(Real(0), wo.dot(wm));
            };
            const Real all = integral(weight);
            std::vector<Vec3> normals;
            for (int i = 0; i < n; ++i) {
                Random random(1, {static_cast<std::uint64_t>(i)});
                const Real first = random.uniform();
                normals.push_back(facets.sampleVisible(wo, {first, random.uniform()}));
            }
            for (const auto& function : functions) {
                const Real truth = integral([&](const Vec3& wm) { return weight(wm) * function(wm); }) / all;
                Real sum = 0;
                Real squares = 0;
                for (const Vec3& wm : normals) {
                    sum += function(wm);
                    squares += function(wm) * function(wm);
                }
                const Real mean = sum / n;
                const Real error = std::sqrt(std::max(0.0, squares / n - mean * mean) / n);
                EXPECT_NEAR(mean, truth, 5.5 * error + 1e-4)
                    << "wo " << wo.transpose() << ": Is wo stretched, too? And the normal turned back?";
            }
            for (const Real first : {0.0, 0.3, 1 - 0x1p-53}) {
                for (const Real second : {0.0, 0.6, 1 - 0x1p-53})
                    normals.push_back(facets.sampleVisible(wo, {first, second}));
            }
            for (const Vec3& wm : normals) {
                ASSERT_NEAR(wm.norm(), 1, 1e-12) << "How long is the normal?";
                ASSERT_GT(wm.z(), 0) << "Does it face up?";
                ASSERT_GT(wo.dot(wm), -1e-7) << "Does the eye see it?";
            }
        }
    }
}

}  // namespace
}  // namespace caustic
