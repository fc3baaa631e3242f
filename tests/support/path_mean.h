#pragma once

#include <cstdint>

#include "integrator/integrator.h"

namespace caustic::test {

/// A mean of independent rounds of paths, and how sure it is.
struct PathMean {
    Real mean = 0;
    Real standardError = 0;
};

/// What the first channel of pixel (0, 0) shows, splats included, with a standard error of about `wanted` or less, from
/// at least 320 rounds: Student's t of so many passes 5 with a probability below 1e-6. How many rounds it takes is
/// found by a trial that doesn't count itself, so that stopping isn't chosen by what is measured. Rounds have to be
/// independent of each other: of a StratifiedSampler with n cells an axis, n² paths in a row are a round.
PathMean meanOfRounds(const Integrator& integrator, int pathsPerRound, Real wanted);

}  // namespace caustic::test
