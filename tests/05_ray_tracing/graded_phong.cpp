#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "material/directions.h"
#include "material/phong_bsdf.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;

Vec3 direction(Real z, Real angle) {
    const Real r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

// At normal incidence ∫ (n + 2)/(2π) cosⁿα cos θ dω = 1, and ∫ cos θ / π dω = 1: both shares come back. Without a
// highlight f is the same everywhere.
TEST(Phong, SharesComeBackAtNormalIncidence) {
    for (const Real exponent : {0.5, 10.0, 47.0}) {
        const PhongBsdf phong({}, Color(0.3, 0, 0.2), Color(0.5, 0.4, 0), exponent);
        Color sum = Color::Zero();
        constexpr int rings = 2000;
        for (int i = 0; i < rings; ++i) {
            const Vec3 wi = direction((i + 0.5) / rings, 1);
            sum += phong.f(Vec3::UnitZ(), wi, TransportMode::Radiance) * wi.z() * 2 * pi / rings;
        }
        EXPECT_NEAR(sum.x(), 0.8, 5e-5) << "Are both lobes there, each with its factor?";
        EXPECT_NEAR(sum.y(), 0.4, 5e-5) << "Which power of the cosine is integrated?";
        EXPECT_NEAR(sum.z(), 0.2, 1e-12) << "Which share belongs to which lobe?";
    }
    const PhongBsdf flat({}, Color(0.3, 0.1, 0.2), Color::Zero(), 9);
    for (int i = 0; i < 100; ++i) {
        const Color f = flat.f(direction(0.4, 2), direction((i + 0.5) / 100, i), TransportMode::Radiance);
        EXPECT_LE((f * pi - Color(0.3, 0.1, 0.2)).abs().maxCoeff(), 1e-14) << "What is diffuse about it?";
    }
}

// Aslant the highlight is where a mirror would send the light, and falls with the n-th power of the cosine of the angle
// with it, the same all around; seen from anywhere.
TEST(Phong, HighlightIsBrightestInTheMirrorDirection) {
    const PhongBsdf phong({}, Color::Zero(), Color(0.9, 0.3, 0.6), 7);
    for (int k = 0; k < 12; ++k) {
        const Vec3 wo = direction((k + 0.5) / 12, 2.4 * k);
        const Vec3 mirrored(-wo.x(), -wo.y(), wo.z());
        const Color top = phong.f(wo, mirrored, TransportMode::Radiance);
        for (int i = 0; i < 400; ++i) {
            const Vec3 wi = direction((i / 20 + 0.5) / 20, 2 * pi * (i % 20) / 20);
            const Color f = phong.f(wo, wi, TransportMode::Radiance);
            const Real share = std::pow(std::max(Real(0), wi.dot(mirrored)), 7);
            EXPECT_LE((f - share * top).abs().maxCoeff(), 1e-13)
                << "Around which direction does it shine, and which power?";
        }
    }
}

// Below the surface there is nothing, wherever light comes from.
TEST(Phong, NothingComesThroughTheSurface) {
    const PhongBsdf phong({}, Color::Constant(0.5), Color::Constant(0.5), 1);
    for (int i = 0; i < 40; ++i) {
        for (const Real side : {1, -1}) {
            const Vec3 wo = side * direction(0.3, i);
            const Vec3 wi = -side * direction((i + 0.5) / 40, 2.0 * i);
            EXPECT_TRUE((phong.f(wo, wi, TransportMode::Radiance) == 0).all()) << "On which side is wi?";
            const Vec3 along(std::cos(i), std::sin(i), 0);
            EXPECT_TRUE((phong.f(wo, along, TransportMode::Radiance) == 0).all())
                << "Is a wi along the surface above it?";
        }
    }
}

}  // namespace
}  // namespace caustic
