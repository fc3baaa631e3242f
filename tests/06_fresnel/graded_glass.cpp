#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/random.h"
#include "material/dielectric_bsdf.h"
#include "material/directions.h"
#include "material/fresnel.h"

namespace caustic {
namespace {

ShadingFrame boundary(Real ior) {
    ShadingFrame shading;
    shading.iorBelow = ior;
    return shading;
}

Vec3 at(Real cosine, Real angle = 0) {
    const Real r = std::sqrt(1 - cosine * cosine);
    return {r * std::cos(angle), r * std::sin(angle), cosine};
}

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
        EXPECT_NEAR(in->f.x(), in->f.y(), 1e-15) << "Glass has no colour of its own.";
        EXPECT_NEAR(in->f.x(), in->f.z(), 1e-15) << "Glass has no colour of its own.";
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
    // Between two media of one index nothing is reflected: a lobe that is never chosen is none.
    const DielectricBsdf none(boundary(1));
    EXPECT_EQ(none.deltaLobes(at(0.4), TransportMode::Importance).count, 1) << "Is there a lobe without light?";
}

// From both sides and all around, each lobe goes where light goes, and says so: into the mirror direction, by Snell's
// law to the other side, with the index that it finds there. Where the normals of a smooth mesh disagree about the side
// that it is seen from there is no direction to go to.
TEST(Glass, LobesGoWhereLightGoes) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(4, {i});
        const Real ior = random.uniform(1.1, 2.5);
        const Real side = i % 2 == 0 ? 1 : -1;
        const Vec3 wo = side * at(random.uniform(side > 0 ? 0.01 : 0.95, 1), static_cast<Real>(i));
        const DielectricBsdf glass(boundary(ior));
        const auto stays = lobe(glass, wo, false);
        const auto passes = lobe(glass, wo, true);
        ASSERT_TRUE(stays && passes);
        EXPECT_LE((stays->wi - Vec3(-wo.x(), -wo.y(), wo.z())).norm(), 1e-12) << "The mirror direction?";
        const Real eta = side > 0 ? ior : 1 / ior;
        const Real sideways = std::sqrt(1 - (1 - wo.z() * wo.z()) / (eta * eta));
        EXPECT_LE((passes->wi - Vec3(-wo.x() / eta, -wo.y() / eta, -side * sideways)).norm(), 1e-12) << "Snell's law?";
        EXPECT_NEAR(stays->eta, 1, 1e-15) << "Which index does reflected light find?";
        EXPECT_NEAR(passes->eta, eta, 1e-15) << "Which index does refracted light find?";
        EXPECT_EQ(stays->lobes, LobeFlags::Delta | LobeFlags::Reflection) << "What does the lobe say of itself?";
        EXPECT_EQ(passes->lobes, LobeFlags::Delta | LobeFlags::Transmission) << "What does the lobe say of itself?";
    }
    ShadingFrame smooth = boundary(1.5);
    smooth.frame = Frame::around(Vec3(0.6, 0, 0.8));
    const DielectricBsdf glass(smooth);
    const Vec3 behind = Vec3(-0.95, 0, 0.2).normalized();
    EXPECT_EQ(glass.deltaLobes(behind, TransportMode::Radiance).count, 0) << "On which side of ns is wo?";
}

// From inside and aslant, all light stays, and goes into the mirror direction; from outside it does along the surface.
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
        // At the angle itself, a few roundings up and down.
        Real near = critical;
        for (int k = 0; k < 8; ++k) near = std::nextafter(near, 0.0);
        for (int k = 0; k < 16; ++k) {
            near = std::nextafter(near, 1.0);
            const DeltaLobes lobes = glass.deltaLobes(at(-near), TransportMode::Importance);
            const bool through = refracted(at(near), Vec3::UnitZ(), 1 / ior).has_value();
            ASSERT_GE(lobes.count, 1) << "Is anything lost at the critical angle?";
            ASSERT_TRUE(through || lobes.count == 1) << "Where does the light go if refracted has no answer?";
        }
    }
    const auto along = DielectricBsdf(boundary(1.5)).deltaLobes(Vec3::UnitY(), TransportMode::Importance);
    ASSERT_EQ(along.count, 1) << "Which light is left along the surface?";
    EXPECT_EQ(along.lobe[0].f.x(), 1);
    EXPECT_FALSE(along.lobe[0].transmits());
}

}  // namespace
}  // namespace caustic
