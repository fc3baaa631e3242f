#include <gtest/gtest.h>

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

// At normal incidence ∫ (n + 2)/(2π) cosⁿα cos θ dω = 1, and ∫ cos θ / π dω = 1: both shares come back.
TEST(Phong, SharesComeBackAtNormalIncidence) {
    const PhongBsdf phong({}, Color(0.3, 0, 0.2), Color(0.5, 0.5, 0), 10);
    Color sum = Color::Zero();
    constexpr int rings = 2000;
    for (int i = 0; i < rings; ++i) {
        const Vec3 wi = direction((i + 0.5) / rings, 1);
        sum += phong.f(Vec3::UnitZ(), wi, TransportMode::Radiance) * wi.z() * 2 * pi / rings;
    }
    EXPECT_NEAR(sum.x(), 0.8, 1e-5) << "Are both lobes there, each with its factor?";
    EXPECT_NEAR(sum.y(), 0.5, 1e-5) << "Which power of the cosine is integrated?";
    EXPECT_NEAR(sum.z(), 0.2, 1e-5);
}

// Aslant the highlight is where a mirror would send the light.
TEST(Phong, HighlightIsBrightestInTheMirrorDirection) {
    const PhongBsdf phong({}, Color::Zero(), Color::Ones(), 30);
    const Vec3 wo = direction(0.6, 2);
    const Real top = phong.f(wo, reflected(wo, Vec3::UnitZ()), TransportMode::Radiance).x();
    for (int i = 0; i < 400; ++i) {
        const Vec3 wi = direction((i / 20 + 0.5) / 20, 2 * pi * (i % 20) / 20);
        EXPECT_LE(phong.f(wo, wi, TransportMode::Radiance).x(), top) << "Around which direction does it shine?";
    }
}

TEST(Phong, NothingComesThroughTheSurface) {
    const PhongBsdf phong({}, Color::Constant(0.5), Color::Constant(0.5), 1);
    EXPECT_EQ(phong.f(direction(0.3, 0), direction(-0.5, pi), TransportMode::Radiance).x(), 0)
        << "On which side is wi?";
}

}  // namespace
}  // namespace caustic
