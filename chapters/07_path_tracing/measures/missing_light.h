#pragma once

#include <cstdint>
#include <vector>

#include "figure/figure.h"
#include "methods.h"

namespace caustic {

/// How much of a picture's light a method cannot make.
struct MissingLight {
    Method method;
    Real percent = 0;  ///< of the converged picture's light
};

/// The caustic before a mirror, under a point lamp. No path finds a point by chance; so each method misses whole path
/// classes: path tracing L S⁺ D E, light tracing L … D S⁺ E, bidirectional path tracing L S⁺ D S⁺ E. The converged
/// picture has a small ball in the lamp's place, of the same intensity, which paths do hit; the ball's own image, which
/// no method shows of a point, is left out.
/// @param samples  paths a pixel of the converged picture; the methods take a quarter of it each
std::vector<MissingLight> missingLight(std::int64_t samples, FigureContext& context);

}  // namespace caustic
