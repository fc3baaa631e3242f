#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/random.h"
#include "material/dielectric_bsdf.h"
#include "material/fresnel.h"

namespace caustic {
namespace {

ShadingFrame boundary(Real ior) {
    ShadingFrame shading;
    shading.iorBelow = ior;
    return shading;
}

Vec3 at(Real cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

// The lobe that stays, or the one that goes through, in energy.
std::optional<BsdfSample> lobe(const Bsdf& glass, const Vec3& wo, bool transmits) {
    for (const BsdfSample& one : glass.deltaLobes(wo, TransportMode::Importance))
        if (one.transmits() == transmits) return one;
    return std::nullopt;
}

// A pane has two boundaries. What enters goes to and fro between them, and a share leaves each time:
// T = t t' (1 + r'² + r'⁴ + …) = (1 − R)/(1 + R). Source: the sum of a geometric series.
TEST(Glass, APaneTransmitsTheSumOfAllReflections) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(1, {i});
        const Real ior = random.uniform(1.1, 2.5);
        const Real cosine = i == 0 ? 1 : random.uniform(0.01, 1);
        const DielectricBsdf glass(boundary(ior));
        const auto in = lobe(glass, at(cosine), true);
        ASSERT_TRUE(in) << "Into the denser medium there always is a way.";
        // Within the pane, wo is where the light came from: back along the way in.
        const auto out = lobe(glass, in->wi, true);
        const auto back = lobe(glass, in->wi, false);
        ASSERT_TRUE(out && back);
        const Real through = in->f.x() * out->f.x() / (1 - back->f.x() * back->f.x());
        const Real r = fresnelDielectric(cosine, ior);
        EXPECT_NEAR(through, (1 - r) / (1 + r), 1e-9) << "Does what is reflected lack in what goes through?";
    }
}

TEST(Glass, LobesAreChosenAsOftenAsTheyAreBright) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(2, {i});
        const Real ior = random.uniform(1.1, 2.5);
        const Real cosine = random.uniform(0.01, 1);
        const DielectricBsdf glass(boundary(ior));
        const Real r = fresnelDielectric(cosine, ior);
        const auto stays = lobe(glass, at(cosine), false);
        const auto passes = lobe(glass, at(cosine), true);
        ASSERT_TRUE(stays && passes);
        EXPECT_NEAR(stays->pdfW, r, 1e-12) << "Is pdfW the probability of the lobe?";
        EXPECT_NEAR(passes->pdfW, 1 - r, 1e-12) << "Is pdfW the probability of the lobe?";
    }
}

// From inside and aslant, all light stays, and goes into the mirror direction.
TEST(Glass, NothingIsLostBeyondTheCriticalAngle) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(3, {i});
        const Real ior = random.uniform(1.1, 2.5);
        const Real critical = std::sqrt(1 - 1 / (ior * ior));
        const Vec3 wo = at(-random.uniform(0, 0.999 * critical));
        const DielectricBsdf glass(boundary(ior));
        const auto stays = lobe(glass, wo, false);
        ASSERT_TRUE(stays) << "Where does the light go that cannot get out?";
        EXPECT_EQ(stays->f.x(), 1);
        EXPECT_LE((stays->wi - Vec3(-wo.x(), 0, wo.z())).norm(), 1e-12) << "The mirror direction?";
        EXPECT_FALSE(lobe(glass, wo, true));
    }
}

}  // namespace
}  // namespace caustic
