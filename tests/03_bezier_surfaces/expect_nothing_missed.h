#pragma once

#include <gtest/gtest.h>

#include <string>

#include "failures/root_examination.h"

namespace caustic::test {

/// Fails unless every meeting of a set of rays was found, none was invented, and each is where it should be.
/// The reference shares no code with the library: see revolution_reference.h and patch_reference.h.
inline void expectNothingMissed(const RootExamination& count, const std::string& set) {
    SCOPED_TRACE(set);
    EXPECT_EQ(count.misses, 0) << "of " << count.meetings << " meetings";
    EXPECT_EQ(count.falseHits, 0);
    EXPECT_EQ(count.nearest.front().failures, 0) << "of " << count.nearest.front().trials;
    EXPECT_LE(count.worstDistance, 1e-12) << "of the size, inside the band of tangency too";
}

}  // namespace caustic::test
