#include <gtest/gtest.h>

#include <cstdio>

#include "foggy_agreement.h"

namespace caustic {
namespace {

void expectAgreement(std::size_t scene, MediumDirect direct, std::int64_t samples) {
    const test::Agreement agreement =
        test::compareMethods({test::foggyScenes()[scene]}, test::foggyMethods(direct), 64, samples, 2);
    std::printf(
        "%d comparisons, largest |t| %.2f of %.2f, variance %.2f of %.2f ± %.2f, means %.2f standard errors apart, of "
        "%.2f %% at most\n",
        agreement.comparisons, agreement.largestT, agreement.mostT, agreement.variance, agreement.expectedVariance,
        agreement.varianceBand, agreement.largestMeanT, 100 * agreement.largestError);
    EXPECT_EQ(agreement.comparisons, 3 * 9);
    EXPECT_TRUE(agreement.agrees()) << agreement.worst;
    EXPECT_EQ(agreement.badSamples, 0);
    EXPECT_LE(agreement.largestError, 0.02) << "too few paths to say anything";
}

// Path tracing, bidirectional path tracing and photons, 64 batches each, all pairs, block by block.
TEST(LargeVolumeAgreement, MirrorInFog) { expectAgreement(0, MediumDirect::EquiAngular, 2); }
TEST(LargeVolumeAgreement, MirrorInFogByPhotonsAlone) { expectAgreement(0, MediumDirect::Photons, 2); }
TEST(LargeVolumeAgreement, GlassInFog) { expectAgreement(1, MediumDirect::EquiAngular, 2); }

// The power of it: photons that are a tenth too bright are found.
TEST(LargeVolumeAgreement, ATenthTooBrightIsFound) {
    std::vector<test::AgreementMethod> methods = test::foggyMethods(MediumDirect::EquiAngular);
    methods.back() = test::brightened(methods.back(), 0.1);
    EXPECT_FALSE(test::compareMethods({test::foggyScenes().front()}, methods, 64, 1, 2).agrees());
}

}  // namespace
}  // namespace caustic
