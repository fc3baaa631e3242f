#include <gtest/gtest.h>

#include "foggy_agreement.h"

namespace caustic {
namespace {

// Light that is scattered many times: path tracing by free flight, and photons gathered along rays, with direct light
// by equi-angular sampling and as photons, agree block by block. large_volume_agreement.cpp does more of it.
TEST(VolumeAgreement, PhotonsMeetPaths) {
    for (const MediumDirect direct : {MediumDirect::EquiAngular, MediumDirect::Photons}) {
        std::vector<test::AgreementMethod> two = test::foggyMethods(direct);
        two.erase(two.begin() + 1);
        const test::Agreement agreement = test::compareMethods({test::foggyScenes().front()}, two, 24, 1, 2);
        EXPECT_TRUE(agreement.agrees()) << agreement.worst << ": |t| " << agreement.largestT << ", variance "
                                        << agreement.variance << ", means " << agreement.largestMeanT;
        EXPECT_EQ(agreement.badSamples, 0);
        EXPECT_LE(agreement.largestError, 0.04) << "too few paths to say anything";
    }
}

}  // namespace
}  // namespace caustic
