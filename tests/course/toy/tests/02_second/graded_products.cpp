#include <gtest/gtest.h>

#include "math/products.h"

namespace caustic {
namespace {

TEST(Products, WeightsMultiplyValues) {
    EXPECT_EQ(weightedTotal({1, 2, 3}, {1, 10, 100}), 321) << "Which weight belongs to which value?";
}

}  // namespace
}  // namespace caustic
