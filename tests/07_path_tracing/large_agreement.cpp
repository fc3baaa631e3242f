#include <gtest/gtest.h>

#include <cstdio>

#include "support/agreement.h"

namespace caustic {
namespace {

constexpr int batches = 64;

// All five together trace more than 10⁸ paths, none of which may bring what is no finite number.
// Standard errors of whole pictures of 0.1 % at most; the number of paths is chosen for the noisiest pair.
void expectAgreement(std::size_t scene, std::int64_t samples) {
    const std::vector<test::AgreementScene> one = {test::agreementScenes()[scene]};
    const test::Agreement agreement = test::compareMethods(one, test::agreementMethods(), batches, samples, 2);
    std::printf(
        "%s: %d comparisons, largest |t| %.2f of %.2f, variance %.2f of %.2f ± %.2f, means %.2f standard "
        "errors apart, of %.3f %% at most; %lld of %lld paths not finite\n",
        one.front().name.c_str(), agreement.comparisons, agreement.largestT, agreement.mostT, agreement.variance,
        agreement.expectedVariance, agreement.varianceBand, agreement.largestMeanT, 100 * agreement.largestError,
        static_cast<long long>(agreement.badSamples), static_cast<long long>(agreement.samples));
    EXPECT_EQ(agreement.badSamples, 0);
    EXPECT_LE(agreement.largestT, agreement.mostT) << agreement.worst;
    EXPECT_NEAR(agreement.variance, agreement.expectedVariance, agreement.varianceBand) << agreement.worst;
    EXPECT_LE(agreement.largestMeanT, 5) << agreement.worst;
    EXPECT_LE(agreement.largestError, 1e-3) << agreement.worst;
}

TEST(LargeAgreement, DiffuseBox) { expectAgreement(0, 12); }
TEST(LargeAgreement, SmoothNormals) { expectAgreement(1, 18); }
TEST(LargeAgreement, GlassBall) { expectAgreement(2, 44); }
TEST(LargeAgreement, PointLamp) { expectAgreement(3, 22); }
TEST(LargeAgreement, Glossy) { expectAgreement(4, 20); }

// The power: a method that is one percent too bright is found.
TEST(LargeAgreement, OnePercentIsFound) {
    std::vector<test::AgreementMethod> methods = test::agreementMethods();
    methods.back() = test::brightened(methods.back(), 0.01);
    const std::vector<test::AgreementScene> box = {test::agreementScenes().front()};
    EXPECT_FALSE(test::compareMethods(box, methods, batches, 12, 2).agrees());
}

}  // namespace
}  // namespace caustic
