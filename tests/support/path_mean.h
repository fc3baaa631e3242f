#pragma once

#include <cstdint>

#include "integrator/integrator.h"

namespace caustic::test {

/// A mean of independent paths, and how sure it is.
struct PathMean {
    Real mean = 0;
    Real standardError = 0;
};

/// What pixel (0, 0) shows, from the first `paths` paths of it, splats included: mean over the paths of the first
/// channel.
PathMean meanOfPaths(const Integrator& integrator, std::int64_t paths);

}  // namespace caustic::test
