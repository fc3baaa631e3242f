#include <gtest/gtest.h>

#include "material/fresnel.h"

namespace caustic {
namespace {

// At normal incidence R = ((1 - eta) / (1 + eta))².
TEST(Fresnel, NormalIncidence) { EXPECT_NEAR(fresnelDielectric(1, 1.5), 0.04, 1e-15); }

}  // namespace
}  // namespace caustic
