#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "math/frame.h"
#include "math/vector.h"

namespace caustic::test {

/// A way to pick directions, and the density over solid angle that it claims. Samples may fail: what the density lacks
/// to an integral of 1 is how often they should.
struct DirectionSampling {
    std::function<std::optional<Vec3>(const Vec2& u, Real uLobe)> sample;
    std::function<Real(const Vec3& direction)> pdfW;
};

/// Probability that directions with the claimed density fall into the cells of the sphere (24 bands of z, 48 of angle)
/// at least as unevenly as sampled ones do, or into its octants. Reject below 1e-6. It is 0 for a density that sums to
/// more than 1.001.
/// @param samples  the more, the finer: 60,000 see a density that is wrong by 10 % in one octant, 600,000 one by 3 %
/// @param axes     of the cells; where a density ends at a plane, that plane should be x = 0; peaks shouldn't be at ±z
double directionProbability(const DirectionSampling& sampling, int samples, std::uint64_t seed, const Frame& axes = {});

}  // namespace caustic::test
