#include <gtest/gtest.h>

#include "support/agreement.h"

namespace caustic {
namespace {

// Path tracing, light tracing and bidirectional path tracing share little but the scene; large_agreement.cpp does the
// same with a hundred times the paths.
TEST(Agreement, MethodsMeetBlockByBlock) {
    const test::Agreement agreement = test::compareMethods(test::agreementScenes(), test::agreementMethods(), 64, 1, 2);
    EXPECT_EQ(agreement.comparisons, 5 * 3 * 9);
    EXPECT_LE(agreement.largestT, agreement.mostT) << agreement.worst;
    EXPECT_NEAR(agreement.variance, agreement.expectedVariance, agreement.varianceBand) << agreement.worst;
    EXPECT_LE(agreement.largestMeanT, 5) << agreement.worst;
    EXPECT_EQ(agreement.badSamples, 0);
    EXPECT_LE(agreement.largestError, 0.015) << "too few paths to say anything";
}

// The power of that test: one method that is a tenth too bright is found.
TEST(Agreement, OneMethodThatIsTooBrightIsFound) {
    for (std::size_t i = 0; i < test::agreementMethods().size(); ++i) {
        std::vector<test::AgreementMethod> methods = test::agreementMethods();
        methods[i] = test::brightened(methods[i], 0.1);
        const std::vector<test::AgreementScene> box = {test::agreementScenes().front()};
        EXPECT_FALSE(test::compareMethods(box, methods, 64, 1, 2).agrees()) << methods[i].name;
    }
}

}  // namespace
}  // namespace caustic
