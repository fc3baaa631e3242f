#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "figure/figure.h"
#include "math/real.h"

namespace caustic {

/// How far off path tracing with one of the samplers was after so many paths a pixel.
struct SamplerPoint {
    std::string scene;    ///< "smooth" or "caustic"
    std::string sampler;  ///< one of samplerNames()
    std::int64_t samples = 0;
    double seconds = 0;  ///< of one thread's computing time
    Real error = 0;      ///< RMSE against what shares no code with it, over several seeds
};

/// Points of all samplers on the smooth floor, and on chapter 07's caustic.
std::vector<SamplerPoint> samplerPoints(FigureContext& context);

/// The power of the number of samples with which a sampler's error goes: least squares of log error over log samples.
Real slopeOf(const std::vector<SamplerPoint>& points, const std::string& scene, const std::string& sampler);

}  // namespace caustic
