#pragma once

#include "sampling/sampler.h"

namespace caustic {

/// Owen-scrambled Sobol points for the dimensions that matter most, plain random numbers for the rest.
///
/// Sobol's six dimensions, jointly, are where a path starts and where it goes first: film and lens, or place and
/// direction of emission, and the direction at vertex 0. The point on the light that vertex 0 asks for, which only
/// paths from the eye take, and the single choices at vertex 0, of a light and of a lobe, come from the first two
/// dimensions once more, in an order of their own. Each pixel and each stream is scrambled by itself: its paths are
/// spread evenly by their index, those of different pixels are independent.
class SobolSampler final : public Sampler {
public:
    /// @param seed  of everything
    explicit SobolSampler(std::uint64_t seed) : seed_(seed) {}

    Real number(const PathName& path, Dimension dimension) const override;
    Vec2 pair(const PathName& path, Dimension dimension) const override;

private:
    std::uint64_t seed_;
};

}  // namespace caustic
