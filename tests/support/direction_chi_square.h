#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "math/vector.h"

namespace caustic::test {

/// A way to pick directions, and the density over solid angle that it claims. Samples may fail: what the density lacks
/// to an integral of 1 is how often they should.
struct DirectionSampling {
    std::function<std::optional<Vec3>(const Vec2& u, Real uLobe)> sample;
    std::function<Real(const Vec3& direction)> pdfW;
};

/// Probability that directions with the claimed density fall into the cells of the sphere (24 bands of z, 48 of angle)
/// at least as unevenly as sampled ones do. Reject below 1e-6.
double directionProbability(const DirectionSampling& sampling, int samples, std::uint64_t seed);

}  // namespace caustic::test
