#include <gtest/gtest.h>

#include <cmath>

#include "material/rough_conductor_bsdf.h"
#include "support/bsdf_cases.h"
#include "support/bsdf_checks.h"
#include "support/direction_chi_square.h"

namespace caustic {
namespace {

constexpr double falseAlarm = 1e-6;
constexpr int samples = 600'000;

// As in property_bsdf.cpp, with enough samples to see 3 percent.
void expectTheDensity(const std::vector<test::BsdfCase>& cases) {
    std::uint64_t seed = 1000;
    for (const test::BsdfCase& one : cases)
        EXPECT_GT(test::bsdfProbability(*one.bsdf, one.shading, one.wo, samples, ++seed), falseAlarm) << one.name;
}

TEST(BsdfDensity, EarlierModelsFinely) { expectTheDensity(test::earlierBsdfCases()); }
TEST(BsdfDensity, RoughConductorsFinely) { expectTheDensity(test::roughConductorCases()); }
TEST(BsdfDensity, RoughBubblesFinely) { expectTheDensity(test::roughDielectricCases(0.6)); }
TEST(BsdfDensity, RoughOilFinely) { expectTheDensity(test::roughDielectricCases(1.1)); }
TEST(BsdfDensity, RoughGlassFinely) { expectTheDensity(test::roughDielectricCases(1.5)); }
TEST(BsdfDensity, RoughDiamondFinely) { expectTheDensity(test::roughDielectricCases(2.4)); }

TEST(BsdfDensity, AnOctantWrongByThreePercentIsSeen) {
    Random random(1, {});
    const ShadingFrame shading = test::anyPlace(random, false, 1);
    const RoughConductorBsdf metal(shading, Metal::gold(), Ggx(0.5, 0.5));
    const Vec3 wo = shading.frame.toWorld(Vec3(0.02, 0.03, 1).normalized());
    const Frame axes = {shading.frame.n, shading.frame.s, shading.frame.t};
    for (int octant = 0; octant < 4; ++octant) {
        for (const Real factor : {0.97, 1.03}) {
            const auto wrong = [&](const Vec3& wi) {
                const Vec3 local = shading.frame.toLocal(wi);
                const int in = (local.x() < 0 ? 1 : 0) + (local.y() < 0 ? 2 : 0);
                return metal.pdfW(wo, wi) * (in == octant ? factor : 1);
            };
            const test::DirectionSampling sampling = {[&](const Vec2& u, Real uLobe) -> std::optional<Vec3> {
                                                          const auto sample =
                                                              metal.sample(wo, u, uLobe, TransportMode::Radiance);
                                                          if (!sample) return std::nullopt;
                                                          return sample->wi;
                                                      },
                                                      wrong};
            EXPECT_LT(test::directionProbability(sampling, samples, 3, axes), falseAlarm) << octant;
        }
    }
}

}  // namespace
}  // namespace caustic
